#include "csg/weld/inside.h"

#include <algorithm>
#include <cmath>

namespace cnrg::welding {
namespace {

double square_distance_to_segment(const Vector& a, const Vector& b, const Vector& p) {
  Vector along, to;
  double length = 0, at = 0;
  for (int k = 0; k < 3; ++k) {
    along[k] = b[k] - a[k];
    to[k] = p[k] - a[k];
    length += along[k] * along[k];
    at += along[k] * to[k];
  }
  const double t = length > 0 ? std::clamp(at / length, 0.0, 1.0) : 0;
  double square = 0;
  for (int k = 0; k < 3; ++k) square += (to[k] - t * along[k]) * (to[k] - t * along[k]);
  return square;
}

}  // namespace

bool is_in(const WeldModel::Loops& loops, const std::vector<Vector>& points, const Vector& normal, const Vector& p,
           double d) {
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
  }
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
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
