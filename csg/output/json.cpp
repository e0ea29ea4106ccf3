// The exact and lossless format: JSON with one cell per line and coordinates as fractions.
//
// {
//   "format": "cnrg result", "version": 1, "node": name, "group": true | false,
//   "leaves": [{"name"}],
//   "materials": [{"name", "color"}],
//   "components": [{"name", "material", "leaves": [leaf]}],          component i is at [i - 1]
//   "points": [[x, y, z]],                                           strings `p` or `p/q`, sorted
//   "frame": [point],                                                points that stand for infinity
//   "vertices": [{"point", "component", ...}],
//   "edges": [{"points": [point], "closed", "component", ...}],
//   "faces": [{"loops": [[point]], "component", "regions": [front, back], "triangles", ...}],
//   "regions": [{"component", "bounded", "shells": [[{"face", "side"}]], "volume", ...}]
// }
// A component of 0 says that the cell is not part of the result but bounds a part of it. `entity` is false for
// cells that are only the interior of a region. A region that no cell lists is null. Loops have the face to
// the left as seen from its front: the outer loop of a flat face comes first and is counter-clockwise.
// `facets` are the planar pieces of a face that is not flat. `patch` and `surface` number the patches and the
// leaf faces that faces come from: faces with the same number were one in their leaf.
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

/// Numbers pairs in the order in which they come.
class Numbering {
 public:
  std::size_t operator()(LeafId leaf, std::uint32_t what) {
    return numbers_.try_emplace({leaf, what}, numbers_.size()).first->second;
  }

 private:
  std::map<std::pair<LeafId, std::uint32_t>, std::size_t> numbers_;
};

class JsonWriter {
 public:
  explicit JsonWriter(const ResultView& view) : view_(view), flat_(flatten(view)) {}

  std::string run() {
    text_ = "{\n\"format\": \"cnrg result\",\n\"version\": 1,\n\"node\": " + line_of(view_.node) +
            ",\n\"group\": " + (view_.value->is_group() ? "true" : "false");
    leaves();
    list("materials", view_.materials, [](const auto& m) { return Json{{"name", m.name}, {"color", m.color}}; });
    list("components", components(), [&](const RegionAttributes& a) {
      return Json{{"name", a.name}, {"material", a.material}, {"leaves", leaf_numbers(a.leaves)}};
    });
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
  Numbering patches_, surfaces_;

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
    const auto see = [&](LeafId leaf) { leaf_number_.try_emplace(leaf, 0); };
    for (const auto& v : flat_.vertices) for (const LeafId leaf : v.leaves) see(leaf);
    for (const auto& e : flat_.edges) for (const LeafId leaf : e.leaves) see(leaf);
    for (const auto& f : flat_.faces) for (const auto& s : f.sources) see(s.leaf);
    for (const auto& a : components()) for (const LeafId leaf : a.leaves) see(leaf);
    std::size_t next = 0;
    for (auto& [leaf, number] : leaf_number_) number = next++;
    list("leaves", leaf_number_, [&](const auto& entry) {
      const bool named = view_.leaves != nullptr && entry.first.index() < view_.leaves->size();
      return Json{{"name", named ? (*view_.leaves)[entry.first.index()].name : std::string()}};
    });
  }

  /// Regions of a group, all components of other values.
  std::vector<RegionAttributes> components() const {
    if (view_.value->is_group()) return view_.value->group().regions;
    const auto& attributes = view_.value->components().attributes;
    return {attributes.begin(), attributes.end()};
  }

  Json leaf_numbers(const std::vector<LeafId>& leaves) const {
    Json result = Json::array();
    for (const LeafId leaf : leaves) result.push_back(leaf_number_.at(leaf));
    return result;
  }

  Json vertex(const FlatComplex::Vertex& v) const {
    Json result{{"point", v.point}, {"component", v.component}, {"entity", v.entity}, {"feature", v.feature}};
    if (v.region != FlatComplex::kNone) result["region"] = v.region;
    if (!v.leaves.empty()) result["leaves"] = leaf_numbers(v.leaves);
    return result;
  }

  Json edge(const FlatComplex::Edge& e) const {
    Json result{{"points", e.points},       {"closed", e.closed},   {"component", e.component},
                {"entity", e.entity},       {"feature", e.feature}, {"wire", e.wire}};
    if (e.region != FlatComplex::kNone) result["region"] = e.region;
    if (!e.leaves.empty()) result["leaves"] = leaf_numbers(e.leaves);
    return result;
  }

  Json face(const FlatComplex::Face& f) {
    Json result{{"loops", f.loops}};
    if (!f.isolated.empty()) result["isolated"] = f.isolated;
    result["component"] = f.component;
    result["entity"] = f.entity;
    result["regions"] = {index_or_null(f.regions[0]), index_or_null(f.regions[1])};
    if (!f.sources.empty()) {
      result["patch"] = patches_(f.sources[0].leaf, f.sources[0].patch);
      result["surface"] = surfaces_(f.sources[0].leaf, f.sources[0].face);
    }
    if (!f.facets.empty()) {
      Json& facets = result["facets"] = Json::array();
      for (const auto& facet : f.facets) {
        Json& item = facets.emplace_back(Json{{"loops", facet.loops}});
        if (!facet.isolated.empty()) item["isolated"] = facet.isolated;
      }
    }
    result["triangles"] = f.triangles;
    Json& sources = result["sources"] = Json::array();
    for (const auto& s : f.sources) {
      sources.push_back({{"leaf", leaf_number_.at(s.leaf)}, {"face", s.face}, {"same", s.same}});
    }
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
    return result;
  }
};

}  // namespace

FileText json_text(const ResultView& view) { return {JsonWriter(view).run(), {}}; }

}  // namespace cnrg
