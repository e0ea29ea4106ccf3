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

/// `steel 3/4, ceramic 1/4`, for people: largest fraction first; one material alone has no number, and long
/// fractions are decimals.
std::string to_text(const Mixture& mixture);

}  // namespace cnrg
