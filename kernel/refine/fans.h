// Vertices around which triangles certainly meet in nothing but the corners and sides that they share.
//
// Let every edge at a vertex v have exactly two sides of triangles around, in opposite directions: then the
// triangles at v form cycles around it (*fans*). If all their normals have the same sign along one axis, they
// project along it without turning over, each onto a sector at the image of v. Sectors of one cycle follow each
// other in one direction; if together they go around once, there is one cycle and the sectors tile the plane. Two
// triangles then meet in v or in the side that they share, and nowhere else. Sectors are counted where they pass
// the direction of the first axis of the projection: comparisons of coordinates decide, no predicate is asked.
#pragma once

#include <utility>
#include <vector>

#include "kernel/refine/input.h"

namespace cnrg {

/// By vertex: 1 if the faces around it are such a fan of triangles, as far as filters and bounds of coordinates
/// say.
std::vector<char> embedded_fans(const RefineInput& input);

// Fans (fans.h) of so many triangles that to take all pairs of them, if only for a glance, is too much: the side
// of a cone, the poles of a ball. Their triangles meet in the middle of the fan and in the sides that neighbours
// share, so all that is left to find is which neighbours are coplanar.

class LargeFans {
 public:
  /// `fans` by vertex, of `embedded_fans`. Those found here that look along no axis are added to it.
  LargeFans(const RefineInput& input, std::vector<char>& fans);
  bool at(VertexId v) const { return large_[v.index()] != 0; }
  /// The faces on both sides of each edge from the middle of such a fan.
  std::vector<std::pair<SourceId, SourceId>> neighbours() const;

 private:
  const RefineInput& in_;
  std::vector<char> large_;
};

}  // namespace cnrg
