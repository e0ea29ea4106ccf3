// The exact and lossless format: JSON with one cell per line and coordinates as fractions.
//
// {
//   "format": "cnrg result", "version": 1, "node": name, "group": true | false, "dominance": fraction of a group,
//   "leaves": [{"name"}],
//   "materials": [{"name", "color"}],
//   "components": [{"name", "material", "dominance", "leaves": [leaf]}],   component i is at [i - 1]
//   "points": [[x, y, z]],                                           strings `p` or `p/q`, sorted
//   "frame": [point],                                                points that stand for infinity
//   "vertices": [{"point", "component", "origin", ...}],
//   "edges": [{"points": [point], "closed", "component", "origin", ...}],
//   "faces": [{"loops": [[point]], "component", "regions": [front, back], "patch", "triangles", "origin", ...}],
//   "regions": [{"component", "bounded", "shells": [[{"face", "side"}]], "volume", "origin", ...}]
// }
// A component of 0 says that the cell is not part of the result but bounds a part of it. In a group the regions
// are the components, and its faces, edges and vertices that are entities have the number after the last one;
// only components of other values have a dominance each. `entity` is false for cells that are only the interior
// of a region. A region that no cell lists is null. Loops have the face to the left as seen from its front: the
// outer loop of a flat face comes first and is counter-clockwise. `facets` are the planar pieces of a face that is
// not flat. Faces with the same `patch` are of one patch of a leaf.
//
// `origin` names the leaves that a cell of the result came from, and what of them holds it (boundaries included),
// over all cells that simplification united in it: [{"leaf", "faces": [...], "edges": [...], "point": true,
// "regions": [...]}], by the leaf's own numbers; what is empty is left out. Edges are wires, a point is isolated,
// regions count from 1.
#include <map>
#include <nlohmann/json.hpp>

#include "csg/output/formats.h"
#include "kernel/selection/measure.h"

namespace cnrg {
namespace {

using Json = nlohmann::ordered_json;
using Index = FlatComplex::Index;

std::string line_of(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json index_or_null(Index i) { return i == FlatComplex::kNone ? Json(nullptr) : Json(i); }

/// Numbers patches in the order in which they come; a face of no one patch is one of its own.
class PatchNumbers {
 public:
  std::size_t operator()(const std::optional<FlatComplex::Patch>& patch) {
    if (!patch) return next_++;
    const auto [it, fresh] = numbers_.try_emplace(*patch, next_);
    next_ += fresh;
    return it->second;
  }

 private:
  std::map<FlatComplex::Patch, std::size_t> numbers_;
  std::size_t next_ = 0;
};

class JsonWriter {
 public:
  explicit JsonWriter(const ResultView& view) : view_(view), flat_(flatten(view)) {}

  std::string run() {
    text_ = "{\n\"format\": \"cnrg result\",\n\"version\": 1,\n\"node\": " + line_of(view_.node) +
            ",\n\"group\": " + (view_.value->is_group() ? "true" : "false");
    if (view_.value->is_group()) {
      text_ += ",\n\"dominance\": " + line_of(to_string(view_.value->group().dominance));
    }
    leaves();
    list("materials", view_.materials, [](const auto& m) { return Json{{"name", m.name}, {"color", m.color}}; });
    if (view_.value->is_group()) {
      list("components", view_.value->group().regions, [&](const RegionAttributes& a) { return component(a); });
    } else {
      list("components", view_.value->components().attributes, [&](const ComponentAttributes& a) {
        Json result = component(a);
        result["dominance"] = to_string(a.dominance);
        return result;
      });
    }
    list("points", flat_.points, [&](VertexId v) {
      const RationalPoint p = view_.complex->points.rational(v);
      return Json{to_string(p[0]), to_string(p[1]), to_string(p[2])};
    });
    text_ += ",\n\"frame\": " + line_of(Json(flat_.frame_points));
    list("vertices", flat_.vertices, [&](const auto& v) { return vertex(v); });
    list("edges", flat_.edges, [&](const auto& e) { return edge(e); });
    list("faces", flat_.faces, [&](const auto& f) { return face(f); });
    list("regions", flat_.regions, [&](const auto& r) { return region(r); });
    return std::move(text_) + "\n}\n";
  }

 private:
  const ResultView& view_;
  FlatComplex flat_;
  std::string text_;
  std::map<LeafId, std::size_t> leaf_number_;
  PatchNumbers patches_;

  template <class Range, class Make>
  void list(const char* key, const Range& range, Make make) {
    text_ += ",\n\"" + std::string(key) + "\": [";
    const char* separator = "\n";
    for (const auto& item : range) {
      text_ += separator;
      text_ += line_of(make(item));
      separator = ",\n";
    }
    text_ += "]";
  }

  /// Leaves that the result names, numbered in the file.
  void leaves() {
    const auto see = [&](const std::vector<LeafId>& leaves) {
      for (const LeafId leaf : leaves) leaf_number_.try_emplace(leaf, 0);
    };
    for (const auto& v : flat_.vertices) see(v.origin.leaves);
    for (const auto& e : flat_.edges) see(e.origin.leaves);
    for (const auto& f : flat_.faces) see(f.origin.leaves);
    for (const auto& r : flat_.regions) see(r.origin.leaves);
    for (Component i = 1; i <= view_.value->component_count(); ++i) see(view_.value->attributes(i).leaves);
    std::size_t next = 0;
    for (auto& [leaf, number] : leaf_number_) number = next++;
    list("leaves", leaf_number_, [&](const auto& entry) {
      const bool named = view_.leaves != nullptr && entry.first.index() < view_.leaves->size();
      return Json{{"name", named ? (*view_.leaves)[entry.first.index()].name : std::string()}};
    });
  }

  Json component(const RegionAttributes& a) const {
    return {{"name", a.name}, {"material", a.material}, {"leaves", leaf_numbers(a.leaves)}};
  }

  Json leaf_numbers(const std::vector<LeafId>& leaves) const {
    Json result = Json::array();
    for (const LeafId leaf : leaves) result.push_back(leaf_number_.at(leaf));
    return result;
  }

  Json origin_of(const FlatComplex::Provenance& origin) const {
    static constexpr const char* kKeys[] = {"point", "edges", "faces", "regions"};
    Json result = Json::array();
    auto cell = origin.cells.begin();
    for (const LeafId leaf : origin.leaves) {
      Json& item = result.emplace_back(Json{{"leaf", leaf_number_.at(leaf)}});
      for (; cell != origin.cells.end() && cell->leaf == leaf; ++cell) {
        Json& list = item[kKeys[cell->dimension]];
        if (cell->dimension == 0) {
          list = true;
        } else {
          list.push_back(cell->number);
        }
      }
    }
    return result;
  }

  Json vertex(const FlatComplex::Vertex& v) const {
    Json result{{"point", v.point}, {"component", v.component}, {"entity", v.entity}, {"feature", v.feature}};
    if (v.region != FlatComplex::kNone) result["region"] = v.region;
    if (v.component != 0) result["origin"] = origin_of(v.origin);
    return result;
  }

  Json edge(const FlatComplex::Edge& e) const {
    Json result{{"points", e.points},       {"closed", e.closed},   {"component", e.component},
                {"entity", e.entity},       {"feature", e.feature}, {"wire", e.wire}};
    if (e.region != FlatComplex::kNone) result["region"] = e.region;
    if (e.component != 0) result["origin"] = origin_of(e.origin);
    return result;
  }

  Json face(const FlatComplex::Face& f) {
    Json result{{"loops", f.loops}};
    if (!f.isolated.empty()) result["isolated"] = f.isolated;
    result["component"] = f.component;
    result["entity"] = f.entity;
    result["regions"] = {index_or_null(f.regions[0]), index_or_null(f.regions[1])};
    result["patch"] = patches_(f.patch);
    if (!f.facets.empty()) {
      Json& facets = result["facets"] = Json::array();
      for (const auto& facet : f.facets) {
        Json& item = facets.emplace_back(Json{{"loops", facet.loops}});
        if (!facet.isolated.empty()) item["isolated"] = facet.isolated;
      }
    }
    result["triangles"] = f.triangles;
    if (f.component != 0) result["origin"] = origin_of(f.origin);
    return result;
  }

  Json region(const FlatComplex::Region& r) const {
    const RegionAttributes& attributes = attributes_of(view_, r.component);
    Json result{{"component", r.component}, {"name", attributes.name}, {"material", attributes.material},
                {"bounded", r.bounded}};
    const std::optional<Rational> size = r.bounded ? volume(*view_.complex, r.cells) : std::nullopt;
    result["volume"] = size ? Json(to_string(*size)) : Json(nullptr);
    Json& shells = result["shells"] = Json::array();
    for (const auto& shell : r.shells) {
      Json& sides = shells.emplace_back(Json::array());
      for (const Index side : shell) sides.push_back({{"face", side >> 1}, {"side", side & 1 ? "back" : "front"}});
    }
    if (r.component != 0) result["origin"] = origin_of(r.origin);
    return result;
  }
};

}  // namespace

FileText json_text(const ResultView& view) { return {JsonWriter(view).run(), {}}; }

}  // namespace cnrg
