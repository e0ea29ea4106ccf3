// Points, planes and comparisons of the baseline, for double with a tolerance and for exact rationals alike.
//
// For doubles normals and directions have unit length, so one epsilon serves all comparisons: as it is for them,
// times the largest coordinate for lengths. Rationals are never normalized, and their tolerance is zero.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg::bench::mantyla {

template <class N>
using Vec = std::array<N, 3>;

template <class N>
Vec<N> operator-(const Vec<N>& a, const Vec<N>& b) {
  return {N(a[0] - b[0]), N(a[1] - b[1]), N(a[2] - b[2])};
}
template <class N>
Vec<N> operator+(const Vec<N>& a, const Vec<N>& b) {
  return {N(a[0] + b[0]), N(a[1] + b[1]), N(a[2] + b[2])};
}
template <class N>
Vec<N> operator*(const Vec<N>& a, const N& s) {
  return {N(a[0] * s), N(a[1] * s), N(a[2] * s)};
}
template <class N>
N dot(const Vec<N>& a, const Vec<N>& b) {
  return N(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}
template <class N>
Vec<N> cross(const Vec<N>& a, const Vec<N>& b) {
  return {N(a[1] * b[2] - a[2] * b[1]), N(a[2] * b[0] - a[0] * b[2]), N(a[0] * b[1] - a[1] * b[0])};
}

inline double approximate(double x) { return x; }
inline double approximate(const Rational& x) { return to_double(x); }
inline Rational exact(double x) { return from_double(x); }
inline const Rational& exact(const Rational& x) { return x; }
template <class N>
RationalPoint exact(const Vec<N>& p) {
  return {exact(p[0]), exact(p[1]), exact(p[2])};
}

/// normal . p = offset; the normal points out of the solid.
template <class N>
struct Plane {
  Vec<N> normal;
  N offset;
};

/// Comparisons with a tolerance.
template <class N>
struct Metric {
  N unit = 0;    ///< of products of unit vectors
  N length = 0;  ///< of lengths

  static int sign(const N& x, const N& tolerance) { return x > tolerance ? 1 : x < -tolerance ? -1 : 0; }
  int unit_sign(const N& x) const { return sign(x, unit); }
  int length_sign(const N& x) const { return sign(x, length); }
  bool null_unit(const Vec<N>& v) const { return !unit_sign(v[0]) && !unit_sign(v[1]) && !unit_sign(v[2]); }
  bool null_length(const Vec<N>& v) const {
    return !length_sign(v[0]) && !length_sign(v[1]) && !length_sign(v[2]);
  }
  bool equal(const Vec<N>& p, const Vec<N>& q) const { return null_length(p - q); }

  /// Of unit length where lengths are rounded anyway; the null vector stays.
  static Vec<N> direction(const Vec<N>& v) {
    if constexpr (std::is_floating_point_v<N>) {
      const N size = std::sqrt(dot(v, v));
      if (size > 0) return v * N(1 / size);
    }
    return v;
  }

  static N distance(const Plane<N>& plane, const Vec<N>& p) { return N(dot(plane.normal, p) - plane.offset); }
  int side(const Plane<N>& plane, const Vec<N>& p) const { return length_sign(distance(plane, p)); }

  bool on_segment(const Vec<N>& p, const Vec<N>& a, const Vec<N>& b) const {
    const Vec<N> along = direction(b - a), to = p - a;
    if (!null_length(cross(to, along))) return false;
    const N t = dot(to, along);
    return length_sign(t) >= 0 && length_sign(N(dot(b - a, along) - t)) >= 0;
  }
};

/// Newell's normal of a polygon, not normalized: twice its area long.
template <class N>
Vec<N> polygon_normal(const std::vector<Vec<N>>& polygon) {
  Vec<N> sum = {N(0), N(0), N(0)};
  for (std::size_t k = 2; k < polygon.size(); ++k)
    sum = sum + cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
  return sum;
}

enum class Where : std::uint8_t { outside, inside, on_edge, on_vertex };

/// A place in a plane against the loops of a face.
struct PlaneLocation {
  Where where = Where::outside;
  std::size_t segment = 0;  ///< the one that it is on, or whose start it is
};

template <class N>
struct Segment {
  const Vec<N>* a;
  const Vec<N>* b;
};

/// The axis that a plane is looked at along: of its normal's largest coordinate.
template <class N>
int dominant_axis(const Vec<N>& normal) {
  Vec<double> size;
  for (int k = 0; k < 3; ++k) size[k] = std::fabs(approximate(normal[k]));
  return size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
}

/// Locates a point of the plane: vertices first, then edges, then by crossings of a ray.
template <class N>
PlaneLocation locate(const Metric<N>& metric, const Vec<N>& normal, const std::vector<Segment<N>>& segments,
                     const Vec<N>& p) {
  for (std::size_t k = 0; k < segments.size(); ++k)
    if (metric.equal(p, *segments[k].a)) return {Where::on_vertex, k};
  for (std::size_t k = 0; k < segments.size(); ++k)
    if (metric.on_segment(p, *segments[k].a, *segments[k].b)) return {Where::on_edge, k};
  const int axis = dominant_axis(normal), x = (axis + 1) % 3, y = (axis + 2) % 3;
  bool inside = false;
  for (const auto& [a, b] : segments) {
    const bool up = (*b)[y] > p[y];
    if (((*a)[y] > p[y]) == up) continue;
    const N turn = ((*b)[x] - (*a)[x]) * (p[y] - (*a)[y]) - ((*b)[y] - (*a)[y]) * (p[x] - (*a)[x]);
    if ((turn > 0) == up) inside = !inside;
  }
  return {inside ? Where::inside : Where::outside, 0};
}

}  // namespace cnrg::bench::mantyla
