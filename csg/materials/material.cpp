// The mixture at a point: its parameter t along the grade, then linear between the stops before and after t.
#include "csg/materials/material.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "csg/geometry/exact_vectors.h"
#include "kernel/base/error.h"
#include "kernel/exact/distance.h"

namespace cnrg {
namespace {

// a + s (b - a), name by name.
Mixture blend(const Mixture& a, const Mixture& b, const Rational& s) {
  std::map<std::string, Rational> sums;
  for (const auto& [name, fraction] : a) sums[name] += fraction * (1 - s);
  for (const auto& [name, fraction] : b) sums[name] += fraction * s;
  Mixture out;
  for (auto& [name, fraction] : sums) {
    if (fraction != 0) out.emplace_back(name, std::move(fraction));
  }
  return out;
}

}  // namespace

MaterialSampler::MaterialSampler(const RegionMaterial& material) : material_(material) {
  if (material.grade() == nullptr) return;
  back_ = material.grade()->placement.inverse();
  const auto* distance = std::get_if<DistanceGrade>(&material.grade()->grade.along);
  if (distance == nullptr) return;
  const auto& target = distance->target;
  require(target != nullptr && !target->empty(), "a graded material has nothing to measure a distance to");
  distance_ = std::make_unique<DistanceTo>(target->points, target->vertices, target->segments, target->triangles);
}

MaterialSampler::~MaterialSampler() = default;
MaterialSampler::MaterialSampler(MaterialSampler&&) noexcept = default;

Rational MaterialSampler::parameter(const RationalPoint& p) const {
  const Grade& grade = material_.grade()->grade;
  if (const auto* linear = std::get_if<LinearGrade>(&grade.along)) {
    const RationalPoint way = linear->to - linear->from;
    return dot(p - linear->from, way) / dot(way, way);
  }
  const double root = nearest_root(distance_->squared(p));
  if (!std::isfinite(root)) {
    throw InputError("material `" + material_.name() +
                     "`: a distance is beyond the range of double: scale the model");
  }
  return from_double(root);
}

Mixture MaterialSampler::at(const RationalPoint& p) const {
  if (material_.empty()) return {};
  if (material_.grade() == nullptr) return {{material_.name(), 1}};
  const std::vector<Grade::Stop>& stops = material_.grade()->grade.stops;
  const Rational t = parameter(back_.apply(p));
  const auto next =
      std::upper_bound(stops.begin(), stops.end(), t, [](const Rational& t, const auto& s) { return t < s.at; });
  if (next == stops.begin()) return next->mixture;
  const auto last = next - 1;
  if (next == stops.end()) return last->mixture;
  return blend(last->mixture, next->mixture, (t - last->at) / (next->at - last->at));
}

std::vector<std::string> MaterialSampler::names() const {
  if (material_.empty()) return {};
  if (material_.grade() == nullptr) return {material_.name()};
  std::set<std::string> out;
  for (const Grade::Stop& stop : material_.grade()->grade.stops) {
    for (const auto& [name, fraction] : stop.mixture) out.insert(name);
  }
  return {out.begin(), out.end()};
}

std::string to_text(const Mixture& mixture) {
  if (mixture.size() == 1) return mixture[0].first;
  Mixture sorted = mixture;
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string out;
  for (const auto& [name, fraction] : sorted) {
    const std::string exact = to_string(fraction);
    out += (out.empty() ? "" : ", ") + name + " " + (exact.size() <= 12 ? exact : to_decimal(fraction, 6));
  }
  return out;
}

}  // namespace cnrg
