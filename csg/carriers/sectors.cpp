#include "csg/carriers/sectors.h"

#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

/// 0 for directions in [0, 180) degrees from `first`, 1 for the others.
int half_from(const RationalPoint& first, const RationalPoint& d, const RationalPoint& axis) {
  const int side = sgn(dot(cross(first, d), axis));
  return side > 0 || (side == 0 && dot(first, d) > 0) ? 0 : 1;
}

/// Negative if a comes before b, counter-clockwise from `first`.
int compare_from(const RationalPoint& first, const RationalPoint& a, const RationalPoint& b,
                 const RationalPoint& axis) {
  const int half_a = half_from(first, a, axis), half_b = half_from(first, b, axis);
  return half_a != half_b ? half_a - half_b : -sgn(dot(cross(a, b), axis));
}

bool inside(const Sector& sector, const RationalPoint& d, const RationalPoint& axis) {
  return !same_ray(d, sector.from) && compare_from(sector.from, d, sector.to, axis) < 0;
}

}  // namespace

bool same_ray(const RationalPoint& a, const RationalPoint& b) { return is_zero(cross(a, b)) && dot(a, b) > 0; }

bool overlap(const Sector& a, const Sector& b, const RationalPoint& axis) {
  if (a.whole || b.whole || same_ray(a.from, b.from) || same_ray(a.to, b.to)) return true;
  return inside(a, b.from, axis) || inside(a, b.to, axis) || inside(b, a.from, axis) || inside(b, a.to, axis);
}

bool meet(const Sector& a, const Sector& b, const RationalPoint& axis) {
  return overlap(a, b, axis) || same_ray(a.from, b.to) || same_ray(a.to, b.from);
}

}  // namespace cnrg
