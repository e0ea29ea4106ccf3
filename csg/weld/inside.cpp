#include "csg/weld/inside.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/base/hypotenuse.h"
#include "kernel/base/vectors.h"

namespace cnrg::welding {
namespace {

double square_distance_to_segment(const Vector& a, const Vector& b, const Vector& p) {
  const Vector along = minus(b, a), to = minus(p, a);
  const double square = dot(along, along), t = square > 0 ? std::clamp(dot(along, to) / square, 0.0, 1.0) : 0;
  const Vector off{to[0] - t * along[0], to[1] - t * along[1], to[2] - t * along[2]};
  return dot(off, off);
}

/// The two coordinates that a projection along the largest component of the normal keeps.
std::array<std::size_t, 2> kept(const Vector& normal) {
  const std::size_t axis = steepest_axis(normal);
  return {(axis + 1) % 3, (axis + 2) % 3};
}

/// True if a side of the first loop parts the two, but for a strip.
bool parts(const std::vector<Index>& a, const std::vector<Index>& b, const std::vector<Vector>& points,
           std::size_t u, std::size_t v, double d) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vector &from = points[a[i]], &to = points[a[i + 1 < a.size() ? i + 1 : 0]];
    const double x = to[v] - from[v], y = from[u] - to[u], length = hypotenuse(x, y);
    if (length == 0) continue;
    const auto range = [&](const std::vector<Index>& loop) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const Index p : loop) {
        const double at = (x * (points[p][u] - from[u]) + y * (points[p][v] - from[v])) / length;
        low = std::min(low, at);
        high = std::max(high, at);
      }
      return std::array{low, high};
    };
    const auto of_a = range(a), of_b = range(b);
    if (std::max(of_b[0] - of_a[1], of_a[0] - of_b[1]) > -d) return true;
  }
  return false;
}

}  // namespace

bool overlap(const WeldModel::Loops& a, const WeldModel::Loops& b, const std::vector<Vector>& points,
             const Vector& normal, double d) {
  const auto [u, v] = kept(normal);
  return !parts(a[0], b[0], points, u, v, d) && !parts(b[0], a[0], points, u, v, d);
}

bool is_in(const WeldModel::Loops& loops, const std::vector<Vector>& points, const Vector& normal, const Vector& p,
           double d) {
  const auto [u, v] = kept(normal);
  bool inside = false;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vector &a = points[loop[i]], &b = points[loop[i + 1 < loop.size() ? i + 1 : 0]];
      if (square_distance_to_segment(a, b, p) <= d * d) return true;
      if ((a[v] > p[v]) == (b[v] > p[v])) continue;
      if (p[u] < a[u] + (p[v] - a[v]) * ((b[u] - a[u]) / (b[v] - a[v]))) inside = !inside;
    }
  }
  return inside;
}

}  // namespace cnrg::welding
