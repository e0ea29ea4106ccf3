// Equality is that of the data: a target may be one object or two equal ones.
#include "csg/materials/grade.h"

#include <set>

namespace cnrg {
namespace {

bool same_target(const SharedTarget& a, const SharedTarget& b) { return a == b || (a && b && *a == *b); }

void add_words(const std::string& name, std::set<std::string>& words) {
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find(" & ", begin), name.size());
    words.insert(name.substr(begin, end - begin));
    begin = end + 3;
  }
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

std::string blended_name(const std::string& a, const std::string& b) {
  std::set<std::string> words;
  add_words(a, words), add_words(b, words);
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " & ") + word;
  return out;
}

}  // namespace cnrg
