#include "kernel/tetrahedra/shapes.h"

#include <algorithm>
#include <cmath>

#include "kernel/base/vectors.h"

namespace cnrg {
namespace {

/// From a to the other corners.
struct Edges {
  CornerPoint u, v, w;
  Edges(const CornerPoint& a, const CornerPoint& b, const CornerPoint& c, const CornerPoint& d) {
    for (std::size_t k = 0; k < 3; ++k) u[k] = b[k] - a[k], v[k] = c[k] - a[k], w[k] = d[k] - a[k];
  }
  double determinant() const { return dot(u, cross(v, w)); }
};

}  // namespace

double volume_of(const CornerPoint& a, const CornerPoint& b, const CornerPoint& c, const CornerPoint& d) {
  return std::fabs(Edges(a, b, c, d).determinant()) / 6;
}

LongestEdge longest_edge_of(const CornerPoint& a, const CornerPoint& b, const CornerPoint& c,
                            const CornerPoint& d) {
  LongestEdge longest{-1, {}};
  const std::array corners{&a, &b, &c, &d};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const CornerPoint &p = *corners[i], &q = *corners[j], along = minus(p, q);
      if (const double squared = dot(along, along); squared > longest.length)
        longest = {squared, {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2}};
    }
  }
  longest.length = std::sqrt(longest.length);
  return longest;
}

double shape_of(const CornerPoint& a, const CornerPoint& b, const CornerPoint& c, const CornerPoint& d) {
  const Edges e(a, b, c, d);
  const double det = e.determinant();
  double squares = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double p = e.v[k] - e.u[k], q = e.w[k] - e.u[k], r = e.w[k] - e.v[k];
    squares += e.u[k] * e.u[k] + e.v[k] * e.v[k] + e.w[k] * e.w[k] + p * p + q * q + r * r;
  }
  return squares > 0 ? 12 * std::cbrt(det * det / 4) / squares : 0;
}

bool is_flat(const CornerPoint& a, const CornerPoint& b, const CornerPoint& c, const CornerPoint& d) {
  constexpr double kFlat = 1.0 / 64;
  const Edges e(a, b, c, d);
  const CornerPoint uv = cross(e.u, e.v), vw = cross(e.v, e.w), wu = cross(e.w, e.u);
  CornerPoint last;  // of the face opposite to a
  double longest = std::max({dot(e.u, e.u), dot(e.v, e.v), dot(e.w, e.w)}), uv2 = 0, vw2 = 0, wu2 = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    last[k] = uv[k] + vw[k] + wu[k];
    uv2 += (e.v[k] - e.u[k]) * (e.v[k] - e.u[k]);
    vw2 += (e.w[k] - e.v[k]) * (e.w[k] - e.v[k]);
    wu2 += (e.u[k] - e.w[k]) * (e.u[k] - e.w[k]);
  }
  longest = std::max({longest, uv2, vw2, wu2});
  const double area = std::max({dot(uv, uv), dot(vw, vw), dot(wu, wu), dot(last, last)});
  return std::fabs(e.determinant()) < kFlat * std::sqrt(area * longest);
}

double radius_edge_of(const CornerPoint& a, const CornerPoint& b, const CornerPoint& c, const CornerPoint& d) {
  const Edges e(a, b, c, d);
  const CornerPoint vw = cross(e.v, e.w), wu = cross(e.w, e.u), uv = cross(e.u, e.v);
  const double u = dot(e.u, e.u), v = dot(e.v, e.v), w = dot(e.w, e.w);
  CornerPoint center;
  double shortest = std::min({u, v, w}), uv2 = 0, uw2 = 0, vw2 = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    center[k] = u * vw[k] + v * wu[k] + w * uv[k];
    uv2 += (e.v[k] - e.u[k]) * (e.v[k] - e.u[k]);
    uw2 += (e.w[k] - e.u[k]) * (e.w[k] - e.u[k]);
    vw2 += (e.w[k] - e.v[k]) * (e.w[k] - e.v[k]);
  }
  shortest = std::min({shortest, uv2, uw2, vw2});
  return std::sqrt(dot(center, center) / shortest) / std::fabs(2 * dot(e.u, vw));
}

}  // namespace cnrg
