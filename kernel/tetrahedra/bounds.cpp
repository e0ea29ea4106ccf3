#include "kernel/tetrahedra/bounds.h"

#include <algorithm>
#include <cmath>

namespace cnrg {

bool is_too_long(const CornerPoint& a, const CornerPoint& b, const CornerPoint& c, const CornerPoint& d,
                 std::int32_t region, const WantedLength& wanted) {
  const LongestEdge edge = longest_edge_of(a, b, c, d);
  return edge.length > kLongestEdge * wanted(edge.middle, region);
}

bool Bounds::is_large(const Stars& mesh, const Stars::Tetrahedron& t) const {
  if (t.region < 0 || (volume == 0 && !length)) return false;
  const Stars::Point &a = mesh.point(t.corners[0]), &b = mesh.point(t.corners[1]), &c = mesh.point(t.corners[2]),
                     &d = mesh.point(t.corners[3]);
  if (volume > 0 && volume_of(a, b, c, d) > volume) return true;
  return length && is_too_long(a, b, c, d, t.region, length);
}

double Bounds::cost(const Stars& mesh, const Stars::Tetrahedron& t) const {
  constexpr double kLarge = 1000;
  if (t.region < 0) return 0;
  const double large = is_large(mesh, t) ? kLarge : 0;
  if (t.shape < shape) return large + 1 + std::log(shape / std::max(t.shape, 1e-100)) / 3;
  if (large > 0 || radius_edge == 0) return large;
  const auto& c = t.corners;
  return radius_edge_of(mesh.point(c[0]), mesh.point(c[1]), mesh.point(c[2]), mesh.point(c[3])) > radius_edge;
}

}  // namespace cnrg
