// A blend may have a blend as one of its two materials. Blends are listed from the innermost outward, and each
// names its inner blends by their numbers.
#include "csg/result/json_grades.h"

#include <algorithm>

#include "csg/text/json_text.h"

namespace cnrg {
namespace {

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

}  // namespace

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

}  // namespace cnrg
