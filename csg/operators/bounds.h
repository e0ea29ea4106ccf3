// Does an edge or a vertex lie in the closure of something?
#pragma once

#include <algorithm>

#include "kernel/complex/complex.h"

namespace cnrg {

/// True if the predicate `is` holds for a face around the edge.
template <class Is>
bool bounds_any(const Complex& complex, EdgeId e, const Is& is) {
  const auto uses = complex.edge_uses[e];
  return std::any_of(uses.begin(), uses.end(), [&](const FaceUse& use) { return is(use.face); });
}
/// True if it holds for an edge at the vertex, or for a face in which the vertex lies as an isolated point.
template <class Is>
bool bounds_any(const Complex& complex, VertexId v, const Is& is) {
  const auto edges = complex.vertex_edges[v];
  const auto faces = complex.vertex_faces[v];
  return std::any_of(edges.begin(), edges.end(), is) || std::any_of(faces.begin(), faces.end(), is);
}

}  // namespace cnrg
