// Does an edge or a vertex lie in the closure of something?
#pragma once

#include <algorithm>

#include "kernel/complex/complex.h"

namespace cnrg {

/// True if a face around the edge `is` (a predicate of cells).
template <class Is>
bool bounds_any(const Complex& complex, EdgeId e, const Is& is) {
  const auto uses = complex.edge_uses[e];
  return std::any_of(uses.begin(), uses.end(), [&](const FaceUse& use) { return is(use.face); });
}
/// True if an edge around the vertex `is`, or a face in which it lies as an isolated point.
template <class Is>
bool bounds_any(const Complex& complex, VertexId v, const Is& is) {
  const auto edges = complex.vertex_edges[v];
  const auto faces = complex.vertex_faces[v];
  return std::any_of(edges.begin(), edges.end(), is) || std::any_of(faces.begin(), faces.end(), is);
}

}  // namespace cnrg
