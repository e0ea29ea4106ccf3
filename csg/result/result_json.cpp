// The exact and lossless format: JSON with one cell per line and coordinates as fractions.
//
// {
//   "format": "cnrg result", "version": 1, "node": name, "group": true | false, "dominance": fraction of a group,
//   "leaves": [{"name"}],
//   "materials": [{"name", "color", "dominance"}],                   a dominance that is not 0
//   "grades": [{"material", "placement": {"linear": [row], "offset"},      if a material is graded
//     "linear": {"from", "to"} or "distance": {"to", "points", "vertices", "segments", "triangles"},
//     "stops": [{"at", "mixture"}],
//     "nested": [{"material", "linear" or "distance", "stops"}]}],   of graded materials in mixtures, if there are
//     any
//       or, in place of the last four, "blend": [{"material", "grade",          a grade before this one in the
//       list
//         "boundary": {"points", "vertices", "segments", "triangles"}}]}],          of two
//   "components": [{"name", "called", "material", "leaves": [leaf], "grade", "properties", "dominance"}],
//                                                                    component i is at [i - 1]
//   "attributes": [{"name", "called", "material", "grade", "properties"}],  what is said of cells of dimension <
//   3, if any "points": [[x, y, z]],                                           strings `p` or `p/q`, sorted
//   "frame": [point],                                                points that stand for infinity "vertices":
//   [{"point", "component", "origin", ...}], "edges": [{"points": [point], "closed", "component", "origin", ...}],
//   "faces":
//   [{"loops": [[point]], "component", "regions": [front, back], "patch", "triangles", "origin", ...}], "regions":
//   [{"component", "bounded", "shells": [[{"face", "side"}]], "volume", "origin", ...}]
// }
// "properties" are {key: text or {"number": fraction}}; they are left out where there are none. A face, edge or
// vertex of which something is said has "attributes", a place in that list.
//
// A component of 0 says that the cell is not part of the result but bounds a part of it. In a group the regions
// are the components, and its faces, edges and vertices that are entities have the number after the last one;
// only components of other values have a dominance each. `entity` is false for cells that are only the interior
// of a region. A region that no cell lists is null. Loops have the face to the left as seen from its front: the
// outer loop of a flat face comes first and is counter-clockwise. `facets` are the planar pieces of a face that is
// not flat. Faces with the same `patch` are of one patch of a leaf.
//
// With parameters (leaves/parameters.h) there are two more lists before "faces", and a member of faces, where
// there are any:
//   "patches": [{"patch", "leaf", "name"}],           of those that have parameters
//   "cells": [[[x, y, z, u, v], ...]],                cells of patches by their corners
//   "faces": [{..., "cells": [[cell]]}]               in which cells each facet lies, all of a flat face
//
// `origin` names the leaves that a cell of the result came from, and what of them holds it (boundaries included),
// over all cells that simplification united in it: [{"leaf", "faces": [...], "edges": [...], "point": true,
// "regions": [...]}], by the leaf's own numbers; what is empty is left out. Edges are wires, a point is isolated,
// regions count from 1.
#include "csg/result/result_json.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <span>

#include "csg/result/file_numbers.h"
#include "csg/result/json_grades.h"
#include "csg/text/json_text.h"
#include "csg/text/number.h"
#include "kernel/selection/measure.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;

std::string json_quoted(std::string_view value) {
  std::string text;
  append_json(text, value);
  return text;
}

void append_quoted(std::string& text, const Rational& value) { (((text += '"') += to_string(value)) += '"'); }

/// As the fraction in lowest terms.
void append_quoted(std::string& text, double value) {
  int exponent = 0;
  auto numerator = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  const int zeros = numerator == 0 ? 0 : std::countr_zero(static_cast<std::uint64_t>(numerator));
  numerator >>= zeros, exponent += zeros;
  if (numerator != 0 && (exponent > 0 || exponent < -63)) return append_quoted(text, from_double(value));
  Line line(text);
  line << '"' << numerator;
  if (numerator != 0 && exponent < 0) line << '/' << (std::uint64_t{1} << -exponent);
  line << '"';
}

class JsonWriter {
 public:
  JsonWriter(const ResultView& view, FlatComplex flat) : view_(view), flat_(std::move(flat)) {}

  std::string run() {
    text_ = "{\n\"format\": \"cnrg result\",\n\"version\": 1,\n\"node\": " + json_quoted(view_.node) +
            ",\n\"group\": " + (view_.value->is_group() ? "true" : "false");
    if (view_.value->is_group()) {
      text_ += ",\n\"dominance\": " + json_quoted(to_string(view_.value->group().dominance));
    }
    leaves();
    number_said();
    for_each_material([&](const RegionMaterial& m) {
      if (m.has_dominance()) dominances_.emplace(m.name(), m.dominance());
    });
    list("materials", view_.materials, [&](const auto& m) { material(m); });
    add_grades();
    if (view_.value->is_group()) {
      list("components", view_.value->group().regions,
           [&](const RegionAttributes& a) { attributes(a, &a.leaves); });
    } else {
      list("components", view_.value->components().attributes,
           [&](const ComponentAttributes& a) { attributes(a, &a.leaves, &a.dominance); });
    }
    if (!said_.empty()) list("attributes", said_, [&](const Attributes* a) { attributes(*a); });
    lines("points", flat_.points, [&](std::string& out, VertexId v) { point(out, v); });
    append_json(text_ += ",\n\"frame\": ", flat_.frame_points);
    lines("vertices", flat_.vertices, [&](std::string& out, const auto& v) { vertex(out, v); });
    lines("edges", flat_.edges, [&](std::string& out, const auto& e) { edge(out, e); });
    patch_ = patch_numbers(flat_);
    if (view_.parameters != nullptr) cells();
    lines("faces", flat_.faces, [&](std::string& out, const auto& f) { face(out, f); });
    find_parts();
    lines("regions", flat_.regions, [&](std::string& out, const auto& r) { region(out, r); });
    if (view_.volume_bound) {
      const std::optional<double> bound = view_.volume_bound();
      if (bound != 0.0) text_ += ",\n\"volume_bound\": " + (bound ? json_quoted(bound_text(bound)) : "null");
    }
    text_ += "\n}\n";
    return joined();
  }

 private:
  const ResultView& view_;
  FlatComplex flat_;
  std::vector<std::string> parts_;  // of the text, before `text_`
  std::map<Component, const Part*> parts_by_component_;
  std::string text_;
  std::map<LeafId, std::size_t> leaf_number_;
  std::vector<const Attributes*> said_;
  std::map<Attributes, std::size_t, AttributesOrder> said_number_;
  GradeNumbers grades_;
  std::map<std::string, Rational> dominances_;  // of materials
  std::vector<std::size_t> patch_;              // by face
  std::map<std::vector<PatchCorner>, std::size_t> cell_number_;

  template <class Range, class Append>
  void list(const char* key, const Range& range, Append append) {
    text_ += ",\n\"" + std::string(key) + "\": [";
    const char* separator = "\n";
    for (const auto& item : range) {
      text_ += separator;
      append(item);
      separator = ",\n";
    }
    text_ += "]";
  }

  /// A long list; blocks of lines are made on all threads.
  template <class T, class Append>
  void lines(const char* key, const std::vector<T>& items, Append append) {
    std::vector<std::string> blocks = blocks_of_lines(items.size(), [&](std::string& out, std::size_t i) {
      out += i == 0 ? "\n" : ",\n";
      append(out, items[i]);
    });
    text_ += ",\n\"" + std::string(key) + "\": [";
    parts_.push_back(std::move(text_));
    parts_.insert(parts_.end(), std::make_move_iterator(blocks.begin()), std::make_move_iterator(blocks.end()));
    text_ = "]";
  }

  std::string joined() {
    parts_.push_back(std::move(text_));
    std::size_t size = 0;
    for (const std::string& part : parts_) size += part.size();
    std::string all;
    all.reserve(size);
    for (std::string& part : parts_) all += std::exchange(part, {});
    return all;
  }

  /// Leaves that the result names, numbered in the file.
  void leaves() {
    leaf_number_ = cnrg::leaf_numbers(view_, flat_);
    list("leaves", in_order(leaf_number_),
         [&](LeafId leaf) { JsonObject(text_).add("name", leaf_name(view_, leaf)); });
  }

  /// The dominance of a material is known where a component or a cell is made of it.
  void material(const ResultView::Material& m) {
    JsonObject object(text_);
    object.add("name", m.name).add("color", m.color);
    if (const auto it = dominances_.find(m.name); it != dominances_.end())
      object.add("dominance", to_string(it->second));
  }

  /// A name that somebody gave is a text; of others it is told who gave them.
  void called(const NamePart& part) {
    if (part.origin == NameOrigin::given && part.ordinal == 0) return append_json(text_, part.text);
    JsonObject object(text_);
    object.add("name", part.text);
    if (part.ordinal != 0) object.add("ordinal", part.ordinal);
    if (part.origin != NameOrigin::given) object.add("by", kNameOrigins[static_cast<std::size_t>(part.origin)]);
  }

  /// `leaves` and `dominance`: of a component.
  void attributes(const Attributes& a, const std::vector<LeafId>* leaves = nullptr,
                  const Rational* dominance = nullptr) {
    JsonObject object(text_);
    object.add("name", a.name.text());
    if (!a.name.empty() && a.name.parts() != std::vector{NamePart{a.name.text(), 0, NameOrigin::file}})
      append_json(object.key("called"), a.name.parts(), [&](const NamePart& part) { called(part); });
    object.add("material", a.material.name());
    if (leaves != nullptr) {
      append_json(object.key("leaves"), numbers_of(*leaves, leaf_number_));
    }
    if (a.material.grade() != nullptr) object.add("grade", grades_.number(a.material));
    if (!a.properties.empty()) {
      JsonObject properties(object.key("properties"));
      for (const auto& [key, value] : a.properties) {
        properties.named(key);
        if (std::holds_alternative<Rational>(value)) JsonObject(text_).add("number", to_text(value));
        else append_json(text_, to_text(value));
      }
    }
    if (dominance != nullptr) object.add("dominance", to_string(*dominance));
  }

  /// What is said of cells, each once, in the order in which cells name it: vertices, edges, faces.
  void number_said() {
    const auto see = [&](const auto& cells) {
      for (const auto& cell : cells) {
        const Attributes* said = cell.origin.said;
        if (said == nullptr) continue;
        const bool fresh = said_number_.try_emplace(*said, said_.size()).second;
        if (fresh) said_.push_back(said);
      }
    };
    see(flat_.vertices), see(flat_.edges), see(flat_.faces);
  }
  void add_said(JsonObject& object, const FlatComplex::Provenance& origin) const {
    if (origin.said == nullptr) return;
    object.add("attributes", said_number_.at(*origin.said));
  }

  template <class See>
  void for_each_material(See see) const {
    for (const RegionAttributes& a : view_.value->attributes()) see(a.material);
    for (const Attributes* a : said_) see(a->material);
  }

  /// The graded materials of components and cells, each once.
  void add_grades() {
    for_each_material([&](const RegionMaterial& material) { grades_.add(material); });
    if (!grades_.all().empty()) list("grades", grades_.all(), [&](const auto& m) { grades_.append(text_, m); });
  }

  /// The patches with parameters, and their cells in the order in which faces lie in them.
  void cells() {
    std::map<std::size_t, FlatComplex::Patch> patches;
    std::vector<const std::vector<PatchCorner>*> list;
    for (std::size_t i = 0; i < flat_.faces.size(); ++i) {
      const FlatComplex::Face& f = flat_.faces[i];
      if (!f.cells.empty()) patches.emplace(patch_[i], *f.patch);
      for (const auto& facet : f.cells) {
        for (const auto& cell : facet) {
          if (cell_number_.try_emplace(cell, list.size()).second) list.push_back(&cell);
        }
      }
    }
    if (patches.empty()) return;
    this->list("patches", patches, [&](const auto& entry) {
      const auto& [leaf, patch] = entry.second;
      JsonObject(text_)
          .add("patch", entry.first)
          .add("leaf", leaf_number_.at(leaf))
          .add("name", view_.parameters->patch_name(leaf, patch));
    });
    lines("cells", list, [](std::string& out, const std::vector<PatchCorner>* cell) {
      append_json(out, *cell, [&](const PatchCorner& corner) {
        const auto& [x, y, z] = corner.point;
        const auto& [u, v] = corner.at;
        append_json(out, std::array{&x, &y, &z, &u, &v}, [&](const Rational* c) { append_quoted(out, *c); });
      });
    });
  }

  void point(std::string& out, VertexId v) const {
    if (const double* x = view_.complex->points.doubles(v)) {
      append_json(out, std::span(x, 3), [&](double c) { append_quoted(out, c); });
    } else {
      append_json(out, view_.complex->points.rational(v), [&](const Rational& c) { append_quoted(out, c); });
    }
  }

  void add_origin(JsonObject& object, const FlatComplex::Provenance& origin) const {
    static constexpr const char* kKeys[] = {"point", "edges", "faces", "regions"};
    std::string& out = object.key("origin");
    auto cell = origin.cells.begin();
    append_json(out, origin.leaves, [&](LeafId leaf) {
      JsonObject item(out);
      item.add("leaf", leaf_number_.at(leaf));
      while (cell != origin.cells.end() && cell->leaf == leaf) {
        const int dimension = cell->dimension;
        const auto end = std::find_if(cell, origin.cells.end(), [&](const LeafCell& c) {
          return c.leaf != leaf || c.dimension != dimension;
        });
        item.key(kKeys[dimension]);
        if (dimension == 0) append_json(out, true);
        else append_json(out, std::span(cell, end), [&](const LeafCell& c) { append_json(out, c.number); });
        cell = end;
      }
    });
  }

  void vertex(std::string& out, const FlatComplex::Vertex& v) const {
    JsonObject object(out);
    object.add("point", v.point).add("component", v.component).add("entity", v.entity).add("feature", v.feature);
    if (v.region != FlatComplex::kNone) object.add("region", v.region);
    add_said(object, v.origin);
    if (v.component != 0) add_origin(object, v.origin);
  }

  void edge(std::string& out, const FlatComplex::Edge& e) const {
    JsonObject object(out);
    object.add("points", e.points).add("closed", e.closed).add("component", e.component);
    object.add("entity", e.entity).add("feature", e.feature).add("wire", e.wire);
    if (e.region != FlatComplex::kNone) object.add("region", e.region);
    add_said(object, e.origin);
    if (e.component != 0) add_origin(object, e.origin);
  }

  template <class T>
  static void add_walks(JsonObject& object, const T& face) {
    object.add("loops", face.loops);
    if (!face.isolated.empty()) object.add("isolated", face.isolated);
  }

  void face(std::string& out, const FlatComplex::Face& f) const {
    JsonObject object(out);
    add_walks(object, f);
    object.add("component", f.component).add("entity", f.entity);
    append_json(object.key("regions"), f.regions, [&](Index region) {
      if (region == FlatComplex::kNone) out += "null";
      else append_json(out, region);
    });
    object.add("patch", patch_[static_cast<std::size_t>(&f - flat_.faces.data())]);
    if (!f.facets.empty()) {
      append_json(object.key("facets"), f.facets, [&](const FlatComplex::Facet& facet) {
        JsonObject item(out);
        add_walks(item, facet);
      });
    }
    object.add("triangles", f.triangles);
    if (!f.cells.empty()) {
      append_json(object.key("cells"), f.cells, [&](const auto& facet) {
        append_json(out, facet, [&](const auto& cell) { append_json(out, cell_number_.at(cell)); });
      });
    }
    add_said(object, f.origin);
    if (f.component != 0) add_origin(object, f.origin);
  }

  /// The part of a group that has this region alone: whoever showed rows has measured it.
  const Part* part_of(const FlatComplex::Region& r) const {
    const auto found = parts_by_component_.find(r.component);
    return found == parts_by_component_.end() ? nullptr : found->second;
  }
  void find_parts() {
    if (!view_.value->is_group()) return;
    const PartedGroup& group = view_.value->parts();
    std::map<Component, std::size_t> regions;
    for (const FlatComplex::Region& r : flat_.regions) ++regions[r.component];
    Component component = 0;
    for (const auto& [part, unused] : region_order(group)) {
      ++component;
      if (regions[component] == 1 && group.parts[part]->group().regions.size() == 1)
        parts_by_component_[component] = group.parts[part].get();
    }
  }

  void region(std::string& out, const FlatComplex::Region& r) const {
    const RegionAttributes& attributes = attributes_of(view_, r.component);
    JsonObject object(out);
    object.add("component", r.component);
    object.add("name", attributes.name.text())
        .add("material", attributes.material.name())
        .add("bounded", r.bounded);
    object.key("volume");
    if (!r.bounded) out += "null";
    else if (const Part* part = part_of(r)) append_quoted(out, part->volume(*view_.complex).bounded);
    else append_quoted(out, volume(*view_.complex, r.cells).value());
    append_json(object.key("shells"), r.shells, [&](const std::vector<Index>& shell) {
      append_json(out, shell, [&](Index side) {
        Line(out) << "{\"face\":" << (side >> 1) << ",\"side\":" << (side & 1 ? "\"back\"}" : "\"front\"}");
      });
    });
    if (r.component != 0) add_origin(object, r.origin);
  }
};

}  // namespace

std::string result_json(const ResultView& view) { return result_json(view, flatten(view)); }
std::string result_json(const ResultView& view, FlatComplex flat) {
  return JsonWriter(view, std::move(flat)).run();
}

}  // namespace cnrg
