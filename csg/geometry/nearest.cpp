// Feet of perpendiculars: of a point on a line and on a plane, and the common one of two lines.
#include "csg/geometry/nearest.h"

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
  const RationalPoint along = b - a;
  const Rational length = dot(along, along), foot = dot(p - a, along);
  if (foot <= 0 || foot >= length) return {};
  return nearest_pair(p, a + Rational(foot / length) * along);
}

std::optional<NearestPoints> nearest_in_triangle(const RationalPoint& p, const RationalPoint& a,
                                                 const RationalPoint& b, const RationalPoint& c) {
  const RationalPoint normal = cross(b - a, c - a);
  const auto beside = [&](const RationalPoint& from, const RationalPoint& to) {
    return sgn(dot(cross(to - from, p - from), normal)) < 0;
  };
  if (beside(a, b) || beside(b, c) || beside(c, a)) return {};
  const Rational height = dot(p - a, normal) / dot(normal, normal);
  return nearest_pair(p, p - height * normal);
}

std::optional<NearestPoints> nearest_in_segments(const RationalPoint& a, const RationalPoint& b,
                                                 const RationalPoint& c, const RationalPoint& d) {
  const RationalPoint u = b - a, v = d - c, w = c - a, normal = cross(u, v);
  const Rational square = dot(normal, normal);
  if (square == 0) return {};
  const Rational s = dot(cross(w, v), normal), t = dot(cross(w, u), normal);  // places, times `square`
  if (s <= 0 || s >= square || t <= 0 || t >= square) return {};
  return nearest_pair(a + Rational(s / square) * u, c + Rational(t / square) * v);
}

}  // namespace cnrg
