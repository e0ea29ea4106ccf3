// Tetrahedra that conform to segments and triangles: constrained Delaunay tetrahedra (diazzi2023).
//
// Not all segments and triangles are edges and faces of the Delaunay tetrahedra of their points, and there are
// polyhedra that no tetrahedra fill without new points. New points on segments are enough: once every segment is
// made of edges, every triangle can be made of faces without any more of them (shewchuk1998). To remove what is in
// the way of a triangle and fill up the hole is then always possible; with coordinates in doubles it is not, since
// points on segments are off them. So new points are exact, and who writes doubles rounds them afterwards.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "kernel/base/error.h"
#include "kernel/base/progress.h"
#include "kernel/tetrahedra/tetrahedra.h"

namespace cnrg {

/// What tetrahedra are to conform to. Facets and segments may meet only in common corners and common sides, a side
/// of several triangles in a side of one; no point of the table may be inside of a segment or of a triangle.
struct Constraints {
  std::vector<std::array<VertexId, 2>> segments;
  /// Triangles in one plane, turned alike, that fill a polygon with or without holes and overlap nowhere. A side
  /// of two of them that is no segment does not bind: other faces may fill the polygon.
  std::vector<std::vector<std::array<VertexId, 3>>> facets;
};

struct ConstrainedTetrahedra {
  using Index = std::uint32_t;
  std::vector<std::array<VertexId, 4>> tetrahedra;  ///< det(b - a, c - a, d - a) > 0; they fill a box
  struct Segment {
    std::array<VertexId, 2> ends;  ///< in the direction of the input
    Index of;                      ///< place in the input
  };
  struct Triangle {
    std::array<VertexId, 3> corners;  ///< turned as those of the input
    Index of;                         ///< place of the facet
  };
  std::vector<Segment> segments;  ///< pieces, ascending by `of`
  std::vector<Triangle> triangles;
};

/// What shall be tetrahedra has features so near to each other, or so thin, that there are none in doubles, or
/// none of a sensible number: who can tells what is near to touch.
class NearFault : public InputError {
 public:
  using InputError::InputError;
};

/// Tetrahedra of the box around all points of the table, of which segments are unions of edges and facets of
/// faces. The corners of the box, then points on segments and on sides of facets are added to the table. Throws
/// InvariantError where the input is not as it should be, NearFault where edges so nearly touch that more than
/// `cuts` points for each point and edge were to be added, Stopped.
ConstrainedTetrahedra constrained_tetrahedra(PointTable& points, const Constraints& constraints,
                                             const Watch& watch, double cuts = 30);

}  // namespace cnrg
