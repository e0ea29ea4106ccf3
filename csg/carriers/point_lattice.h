// Points in the cells of a fine lattice, to find points that are equal up to rounding.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <set>

#include "kernel/exact/exact_vectors.h"

namespace cnrg {

class PointLattice {
 public:
  /// For points on a sphere or circle.
  PointLattice(const RationalPoint& center, const Rational& radius)
      : center_(to_doubles(center)), step_(to_double(radius) * 0x1p-30) {}
  /// False if one next to it was added before.
  bool add(const RationalPoint& p) {
    const std::array<double, 3> at = to_doubles(p);
    std::array<std::int64_t, 3> cell{};
    for (std::size_t k = 0; k < 3; ++k) cell[k] = std::llround((at[k] - center_[k]) / step_);
    for (int i = 0; i < 27; ++i) {
      if (cells_.contains({cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1})) return false;
    }
    cells_.insert(cell);
    return true;
  }

 private:
  std::array<double, 3> center_;
  double step_;
  std::set<std::array<std::int64_t, 3>> cells_;
};

}  // namespace cnrg
