// A material that is blended may be a blend itself, of another one in turn: they are listed from the inside out,
// and each names those inside of it by their numbers.
#include "csg/result/json_grades.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace cnrg {
namespace {

using Json = nlohmann::ordered_json;

Json numbers(const RationalPoint& p) { return {to_string(p[0]), to_string(p[1]), to_string(p[2])}; }

void add_target(const DistanceTarget& target, Json& out) {
  Json points = Json::array();
  for (const RationalPoint& p : target.points) points.push_back(numbers(p));
  out["points"] = points;
  out["vertices"] = target.vertices;
  out["segments"] = target.segments;
  out["triangles"] = target.triangles;
}

/// What a grade goes along and its stops; of a blend neither.
void add_grade(const Grade& grade, Json& out) {
  if (const auto* linear = std::get_if<LinearGrade>(&grade.along)) {
    out["linear"] = {{"from", numbers(linear->from)}, {"to", numbers(linear->to)}};
  } else if (const auto* distance = std::get_if<DistanceGrade>(&grade.along)) {
    Json& to = out["distance"] = {{"to", distance->to}};
    add_target(*distance->target, to);
  } else {
    return;
  }
  Json stops = Json::array();
  for (const Grade::Stop& stop : grade.stops) {
    Json mixture = Json::object();
    for (const auto& [name, fraction] : stop.mixture) mixture[name] = to_string(fraction);
    stops.push_back({{"at", to_string(stop.at)}, {"mixture", mixture}});
  }
  out["stops"] = stops;
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

Json GradeNumbers::json(const RegionMaterial& material) const {
  const PlacedGrade& placed = *material.grade();
  Json rows = Json::array();
  for (const auto& row : placed.placement.linear) rows.push_back(numbers(row));
  Json out{{"material", material.name()},
           {"placement", {{"linear", rows}, {"offset", numbers(placed.placement.offset)}}}};
  add_grade(placed.grade, out);
  for (const auto& [name, nested] : placed.nested) {
    Json one{{"material", name}};
    add_grade(nested, one);
    out["nested"].push_back(one);
  }
  const auto* blend = std::get_if<BlendGrade>(&placed.grade.along);
  if (blend == nullptr) return out;
  for (const BlendGrade::Side* side : {&blend->first, &blend->second}) {
    Json one{{"material", side->material.name()}};
    if (side->material.grade() != nullptr) one["grade"] = number(side->material);
    add_target(*side->boundary, one["boundary"]);
    out["blend"].push_back(one);
  }
  return out;
}

}  // namespace cnrg
