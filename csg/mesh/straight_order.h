// Second order without curved surfaces: a node in the middle of each straight edge.
#pragma once

#include "csg/mesh/mesh.h"

namespace cnrg {

/// Adds the middle of every edge of a simplex to the points and to Mesh::middles; simplices stay as they are.
/// Middles are rounded to doubles, so each tetrahedron is proven to be turned right everywhere all the same
/// (second_order.h). Throws InputError for a mesh with one so flat that it is not proven.
void add_straight_middles(Mesh& mesh);

/// The edges of all simplices, the lower number first; ascending.
std::vector<std::array<Mesh::Index, 2>> edges_of(const Mesh& mesh);

}  // namespace cnrg
