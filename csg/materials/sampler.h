// The mixture of a material at a point.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "csg/materials/grade.h"

namespace cnrg {

/// The mixture of materials at any position, of one region. Keeps what distances need; not for several threads
/// at a time. `material` must outlive it.
class MaterialSampler {
 public:
  explicit MaterialSampler(const RegionMaterial& material);
  ~MaterialSampler();
  MaterialSampler(MaterialSampler&&) noexcept;
  /// Of materials that are not graded; empty for the empty material. Throws InputError when a distance is beyond
  /// the range of double.
  Mixture at(const RationalPoint& p) const;
  /// All materials that it may hold, ascending.
  std::vector<std::string> names() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Calls see(name) for each part of mixtures of a grade that is a nested grade of `placed`.
template <class See>
void for_each_nested(const PlacedGrade& placed, const Grade& grade, const See& see) {
  for (const Grade::Stop& stop : grade.stops) {
    for (const auto& part : stop.mixture) {
      if (placed.nested.contains(part.first)) see(part.first);
    }
  }
}
/// The nested grades, each after all nested ones that name it; without those that are made of themselves.
std::vector<const std::string*> nested_in_order(const PlacedGrade& placed);

/// `steel 3/4, ceramic 1/4`, for people: largest fraction first; one material alone has no number, and long
/// fractions are decimals.
std::string to_text(const Mixture& mixture);

}  // namespace cnrg
