// How near what is seen lies, as a function of the place in the picture.
#pragma once

#include <cmath>
#include <limits>
#include <span>

#include "kernel/exact/points.h"
#include "kernel/exact/rational.h"

namespace cnrg {

/// A place in the picture, exactly and as doubles.
struct PicturePlace {
  ExactPoint exact;  ///< z is 0
  std::array<double, 2> near{};
  explicit PicturePlace(ExactPoint p) : exact(std::move(p)) {
    const RationalPoint q = exact.rational();
    near = {to_double(q[0]), to_double(q[1])};
  }
};

/// z = a x + b y + c: the depth of a facet over the picture, or of a segment over its own line there.
class Depth {
 public:
  Depth(Rational a, Rational b, Rational c) : exact_{std::move(a), std::move(b), std::move(c)} {
    for (std::size_t k = 0; k < 3; ++k) near_[k] = to_double(exact_[k]);
  }
  /// The plane with this normal through p; normal[2] is not 0.
  static Depth of_plane(const RationalPoint& normal, const RationalPoint& p) {
    const Rational c = p[2] + (normal[0] * p[0] + normal[1] * p[1]) / normal[2];
    return {-normal[0] / normal[2], -normal[1] / normal[2], c};
  }
  /// The line through two points that differ in x or y.
  static Depth of_line(const RationalPoint& p, const RationalPoint& q) {
    const bool along_x = p[0] != q[0];
    const std::size_t k = along_x ? 0 : 1;
    const Rational slope = (q[2] - p[2]) / (q[k] - p[k]);
    return {along_x ? slope : Rational(0), along_x ? Rational(0) : slope, p[2] - slope * p[k]};
  }

  /// 1: this one is nearer to who looks, -1: the other one, 0: both are one point.
  int compare(const Depth& other, const PicturePlace& at) const {
    // Each term is the product of two numbers that were rounded once; so no sum is off by more than this.
    double sum = 0, size = std::numeric_limits<double>::min() * 64;
    for (std::size_t k = 0; k < 3; ++k) {
      const double place = k < 2 ? at.near[k] : 1;
      sum += near_[k] * place - other.near_[k] * place;
      size += std::abs(near_[k] * place) + std::abs(other.near_[k] * place);
    }
    const double bound = 16 * std::numeric_limits<double>::epsilon() * size;
    if (sum > bound) return 1;
    if (sum < -bound) return -1;
    return sgn((exact_[0] - other.exact_[0]) * at.exact.x + (exact_[1] - other.exact_[1]) * at.exact.y +
               (exact_[2] - other.exact_[2]) * at.exact.w);
  }

 private:
  std::array<Rational, 3> exact_;
  std::array<double, 3> near_{};
};

}  // namespace cnrg
