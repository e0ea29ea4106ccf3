// Vertices around which triangles certainly meet in nothing but the corners and sides that they share.
//
// Let every edge at a vertex v have exactly two sides of triangles around, in opposite directions: then the
// triangles at v form cycles around it (*fans*). If all their normals have the same sign along one axis, they
// project along it without turning over, each onto a sector at the image of v. Sectors of one cycle follow each
// other in one direction; if together they go around once, there is one cycle and the sectors tile the plane. Two
// triangles then meet in v or in the side that they share, and nowhere else. Sectors are counted where they pass
// the direction of the first axis of the projection: comparisons of coordinates decide, no predicate is asked.
#pragma once

#include <vector>

#include "kernel/refine/input.h"

namespace cnrg {

/// By vertex: 1 if the faces around it are such a fan of triangles, as far as filters and bounds of coordinates
/// say.
std::vector<char> embedded_fans(const RefineInput& input);

}  // namespace cnrg
