// The exact and lossless format: JSON with one cell per line and coordinates as fractions. What its members mean
// is in csg/formats/result.schema.json.
#include "csg/result/result_json.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <span>

#include "csg/materials/grade.h"
#include "csg/result/file_numbers.h"
#include "csg/text/json_text.h"
#include "csg/text/number.h"
#include "kernel/selection/measure.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;

void append_point(std::string& text, const RationalPoint& p) {
  append_json(text, p, [&](const Rational& c) { append_json(text, to_string(c)); });
}

void add_target(const DistanceTarget& target, JsonObject& out) {
  std::string& text = out.key("points");
  append_json(text, target.points, [&](const RationalPoint& p) { append_point(text, p); });
  out.add("vertices", target.vertices).add("segments", target.segments).add("triangles", target.triangles);
}

/// What a grade goes along and its stops; of a blend neither.
void add_grade(const Grade& grade, JsonObject& out) {
  if (const auto* linear = std::get_if<LinearGrade>(&grade.along)) {
    JsonObject along(out.key("linear"));
    append_point(along.key("from"), linear->from);
    append_point(along.key("to"), linear->to);
  } else if (const auto* distance = std::get_if<DistanceGrade>(&grade.along)) {
    JsonObject along(out.key("distance"));
    add_target(*distance->target, along.add("to", distance->to));
  } else {
    return;
  }
  std::string& text = out.key("stops");
  append_json(text, grade.stops, [&](const Grade::Stop& stop) {
    JsonObject object(text);
    JsonObject mixture(object.add("at", to_string(stop.at)).key("mixture"));
    for (const auto& [name, fraction] : stop.mixture) append_json(mixture.named(name), to_string(fraction));
  });
}

/// The graded materials of a result, each once, as members of a .json. A blend may have a blend as one of its two
/// materials: blends are listed from the innermost outward, and each names its inner blends by their numbers.
class GradeNumbers {
 public:
  /// Materials that are not graded are passed over.
  void add(const RegionMaterial& material);
  std::size_t number(const RegionMaterial& material) const;
  const std::vector<RegionMaterial>& all() const { return grades_; }
  /// Appends the entry of one of `all` in the list `grades`.
  void append(std::string& text, const RegionMaterial& material) const;

 private:
  std::vector<RegionMaterial> grades_;
};

void GradeNumbers::add(const RegionMaterial& material) {
  if (material.grade() == nullptr) return;
  if (std::find(grades_.begin(), grades_.end(), material) != grades_.end()) return;
  if (const auto* blend = std::get_if<BlendGrade>(&material.grade()->grade.along)) {
    add(blend->first.material), add(blend->second.material);
  }
  grades_.push_back(material);
}

std::size_t GradeNumbers::number(const RegionMaterial& material) const {
  return static_cast<std::size_t>(std::find(grades_.begin(), grades_.end(), material) - grades_.begin());
}

void GradeNumbers::append(std::string& text, const RegionMaterial& material) const {
  const PlacedGrade& placed = *material.grade();
  JsonObject out(text);
  out.add("material", material.name());
  {
    JsonObject placement(out.key("placement"));
    append_json(placement.key("linear"), placed.placement.linear,
                [&](const auto& row) { append_point(text, row); });
    append_point(placement.key("offset"), placed.placement.offset);
  }
  add_grade(placed.grade, out);
  if (!placed.nested.empty()) {
    append_json(out.key("nested"), placed.nested, [&](const auto& nested) {
      JsonObject one(text);
      add_grade(nested.second, one.add("material", nested.first));
    });
  }
  const auto* blend = std::get_if<BlendGrade>(&placed.grade.along);
  if (blend == nullptr) return;
  append_json(out.key("blend"), std::array{&blend->first, &blend->second}, [&](const BlendGrade::Side* side) {
    JsonObject one(text);
    one.add("material", side->material.name());
    if (side->material.grade() != nullptr) one.add("grade", number(side->material));
    JsonObject boundary(one.key("boundary"));
    add_target(*side->boundary, boundary);
  });
}

std::string json_quoted(std::string_view value) {
  std::string text;
  append_json(text, value);
  return text;
}

void append_quoted(Line& line, const Rational& value) { line << '"' << to_string(value) << '"'; }

/// As the fraction in lowest terms.
void append_quoted(Line& line, double value) {
  int exponent = 0;
  auto numerator = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  const int zeros = numerator == 0 ? 0 : std::countr_zero(static_cast<std::uint64_t>(numerator));
  numerator >>= zeros, exponent += zeros;
  if (numerator != 0 && (exponent > 0 || exponent < -63)) return append_quoted(line, from_double(value));
  line << '"' << numerator;
  if (numerator != 0 && exponent < 0) line << '/' << (std::uint64_t{1} << -exponent);
  line << '"';
}

class JsonWriter {
 public:
  JsonWriter(const ResultView& view, FlatComplex flat) : view_(view), flat_(std::move(flat)) {}

  std::string run() {
    constexpr std::size_t kCell = 160;  // bytes; what is not needed is not touched
    text_.reserve(kCell * (flat_.points.size() + flat_.vertices.size() + flat_.edges.size() + flat_.faces.size()));
    text_ += "{\n\"format\": \"cnrg result\",\n\"version\": 1,\n\"node\": " + json_quoted(view_.node) +
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
    lines("points", flat_.points, [&](Line& line, VertexId v) { point(line, v); });
    append_json(text_ += ",\n\"frame\": ", flat_.frame_points);
    lines("vertices", flat_.vertices, [&](Line& line, const auto& v) { vertex(line, v); });
    lines("edges", flat_.edges, [&](Line& line, const auto& e) { edge(line, e); });
    patch_ = patch_numbers(flat_);
    if (view_.parameters != nullptr) cells();
    lines("faces", flat_.faces, [&](Line& line, const auto& f) { face(line, f); });
    find_parts();
    lines("regions", flat_.regions, [&](Line& line, const auto& r) { region(line, r); });
    if (view_.volume_bound) {
      const std::optional<double> bound = view_.volume_bound();
      if (bound != 0.0) text_ += ",\n\"volume_bound\": " + (bound ? json_quoted(bound_text(bound)) : "null");
    }
    text_ += "\n}\n";
    return std::move(text_);
  }

 private:
  const ResultView& view_;
  FlatComplex flat_;
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

  /// A long list, a line for each of its items.
  template <class T, class Append>
  void lines(const char* key, const std::vector<T>& items, Append append) {
    text_ += ",\n\"" + std::string(key) + "\": [";
    append_lines(text_, items.size(), [&](std::string& out, std::size_t i) {
      Line line(out);
      line << (i == 0 ? "\n" : ",\n");
      append(line, items[i]);
    });
    text_ += "]";
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
  void add_said(Line& line, const FlatComplex::Provenance& origin) const {
    if (origin.said != nullptr) line << ",\"attributes\":" << said_number_.at(*origin.said);
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
    lines("cells", list, [&](Line& line, const std::vector<PatchCorner>* cell) {
      append_json(line, *cell, [&](const PatchCorner& corner) {
        const auto& [x, y, z] = corner.point;
        const auto& [u, v] = corner.at;
        append_json(line, std::array{&x, &y, &z, &u, &v}, [&](const Rational* c) { append_quoted(line, *c); });
      });
    });
  }

  void point(Line& line, VertexId v) const {
    if (const double* x = view_.complex->points.doubles(v)) {
      append_json(line, std::span(x, 3), [&](double c) { append_quoted(line, c); });
    } else {
      append_json(line, view_.complex->points.rational(v), [&](const Rational& c) { append_quoted(line, c); });
    }
  }

  void add_origin(Line& line, const FlatComplex::Provenance& origin) const {
    static constexpr std::string_view kKeys[] = {",\"point\":true", ",\"edges\":", ",\"faces\":", ",\"regions\":"};
    line << ",\"origin\":";
    auto cell = origin.cells.begin();
    append_json(line, origin.leaves, [&](LeafId leaf) {
      line << "{\"leaf\":" << leaf_number_.at(leaf);
      while (cell != origin.cells.end() && cell->leaf == leaf) {
        const int dimension = cell->dimension;
        line << kKeys[dimension];
        char before = '[';
        for (; cell != origin.cells.end() && cell->leaf == leaf && cell->dimension == dimension; ++cell) {
          if (dimension > 0) line << std::exchange(before, ',') << cell->number;
        }
        if (dimension > 0) line << ']';
      }
      line << '}';
    });
  }

  /// What vertices and edges end with.
  template <class Cell>
  void add_rest(Line& line, const Cell& cell) const {
    if (cell.region != FlatComplex::kNone) line << ",\"region\":" << cell.region;
    add_said(line, cell.origin);
    if (cell.component != 0) add_origin(line, cell.origin);
    line << '}';
  }

  void vertex(Line& line, const FlatComplex::Vertex& v) const {
    line << "{\"point\":" << v.point << ",\"component\":" << v.component << ",\"entity\":" << v.entity
         << ",\"feature\":" << v.feature;
    add_rest(line, v);
  }

  void edge(Line& line, const FlatComplex::Edge& e) const {
    append_json(line << "{\"points\":", e.points);
    line << ",\"closed\":" << e.closed << ",\"component\":" << e.component << ",\"entity\":" << e.entity
         << ",\"feature\":" << e.feature << ",\"wire\":" << e.wire;
    add_rest(line, e);
  }

  template <class T>
  static void add_walks(Line& line, const T& face) {
    append_json(line << "{\"loops\":", face.loops);
    if (!face.isolated.empty()) append_json(line << ",\"isolated\":", face.isolated);
  }

  void face(Line& line, const FlatComplex::Face& f) const {
    add_walks(line, f);
    line << ",\"component\":" << f.component << ",\"entity\":" << f.entity << ",\"regions\":";
    append_json(line, f.regions, [&](Index region) {
      if (region == FlatComplex::kNone) line << "null";
      else line << region;
    });
    line << ",\"patch\":" << patch_[static_cast<std::size_t>(&f - flat_.faces.data())];
    if (!f.facets.empty()) {
      append_json(line << ",\"facets\":", f.facets, [&](const FlatComplex::Facet& facet) {
        add_walks(line, facet);
        line << '}';
      });
    }
    append_json(line << ",\"triangles\":", f.triangles);
    if (!f.cells.empty()) {
      append_json(line << ",\"cells\":", f.cells, [&](const auto& facet) {
        append_json(line, facet, [&](const auto& cell) { line << cell_number_.at(cell); });
      });
    }
    add_said(line, f.origin);
    if (f.component != 0) add_origin(line, f.origin);
    line << '}';
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

  void region(Line& line, const FlatComplex::Region& r) const {
    const RegionAttributes& attributes = attributes_of(view_, r.component);
    line << "{\"component\":" << r.component << ",\"name\":" << json_quoted(attributes.name.text())
         << ",\"material\":" << json_quoted(attributes.material.name()) << ",\"bounded\":" << r.bounded
         << ",\"volume\":";
    if (!r.bounded) line << "null";
    else if (const Part* part = part_of(r)) append_quoted(line, part->volume(*view_.complex).bounded);
    else append_quoted(line, volume(*view_.complex, r.cells).value());
    append_json(line << ",\"shells\":", r.shells, [&](const std::vector<Index>& shell) {
      append_json(line, shell, [&](Index side) {
        line << "{\"face\":" << (side >> 1) << ",\"side\":" << (side & 1 ? "\"back\"}" : "\"front\"}");
      });
    });
    if (r.component != 0) add_origin(line, r.origin);
    line << '}';
  }
};

}  // namespace

std::string result_json(const ResultView& view) { return result_json(view, flatten(view)); }
std::string result_json(const ResultView& view, FlatComplex flat) {
  return JsonWriter(view, std::move(flat)).run();
}

}  // namespace cnrg
