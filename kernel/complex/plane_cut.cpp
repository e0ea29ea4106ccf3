#include "kernel/complex/plane_cut.h"

#include <algorithm>

#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {

std::vector<RationalPoint> cut(const ExactHalfspace& plane, const ExactBox& box) {
  std::vector<RationalPoint> points;
  const auto add = [&](const RationalPoint& p) {
    if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
  };
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t bit = 1; bit < 8; bit *= 2) {
      if (i & bit) continue;
      const RationalPoint a = box.corner(i), b = box.corner(i | bit);
      const Rational at_a = dot(plane.normal, a) - plane.offset, at_b = dot(plane.normal, b) - plane.offset;
      if (at_a == 0) add(a);
      if (at_b == 0) add(b);
      if (sgn(at_a) * sgn(at_b) < 0) add(a + Rational(at_a / (at_a - at_b)) * (b - a));
    }
  }
  require(points.size() >= 3, "cut: the plane does not meet the inside of the box");
  // A convex polygon: its corners are sorted by their direction from their mean, by half-planes and turns.
  RationalPoint sum{0, 0, 0};
  for (const RationalPoint& p : points) sum = sum + p;
  const RationalPoint center = Rational(1, to_integer(points.size())) * sum;
  const RationalPoint start = points[0] - center;
  const auto half = [&](const RationalPoint& v) {
    const int side = sgn(dot(plane.normal, cross(start, v)));
    return side > 0 || (side == 0 && dot(start, v) > 0) ? 0 : 1;
  };
  std::sort(points.begin(), points.end(), [&](const RationalPoint& p, const RationalPoint& q) {
    const RationalPoint u = p - center, v = q - center;
    if (half(u) != half(v)) return half(u) < half(v);
    return dot(plane.normal, cross(u, v)) > 0;
  });
  return points;
}

}  // namespace cnrg
