// Grades are equal if their data are: targets may be one object or two equal ones.
#include "csg/materials/grade.h"

#include <set>

namespace cnrg {
namespace {

bool same_target(const SharedTarget& a, const SharedTarget& b) { return a == b || (a && b && *a == *b); }

/// What a blend is a mixture of, else the material itself.
void add_materials(const RegionMaterial& material, std::set<std::string>& names) {
  const PlacedGrade* const grade = material.grade();
  const auto* const blend = grade == nullptr ? nullptr : std::get_if<BlendGrade>(&grade->grade.along);
  if (blend == nullptr) {
    names.insert(material.name());
    return;
  }
  for (const BlendGrade::Side* side : {&blend->first, &blend->second}) add_materials(side->material, names);
}

}  // namespace

bool operator==(const DistanceGrade& a, const DistanceGrade& b) {
  return a.to == b.to && same_target(a.target, b.target);
}

bool operator==(const BlendGrade::Side& a, const BlendGrade::Side& b) {
  return a.material == b.material && same_target(a.boundary, b.boundary);
}

void for_each_name(const PlacedGrade& grade, const std::function<void(const std::string&)>& see) {
  const auto see_stops = [&](const Grade& g) {
    for (const Grade::Stop& stop : g.stops) {
      for (const auto& part : stop.mixture) see(part.first);
    }
  };
  see_stops(grade.grade);
  for (const auto& [name, nested] : grade.nested) see_stops(nested);
  const auto* blend = std::get_if<BlendGrade>(&grade.grade.along);
  if (blend == nullptr) return;
  for (const BlendGrade::Side* side : {&blend->first, &blend->second}) {
    see(side->material.name());
    if (side->material.grade() != nullptr) for_each_name(*side->material.grade(), see);
  }
}

std::string blended_name(const RegionMaterial& a, const RegionMaterial& b) {
  std::set<std::string> names;
  add_materials(a, names), add_materials(b, names);
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : " & ") + name;
  return out;
}

}  // namespace cnrg
