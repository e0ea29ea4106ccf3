// Whether a point, a segment or a circle of a plane is in a part of it.
#include "csg/carriers/flats.h"

#include <algorithm>
#include <cmath>

#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

/// On the line through a and b, between them or one of them.
bool on_segment(const RationalPoint& a, const RationalPoint& b, const RationalPoint& p) {
  return is_zero(cross(b - a, p - a)) && cnrg::dot(p - a, p - b) <= 0;
}

}  // namespace

bool Flat::meets(const RationalPoint& p, const RationalPoint& q) const {
  if (squares) {
    // The nearest point of the segment, and the farther one of its ends.
    const RationalPoint way = q - p;
    const Rational whole = dot(way, way);
    Rational part = whole == 0 ? Rational(0) : Rational(dot(center - p, way) / whole);
    part = std::max(Rational(0), std::min(Rational(1), part));
    const RationalPoint nearest = p + part * way - center;
    const Rational low = dot(nearest, nearest),
                   high = std::max(dot(p - center, p - center), dot(q - center, q - center));
    return low <= (*squares)[1] && high >= (*squares)[0];
  }
  return loops.empty() || polygon_meets(p, q);
}

bool Flat::meets_circle(const RationalPoint& middle, const Rational& radius) const {
  if (squares) {
    // Circles of radii r and s that are d apart have a point in common for |r - s| <= d <= r + s; of a ring all
    // radii count from the inner to the outer one.
    const RationalPoint off = middle - center;
    const double apart = std::sqrt(to_double(dot(off, off))), r = to_double(radius),
                 low = std::sqrt(to_double((*squares)[0])), high = std::sqrt(to_double((*squares)[1]));
    const double margin = 1e-9 * (apart + r + high);
    return apart <= r + high + margin && r <= apart + high + margin && low <= apart + r + margin;
  }
  if (loops.empty()) return true;
  const Rational square = radius * radius;
  bool inside = polygon_meets(middle, middle), outside = false;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const RationalPoint &a = loop[i], &b = loop[(i + 1) % loop.size()], way = b - a;
      outside = outside || dot(a - middle, a - middle) >= square;
      Rational part = dot(middle - a, way) / dot(way, way);
      part = std::max(Rational(0), std::min(Rational(1), part));
      const RationalPoint nearest = a + part * way - middle;
      inside = inside || dot(nearest, nearest) <= square;
    }
  }
  return inside && outside;
}

bool Flat::polygon_meets(const RationalPoint& p, const RationalPoint& q) const {
  // The side of c as seen from a to b.
  const auto side = [&](const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
    return sgn(dot(cross(b - a, c - a), normal));
  };
  // A ray from p along the plane, across a direction that no corner lies in, would do; here it is counted how
  // often the loops wind around p, along the largest two axes of the plane.
  std::size_t x = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (abs(normal[k]) > abs(normal[x])) x = k;
  }
  const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
  bool odd = false;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const RationalPoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if (on_segment(a, b, p) || on_segment(a, b, q)) return true;
      if (p != q && side(a, b, p) * side(a, b, q) <= 0 && side(p, q, a) * side(p, q, b) <= 0 &&
          !(is_zero(cross(b - a, q - p)) && side(a, b, p) != 0))
        return true;
      if ((a[z] > p[z]) == (b[z] > p[z])) continue;
      const Rational at = a[y] + (p[z] - a[z]) / (b[z] - a[z]) * (b[y] - a[y]);
      if (at > p[y]) odd = !odd;
    }
  }
  return odd;
}

}  // namespace cnrg
