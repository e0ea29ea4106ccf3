// Tetrahedra that conform to segments and triangles.
//
// Not all segments and triangles are edges and faces of the Delaunay tetrahedra of their points, and there are
// polyhedra that no tetrahedra fill without new points. To make segments Delaunay by new points and fill up what
// is left, as constrained Delaunay tetrahedra do (diazzi2023), needs so many points near small angles that it may
// not end in any useful time. So what is missing is cut into the tetrahedra that there are, which always ends;
// shapes are the care of who improves them. New points on segments and facets are off them in doubles, and are
// exact.
#pragma once

#include <array>
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

/// What shall be tetrahedra has features so near to each other, or so thin, that there are none in doubles: who
/// can tells what is near to touch.
class NearFault : public InputError {
 public:
  using InputError::InputError;
};

enum class NewPoints {
  exact,
  doubles,  ///< moved to doubles, so that segments and facets are bent as little as these tell; or NearFault
};

/// Tetrahedra of the box around all points of the table, of which segments are unions of edges and facets of
/// faces. The corners of the box, then points are added to the table, of which some are in no tetrahedron. Throws
/// InvariantError where the input is not as it should be, NearFault, Stopped.
ConstrainedTetrahedra constrained_tetrahedra(PointTable& points, const Constraints& constraints,
                                             const Watch& watch, NewPoints how = NewPoints::exact);

}  // namespace cnrg
