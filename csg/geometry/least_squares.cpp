// Heights h over coordinates u, v in the plane: of h = a u + b v the two normal equations, solved by Cramer's
// rule.
#include "csg/geometry/least_squares.h"

#include "kernel/exact/exact_vectors.h"

namespace cnrg {

RationalPoint least_squares_normal(std::span<const RationalPoint> points, const RationalPoint& start) {
  RationalPoint mean{0, 0, 0};
  for (const RationalPoint& p : points) mean = mean + p;
  mean = Rational(1, static_cast<unsigned>(points.size())) * mean;
  const RationalPoint axis = start[0] == 0 ? RationalPoint{1, 0, 0} : RationalPoint{0, 1, 0};
  const RationalPoint along_u = cross(start, axis), along_v = cross(start, along_u);
  Rational uu = 0, uv = 0, vv = 0, hu = 0, hv = 0;
  for (const RationalPoint& p : points) {
    const RationalPoint from = p - mean;
    const Rational u = dot(along_u, from), v = dot(along_v, from), h = dot(start, from);
    uu += u * u, uv += u * v, vv += v * v, hu += h * u, hv += h * v;
  }
  const Rational determinant = uu * vv - uv * uv;
  if (determinant == 0) return start;
  return start - Rational((hu * vv - hv * uv) / determinant) * along_u -
         Rational((hv * uu - hu * uv) / determinant) * along_v;
}

}  // namespace cnrg
