#include "tests/oracles/point_sets.h"

#include <algorithm>

namespace cnrg::properties {
namespace {

using scenes::Polygon;

RationalPoint point_difference(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Rational exact_dot(const RationalPoint& a, const RationalPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
RationalPoint exact_cross(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
bool zero(const RationalPoint& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

/// Twice the vector area of a closed polygon.
RationalPoint vector_area(const Polygon& polygon) {
  RationalPoint sum{0, 0, 0};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint n = exact_cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    for (int k = 0; k < 3; ++k) sum[k] += n[k];
  }
  return sum;
}

}  // namespace

bool on_segment(const RationalPoint& a, const RationalPoint& b, const RationalPoint& p) {
  return zero(exact_cross(point_difference(b, a), point_difference(p, a))) &&
         exact_dot(point_difference(p, a), point_difference(p, b)) <= 0;
}

Side side_in_plane(const std::vector<Polygon>& loops, const RationalPoint& p) {
  const RationalPoint normal = vector_area(loops[0]);
  const int w = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2, u = (w + 1) % 3, v = (w + 2) % 3;
  bool inside = false;
  for (const Polygon& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const RationalPoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if (on_segment(a, b, p)) return Side::boundary;
      if ((a[v] > p[v]) == (b[v] > p[v])) continue;
      if (p[u] < a[u] + (p[v] - a[v]) * (b[u] - a[u]) / (b[v] - a[v])) inside = !inside;
    }
  }
  return inside ? Side::inside : Side::outside;
}

bool on_polygon(const std::vector<Polygon>& loops, const RationalPoint& p) {
  return exact_dot(vector_area(loops[0]), point_difference(p, loops[0][0])) == 0 &&
         side_in_plane(loops, p) != Side::outside;
}

Side side(const scenes::Solid& solid, const RationalPoint& p) {
  for (const Polygon& facet : solid)
    if (on_polygon({facet}, p)) return Side::boundary;
  // A ray that meets facets in their inside only.
  for (int attempt = 1;; ++attempt) {
    RationalPoint direction{attempt, Rational(attempt * attempt + 2) / 7, Rational(13) / (attempt + 16)};
    bool inside = false, generic = true;
    for (const Polygon& facet : solid) {
      const RationalPoint n = vector_area(facet);
      const Rational slope = exact_dot(n, direction), height = exact_dot(n, point_difference(facet[0], p));
      if (slope == 0) {
        generic = generic && height != 0;
        continue;
      }
      const Rational t = height / slope;
      if (t <= 0) continue;
      const RationalPoint q{p[0] + t * direction[0], p[1] + t * direction[1], p[2] + t * direction[2]};
      const Side at = side_in_plane({facet}, q);
      generic = generic && at != Side::boundary;
      if (at == Side::inside) inside = !inside;
    }
    if (generic) return inside ? Side::inside : Side::outside;
  }
}

bool on_entity(const scenes::Leaf& leaf, const RationalPoint& p) {
  return std::any_of(leaf.faces.begin(), leaf.faces.end(),
                     [&](const auto& f) { return on_polygon(f.loops, p); }) ||
         std::any_of(leaf.wires.begin(), leaf.wires.end(),
                     [&](const auto& w) { return on_segment(w[0], w[1], p); }) ||
         std::find(leaf.points.begin(), leaf.points.end(), p) != leaf.points.end();
}

bool contains(const scenes::Leaf& leaf, const RationalPoint& p) {
  return on_entity(leaf, p) || std::any_of(leaf.solids.begin(), leaf.solids.end(),
                                           [&](const auto& solid) { return side(solid, p) != Side::outside; });
}

Rational volume(const scenes::Solid& solid) {
  Rational sum = 0;
  for (const Polygon& facet : solid) sum += exact_dot(facet[0], vector_area(facet));
  return sum / 6;
}

bool convex(const scenes::Solid& solid) {
  for (const Polygon& facet : solid) {
    const RationalPoint n = vector_area(facet);
    for (const Polygon& other : solid)
      for (const RationalPoint& p : other)
        if (exact_dot(n, point_difference(p, facet[0])) > 0) return false;
  }
  return true;
}

RationalPoint middle(const scenes::Solid& solid) {
  RationalPoint sum{0, 0, 0};
  long count = 0;
  for (const Polygon& facet : solid)
    for (const RationalPoint& p : facet) {
      for (int k = 0; k < 3; ++k) sum[k] += p[k];
      ++count;
    }
  for (Rational& x : sum) x /= count;
  return sum;
}

}  // namespace cnrg::properties
