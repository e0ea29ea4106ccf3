// Triangles for a planar face, for writers and meshers: exact, and without new points.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "kernel/exact/points.h"
#include "kernel/exact/predicates.h"

namespace cnrg {

/// Triangulates the planar region that closed loops of points enclose, as seen along `axes`.
///
/// A loop lists its corners without repeating the first. Loops may touch in vertices and walk an edge twice
/// (a slit, which then is an edge of the triangulation). A point is inside when a ray from it to infinity crosses
/// an odd number of edges, counting each as often as the loops walk it. So holes need no mark, and the direction
/// of the loops does not matter. `isolated` are points inside that become vertices of triangles.
///
/// Returns triangles that are counter-clockwise in the projection, that cover the inside exactly once, and
/// whose corners are the given points only. Where doubles suffice to prove that an edge is not Delaunay (in
/// the projection) it is flipped, so triangles are as round as the points allow; ties stay as they are.
/// Throws InvariantError when loops cross or two points coincide in the projection.
std::vector<std::array<VertexId, 3>> triangulate(const PointTable& points, Projection axes,
                                                 std::span<const std::vector<VertexId>> loops,
                                                 std::span<const VertexId> isolated = {});

}  // namespace cnrg
