// Triangles for a planar face, for writers and meshers: exact, and without new points.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "kernel/base/products.h"
#include "kernel/exact/points.h"
#include "kernel/exact/predicates.h"

namespace cnrg {

/// Along the steepest axis of a normal, which points to who looks.
template <class N>
Projection seen_along(const std::array<N, 3>& normal) {
  const std::size_t axis = steepest_axis(normal);
  const Projection axes{static_cast<std::uint8_t>((axis + 1) % 3), static_cast<std::uint8_t>((axis + 2) % 3)};
  return normal[axis] < 0 ? Projection{axes.v, axes.u} : axes;
}

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

/// Lawson's flips: triangles (p, a, b) and (q, b, a) whose common edge no loop walks meet in pq instead where
/// `is_better(p, a, q, b)`, which has to see that the quad is convex. There is a bound on their number, as wishes
/// may have no end.
void flip_edges(std::vector<std::array<VertexId, 3>>& triangles, std::span<const std::vector<VertexId>> loops,
                const std::function<bool(VertexId p, VertexId a, VertexId q, VertexId b)>& is_better);

}  // namespace cnrg
