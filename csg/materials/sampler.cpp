// The mixture at a point: the parameter t along a grade, then linear between the stops before and after t.
//
// Where stops name materials that are graded themselves, to ask each of these for its mixture, and it its own,
// costs twice as much with every level at which two stops name one material. So weights go down instead: the
// outermost material has weight 1, and materials are taken in an order in which each comes after all that name it.
// A graded one hands its weight on to the materials of its mixture at the point; what is left is on materials that
// are not graded. Each is looked at once, and only if it has a weight.
#include "csg/materials/sampler.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "kernel/base/error.h"
#include "kernel/exact/distance.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using Weights = std::map<std::string, Rational>;

std::unique_ptr<DistanceTo> distance_to(const SharedTarget& target) {
  require(target != nullptr && !target->empty(), "a graded material has nothing to measure a distance to");
  return std::make_unique<DistanceTo>(target->points, target->vertices, target->segments, target->triangles);
}

Rational rounded_distance(const DistanceTo& to, const RationalPoint& p, const std::string& material) {
  const double root = nearest_root(to.squared(p));
  if (!std::isfinite(root)) {
    throw InputError("material `" + material + "`: a distance is beyond the range of double: scale the model");
  }
  return from_double(root);
}

/// One grade that is no blend, ready to be asked.
class StopSampler {
 public:
  StopSampler(const std::string& name, const Grade& grade) : name_(name), grade_(grade) {
    if (const auto* distance = std::get_if<DistanceGrade>(&grade.along)) distance_ = distance_to(distance->target);
  }

  /// Adds `weight` times the mixture at a point in the grade's coordinates.
  void add(const RationalPoint& p, const Rational& weight, Weights& sums) const {
    const std::vector<Grade::Stop>& stops = grade_.stops;
    const Rational t = parameter(p);
    const auto next =
        std::upper_bound(stops.begin(), stops.end(), t, [](const Rational& t, const auto& s) { return t < s.at; });
    if (next == stops.begin()) return add(next->mixture, weight, sums);
    const auto last = next - 1;
    if (next == stops.end()) return add(last->mixture, weight, sums);
    const Rational s = (t - last->at) / (next->at - last->at);
    add(last->mixture, weight * (1 - s), sums);
    add(next->mixture, weight * s, sums);
  }

  const std::string& name() const { return name_; }
  std::set<std::string> names() const {
    std::set<std::string> out;
    for (const Grade::Stop& stop : grade_.stops) {
      for (const auto& part : stop.mixture) out.insert(part.first);
    }
    return out;
  }

 private:
  Rational parameter(const RationalPoint& p) const {
    if (const auto* linear = std::get_if<LinearGrade>(&grade_.along)) {
      const RationalPoint way = linear->to - linear->from;
      return dot(p - linear->from, way) / dot(way, way);
    }
    return rounded_distance(*distance_, p, name_);
  }
  static void add(const Mixture& mixture, const Rational& weight, Weights& sums) {
    if (weight == 0) return;
    for (const auto& [name, fraction] : mixture) sums[name] += weight * fraction;
  }

  const std::string& name_;
  const Grade& grade_;
  std::unique_ptr<DistanceTo> distance_;
};

}  // namespace

std::vector<const std::string*> nested_in_order(const PlacedGrade& placed) {
  std::map<std::string, std::size_t> named;  // how often by those that have not come yet
  for (const auto& [name, grade] : placed.nested)
    for_each_nested(placed, grade, [&](const std::string& n) { ++named[n]; });
  std::vector<const std::string*> out;
  for (const auto& [name, grade] : placed.nested) {
    if (!named.contains(name)) out.push_back(&name);
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    for_each_nested(placed, placed.nested.at(*out[i]), [&](const std::string& n) {
      if (--named[n] == 0) out.push_back(&placed.nested.find(n)->first);
    });
  }
  return out;
}

class MaterialSampler::Impl {
 public:
  explicit Impl(const RegionMaterial& material) : material_(material) {
    const PlacedGrade* placed = material.grade();
    if (placed == nullptr) return;
    back_ = placed->placement.inverse();
    blend_ = std::get_if<BlendGrade>(&placed->grade.along);
    if (blend_ != nullptr) {
      for (const BlendGrade::Side* side : {&blend_->first, &blend_->second}) {
        sides_.push_back({MaterialSampler(side->material), distance_to(side->boundary)});
      }
      return;
    }
    grades_.emplace_back(material.name(), placed->grade);
    const std::vector<const std::string*> nested = nested_in_order(*placed);
    require(nested.size() == placed->nested.size(), "a graded material is made of itself");
    for (const std::string* name : nested) grades_.emplace_back(*name, placed->nested.at(*name));
  }

  Mixture at(const RationalPoint& world) const {
    if (material_.empty()) return {};
    if (material_.grade() == nullptr) return {{material_.name(), 1}};
    const RationalPoint p = back_.apply(world);
    Weights sums;
    if (blend_ != nullptr) {
      const Rational to_first = rounded_distance(*sides_[0].boundary, p, material_.name());
      const Rational to_second = rounded_distance(*sides_[1].boundary, p, material_.name());
      const Rational both = to_first + to_second;
      const Rational t = both == 0 ? Rational(1, 2) : Rational(to_second / both);
      add(sides_[0], 1 - t, p, sums);
      add(sides_[1], t, p, sums);
      return taken(sums);
    }
    Weights weights;
    for (std::size_t i = 0; i < grades_.size(); ++i) {
      Rational weight = 1;
      if (i > 0) {
        const auto it = weights.find(grades_[i].name());
        if (it == weights.end() || it->second == 0) continue;
        weight = it->second;
        weights.erase(it);
      }
      grades_[i].add(p, weight, weights);
    }
    return taken(weights);
  }

  std::vector<std::string> names() const {
    if (material_.empty()) return {};
    if (material_.grade() == nullptr) return {material_.name()};
    std::set<std::string> out;
    for (const Side& side : sides_) {
      for (std::string& name : side.material.names()) out.insert(std::move(name));
    }
    for (const StopSampler& grade : grades_) out.merge(grade.names());
    for (const auto& [name, grade] : material_.grade()->nested) out.erase(name);
    return {out.begin(), out.end()};
  }

 private:
  struct Side {
    MaterialSampler material;
    std::unique_ptr<DistanceTo> boundary;
  };

  static void add(const Side& side, const Rational& weight, const RationalPoint& p, Weights& sums) {
    if (weight == 0) return;
    for (const auto& [name, fraction] : side.material.at(p)) sums[name] += weight * fraction;
  }
  static Mixture taken(Weights& sums) {
    Mixture out;
    for (auto& [name, fraction] : sums) {
      if (fraction != 0) out.emplace_back(name, std::move(fraction));
    }
    return out;
  }

  const RegionMaterial& material_;
  Transform back_;  // the inverse of the placement
  const BlendGrade* blend_ = nullptr;
  std::vector<Side> sides_;          // of a blend
  std::vector<StopSampler> grades_;  // else: the material's own, then those nested in it
};

MaterialSampler::MaterialSampler(const RegionMaterial& material) : impl_(std::make_unique<Impl>(material)) {}
MaterialSampler::~MaterialSampler() = default;
MaterialSampler::MaterialSampler(MaterialSampler&&) noexcept = default;

Mixture MaterialSampler::at(const RationalPoint& p) const { return impl_->at(p); }
std::vector<std::string> MaterialSampler::names() const { return impl_->names(); }

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
