// Entities in their own right: of a group, and in the closure of nothing else of it.
#pragma once

#include <algorithm>

#include "kernel/complex/complex.h"

namespace cnrg {

/// `in_group(cell)` tells the group's faces, edges and vertices.
template <class InGroup>
bool is_free(const Complex& complex, EdgeId e, const InGroup& in_group) {
  const auto uses = complex.edge_uses[e];
  return in_group(e) && std::none_of(uses.begin(), uses.end(), [&](const FaceUse& u) { return in_group(u.face); });
}
template <class InGroup>
bool is_free(const Complex& complex, VertexId v, const InGroup& in_group) {
  const auto edges = complex.vertex_edges[v];
  const auto faces = complex.vertex_faces[v];
  return in_group(v) && std::none_of(edges.begin(), edges.end(), in_group) &&
         std::none_of(faces.begin(), faces.end(), in_group);
}

}  // namespace cnrg
