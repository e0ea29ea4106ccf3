// The plane of three points as a filter: on which side a point lies, where the normal looks. One scalar product
// per point instead of a determinant.
//
// Bounds. Let u = 2^-53, a, b, c the points, N the exact normal (b-a) x (c-a), m_k the largest absolute rounded
// difference along axis k, W the largest product of two of the m_k. Primes are computed values.
//   Normal: a component is a difference of two products of two differences, each with three roundings of its own
//   and one of the last difference: relative errors at most (1+u)^4 - 1 < 4.01 u on products of at most
//   W (1+u)^2. So |N'_k - N_k| < 8.1 u W and |N'_k| < 2.01 W.
//   Side: s = N . d with d = p - a; in s' each product carries at most four roundings of d, product and sums, and
//   the error of N'_k: |s' - s| < (8.1 u W + 4.01 u 2.01 W) L < 16.3 u W L, L the rounded sum of the |d_k|.
//   Unit normal: with |N'| > 1e-6 W the error of N' is less than sqrt(3) 8.1 u W < 1.6e-9 |N'|, and the vector at
//   unit length is off by less than twice that and a few roundings. With a width we want B < 1e-9 |N'|, which adds
//   less than twice 1.8e-9.
//   Normal along d, |d_k| <= 1: three errors of 8.1 u W, and 4.01 u of three products below 2.01 W.
//   We use 20 u W L and 10 u W, and 20 u W for each of these three; what is over covers the roundings of the
//   bounds themselves.
//   Width: each exact coordinate lies between the double taken and w above it (w = 0 for points of doubles). The
//   exact differences are off by at most w; that moves a product of two by at most 2 w m + w^2, m the largest m_k,
//   and N by less than B = 4.1 w m + 2.1 w^2. With w also the width of p, d is off by w, so s by less than
//   B (L + 3 w) + 2.01 W 3 w.
//   Level planes: if a, b, c are doubles and agree in a coordinate (differences of doubles are zero only if they
//   are exactly), the plane is all points with that value, and its normal looks along that axis: comparisons alone
//   decide.
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
  /// The plane of three points, three finite coordinates each, which are up to `width` above those given; normal
  /// by the right-hand rule a -> b -> c.
  PlaneFilter(const double* a, const double* b, const double* c, double width = 0)
      : through_{a[0], a[1], a[2]}, width_(width) {
    double u[3], v[3], m[3];
    for (int k = 0; k < 3; ++k) {
      u[k] = b[k] - a[k];
      v[k] = c[k] - a[k];
      m[k] = std::max(std::fabs(u[k]), std::fabs(v[k]));
    }
    const double size = std::max(m[0] * m[1], std::max(m[1] * m[2], m[2] * m[0]));
    if (!(size >= 1e-150 && size <= 1e200)) return;
    size_ = size;
    if (width > 0) blur_ = (4.1 * std::max(m[0], std::max(m[1], m[2])) + 2.1 * width) * width;
    for (int k = 0; k < 3; ++k) normal_[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    for (int k = 0; k < 3; ++k) {
      if (width == 0 && m[k] == 0 && normal_sign(k) != 0) level_ = k;
    }
  }

  /// The side of the plane on which p (three coordinates, up to `width` above those given) lies, positive where
  /// the normal looks, or kUndecided.
  int side(const double* p, double width = 0) const {
    if (level_ >= 0 && width == 0) {
      const double d = p[level_] - through_[static_cast<std::size_t>(level_)];
      return d == 0 ? 0 : ((d > 0) == (normal_[static_cast<std::size_t>(level_)] > 0) ? 1 : -1);
    }
    const double x = p[0] - through_[0], y = p[1] - through_[1], z = p[2] - through_[2];
    const double s = normal_[0] * x + normal_[1] * y + normal_[2] * z;
    const double length = std::fabs(x) + std::fabs(y) + std::fabs(z);
    double bound = 20 * kUnit * size_ * length + 1e-300;
    if (const double w = std::max(width, width_); w != 0) bound += blur_ * (length + 3 * w) + 6.1 * size_ * w;
    const double size = std::fabs(s);
    if (!(size > bound && size <= std::numeric_limits<double>::max())) return kUndecided;
    return s > 0 ? 1 : -1;
  }
  /// The sign of a component of the normal; 0: not decided.
  int normal_sign(int axis) const {
    const double n = normal_[static_cast<std::size_t>(axis)];
    if (!(std::fabs(n) > 10 * kUnit * size_ + blur_)) return 0;
    return n > 0 ? 1 : -1;
  }
  /// The sign of the scalar product of the normal and d, whose components are at most 1; 0: not decided.
  int side_of_normal(const std::array<double, 3>& d) const {
    const double s = normal_[0] * d[0] + normal_[1] * d[1] + normal_[2] * d[2];
    if (!(std::fabs(s) > 3 * (20 * kUnit * size_ + blur_))) return 0;
    return s > 0 ? 1 : -1;
  }
  /// The computed normal.
  const std::array<double, 3>& normal() const { return normal_; }
  /// The computed normal at unit length, if that is certain enough: each component is off by less than 1e-8.
  std::optional<std::array<double, 3>> unit_normal() const {
    const auto& [x, y, z] = normal_;
    const double length = std::sqrt(x * x + y * y + z * z);  // of W <= 1e150: neither overflows nor vanishes
    if (!(size_ > 0 && size_ < 1e150 && length > 1e-6 * size_ && length > 1e9 * blur_)) return std::nullopt;
    return std::array{x / length, y / length, z / length};
  }

 private:
  static constexpr double kUnit = 0x1p-53;
  std::array<double, 3> normal_{}, through_{};
  double width_ = 0, blur_ = 0;  // w, B
  double size_ = 0;              // W; 0 if nothing is decided: then every s' is zero
  int level_ = -1;               // the axis of a level plane
};

}  // namespace cnrg
