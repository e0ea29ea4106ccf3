#include "kernel/tetrahedra/bounds.h"

#include <algorithm>
#include <cmath>

#include "kernel/tetrahedra/shapes.h"

namespace cnrg {

bool Bounds::is_large(const Stars& mesh, const Stars::Tetrahedron& t) const {
  if (volume == 0 || t.region < 0) return false;
  const auto& c = t.corners;
  return volume_of(mesh.point(c[0]), mesh.point(c[1]), mesh.point(c[2]), mesh.point(c[3])) > volume;
}

double Bounds::cost(const Stars& mesh, const Stars::Tetrahedron& t) const {
  if (t.region < 0) return 0;
  if (t.shape < shape) return 1 + std::log(shape / std::max(t.shape, 1e-100)) / 3;
  if (is_large(mesh, t)) return 1;
  if (radius_edge == 0) return 0;
  const auto& c = t.corners;
  return radius_edge_of(mesh.point(c[0]), mesh.point(c[1]), mesh.point(c[2]), mesh.point(c[3])) > radius_edge;
}

}  // namespace cnrg
