// The plane of three points of doubles as a filter: on which side a point lies, where the normal looks. One scalar
// product per point instead of a determinant.
//
// Bounds. Let u = 2^-53, a, b, c the points, N the exact normal (b-a) x (c-a), m_k the largest absolute rounded
// difference along axis k, W the largest product of two of the m_k. Primes are computed values.
//   Normal: a component is a difference of two products of two differences, each with three roundings of its own
//   and one of the last difference: relative errors at most (1+u)^4 - 1 < 4.01 u on products of at most
//   W (1+u)^2. So |N'_k - N_k| < 8.1 u W and |N'_k| < 2.01 W.
//   Side: s = N . d with d = p - a; in s' each product carries at most four roundings of d, product and sums, and
//   the error of N'_k: |s' - s| < (8.1 u W + 4.01 u 2.01 W) L < 16.3 u W L, L the rounded sum of the |d_k|.
//   Unit normal: with |N'| > 1e-6 W the error of N' is less than sqrt(3) 8.1 u W < 1.6e-9 |N'|, and the vector at
//   unit length is off by less than twice that and a few roundings.
//   We use 20 u W L and 10 u W; what is over covers the roundings of the bounds themselves.
//   Level planes: if a, b, c agree in a coordinate (differences of doubles are zero only if they are exactly), the
//   plane is all points with that value, and its normal looks along that axis: comparisons alone decide.
//   Underflow adds at most 2^-1074 per product; W >= 1e-150 makes it negligible in N', and an absolute 1e-300 in
//   the bound of s' covers the products there. Overflow: W <= 1e200, and an s' that is not finite decides nothing.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "kernel/exact/cross_filter.h"

namespace cnrg {

class PlaneFilter {
 public:
  /// Decides nothing.
  PlaneFilter() = default;
  /// The plane of three points, three finite coordinates each; normal by the right-hand rule a -> b -> c.
  PlaneFilter(const double* a, const double* b, const double* c) : through_{a[0], a[1], a[2]} {
    double u[3], v[3], m[3];
    for (int k = 0; k < 3; ++k) {
      u[k] = b[k] - a[k];
      v[k] = c[k] - a[k];
      m[k] = std::max(std::fabs(u[k]), std::fabs(v[k]));
    }
    const double size = std::max(m[0] * m[1], std::max(m[1] * m[2], m[2] * m[0]));
    if (!(size >= 1e-150 && size <= 1e200)) return;
    size_ = size;
    for (int k = 0; k < 3; ++k) normal_[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    for (int k = 0; k < 3; ++k) {
      if (m[k] == 0 && normal_sign(k) != 0) level_ = k;
    }
  }

  /// The side of the plane on which p (three coordinates) lies, positive where the normal looks, or kUndecided.
  int side(const double* p) const {
    if (level_ >= 0) {
      const double d = p[level_] - through_[static_cast<std::size_t>(level_)];
      return d == 0 ? 0 : ((d > 0) == (normal_[static_cast<std::size_t>(level_)] > 0) ? 1 : -1);
    }
    const double x = p[0] - through_[0], y = p[1] - through_[1], z = p[2] - through_[2];
    const double s = normal_[0] * x + normal_[1] * y + normal_[2] * z;
    const double bound = 20 * kUnit * size_ * (std::fabs(x) + std::fabs(y) + std::fabs(z)) + 1e-300;
    const double size = std::fabs(s);
    if (!(size > bound && size <= std::numeric_limits<double>::max())) return kUndecided;
    return s > 0 ? 1 : -1;
  }
  /// The sign of a component of the normal; 0: not decided.
  int normal_sign(int axis) const {
    const double n = normal_[static_cast<std::size_t>(axis)];
    if (!(std::fabs(n) > 10 * kUnit * size_)) return 0;
    return n > 0 ? 1 : -1;
  }
  /// The computed normal.
  const std::array<double, 3>& normal() const { return normal_; }
  /// The computed normal at unit length, if that is certain enough: each component is off by less than 1e-8.
  std::optional<std::array<double, 3>> unit_normal() const {
    const auto& [x, y, z] = normal_;
    const double length = std::sqrt(x * x + y * y + z * z);  // of W <= 1e150: neither overflows nor vanishes
    if (!(size_ > 0 && size_ < 1e150 && length > 1e-6 * size_)) return std::nullopt;
    return std::array{x / length, y / length, z / length};
  }

 private:
  static constexpr double kUnit = 0x1p-53;
  std::array<double, 3> normal_{}, through_{};
  double size_ = 0;  // W; 0 if nothing is decided: then every s' is zero
  int level_ = -1;   // the axis of a level plane
};

}  // namespace cnrg
