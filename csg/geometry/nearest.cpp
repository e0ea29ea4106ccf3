// Feet of perpendiculars: of a point on a line and on a plane, and the common one of two lines.
#include "csg/geometry/nearest.h"

#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

NearestPoints nearest_pair(const RationalPoint& a, RationalPoint b) {
  const RationalPoint d = b - a;
  return {a, std::move(b), dot(d, d)};
}

}  // namespace

NearestPoints nearest_of_points(const RationalPoint& a, const RationalPoint& b) { return nearest_pair(a, b); }

std::optional<NearestPoints> nearest_in_segment(const RationalPoint& p, const RationalPoint& a,
                                                const RationalPoint& b) {
  const RationalPoint along = whole(b - a);
  const auto beyond = [&](const RationalPoint& end) { return sgn(dot(whole(p - end), along)); };
  if (beyond(a) <= 0 || beyond(b) >= 0) return {};
  return nearest_pair(p, a + Rational(dot(p - a, along) / dot(along, along)) * along);
}

std::optional<NearestPoints> nearest_in_triangle(const RationalPoint& p, const RationalPoint& a,
                                                 const RationalPoint& b, const RationalPoint& c) {
  const RationalPoint normal = cross(whole(b - a), whole(c - a));
  const auto beside = [&](const RationalPoint& from, const RationalPoint& to) {
    return dot(cross(whole(to - from), whole(p - from)), normal) < 0;
  };
  if (beside(a, b) || beside(b, c) || beside(c, a)) return {};
  const Rational height = dot(p - a, normal) / dot(normal, normal);
  return nearest_pair(p, p - height * normal);
}

std::optional<NearestPoints> nearest_in_segments(const RationalPoint& a, const RationalPoint& b,
                                                 const RationalPoint& c, const RationalPoint& d) {
  const RationalPoint u = whole(b - a), v = whole(d - c), normal = cross(u, v);
  if (is_zero(normal)) return {};
  // On which side of the end of one line the other line passes, as seen along the normal.
  const auto side = [&](const RationalPoint& from, const RationalPoint& to, const RationalPoint& line) {
    return sgn(dot(cross(whole(to - from), line), normal));
  };
  if (side(a, c, v) <= 0 || side(b, c, v) >= 0 || side(a, c, u) <= 0 || side(a, d, u) >= 0) return {};
  const RationalPoint w = c - a;
  const Rational square = dot(normal, normal);
  return nearest_pair(a + Rational(dot(cross(w, v), normal) / square) * u,
                      c + Rational(dot(cross(w, u), normal) / square) * v);
}

}  // namespace cnrg
