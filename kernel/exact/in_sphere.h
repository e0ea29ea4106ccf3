// Is a point inside of the sphere through four others? The exact sign, and one that is never zero.
#pragma once

#include "kernel/exact/points.h"

namespace cnrg {

/// Of four points with orient3d(a, b, c, d) > 0: positive if e is inside of the sphere through them, negative if
/// it is outside. With two of the four exchanged the sign is the other one.
int in_sphere(const PointTable& t, VertexId a, VertexId b, VertexId c, VertexId d, VertexId e);

/// The same of points that never are on one sphere: each is lifted off it by less than all points with greater ids
/// are (devillers2011). Five points that are not in one plane always have a sign, and all these signs agree with
/// each other, so that the Delaunay tetrahedra of any points are unique. Zero where the five are in one plane.
int in_sphere_perturbed(const PointTable& t, VertexId a, VertexId b, VertexId c, VertexId d, VertexId e);

}  // namespace cnrg
