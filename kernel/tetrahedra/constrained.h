// Tetrahedra that conform to segments and triangles: constrained Delaunay tetrahedra (diazzi2023).
//
// Not all segments and triangles are edges and faces of the Delaunay tetrahedra of their points, and there are
// polyhedra that no tetrahedra fill without new points. New points on segments are enough: once every segment is made
// of edges, every triangle can be made of faces without any more of them (shewchuk1998). To remove what is in the way
// of a triangle and fill up the hole is then always possible; with coordinates in doubles it is not, since points on
// segments are off them. So new points are exact, and who writes doubles rounds them afterwards.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "kernel/base/progress.h"
#include "kernel/tetrahedra/tetrahedra.h"

namespace cnrg {

struct ConstrainedTetrahedra {
  using Index = std::uint32_t;
  std::vector<std::array<VertexId, 4>> tetrahedra;  ///< det(b - a, c - a, d - a) > 0; they fill a box
  struct Segment {
    std::array<VertexId, 2> ends;  ///< from its first end to its second one
    Index of;                      ///< place in the input
  };
  struct Triangle {
    std::array<VertexId, 3> corners;  ///< turned as that of the input
    Index of;
  };
  std::vector<Segment> segments;    ///< pieces, ascending by `of`
  std::vector<Triangle> triangles;
};

/// Tetrahedra of the box around all points of the table, of which segments and triangles are unions of edges and of
/// faces. These may meet only in common corners and sides, and no point may be inside of one; then it does not fail.
/// The corners of the box, then points on segments and sides are added to the table. Throws InvariantError where the
/// input is not so, Stopped.
ConstrainedTetrahedra constrained_tetrahedra(PointTable& points, std::span<const std::array<VertexId, 2>> segments,
                                             std::span<const std::array<VertexId, 3>> triangles, const Watch& watch);

}  // namespace cnrg
