// Marks on the cells of the complex, then one pass over the lists of the group.
#include "csg/operators/subgroup.h"

namespace cnrg {

WantedEntities::WantedEntities(const Complex& complex)
    : complex_(complex),
      faces_(complex.face_count()),
      edges_(complex.edge_count()),
      vertices_(complex.points.size()) {}

void WantedEntities::add(FaceId f) {
  faces_[f] = 1;
  for (const LoopId l : complex_.face_loops[f]) {
    for (const HalfEdge h : complex_.loop[l]) {
      edges_[h.edge()] = 1;
      vertices_[complex_.origin(h)] = 1;
    }
  }
  for (const VertexId v : complex_.face_vertices[f]) vertices_[v] = 1;
}

void WantedEntities::add(EdgeId e) {
  edges_[e] = 1;
  for (const VertexId v : complex_.edge_ends[e]) vertices_[v] = 1;
}

Group WantedEntities::of(const Group& g) const {
  Group out;
  LeafSetMap map(g.origins.sets, out.origins.sets);
  const auto pick = [&](const auto& from, const auto& from_origins, const auto& marks, auto& to, auto& origins) {
    for (std::size_t k = 0; k < from.size(); ++k) {
      if (!marks[from[k]]) continue;
      to.push_back(from[k]);
      origins.push_back(map(from_origins[k]));
    }
  };
  pick(g.edges, g.origins.edges, edges_, out.edges, out.origins.edges);
  pick(g.vertices, g.origins.vertices, vertices_, out.vertices, out.origins.vertices);
  pick(g.faces, g.origins.faces, faces_, out.faces, out.origins.faces);
  const auto still = [](const auto& from, const auto& marks, auto& to) {
    for (const auto id : from) {
      if (marks[id]) to.push_back(id);
    }
  };
  still(g.features.edges, edges_, out.features.edges);
  still(g.features.vertices, vertices_, out.features.vertices);
  out.dominance = g.dominance;
  return out;
}

}  // namespace cnrg
