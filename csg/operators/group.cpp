// Lookups in a group, and the selection of its point set.
#include "csg/operators/group.h"

#include <algorithm>

#include "kernel/selection/scratch.h"

namespace cnrg {
namespace {

// Sorts a list whose first `sorted` entries are sorted already.
template <class List>
void merge_tail(List& list, std::size_t sorted) {
  const auto tail = list.begin() + static_cast<std::ptrdiff_t>(sorted);
  std::sort(tail, list.end());
  std::inplace_merge(list.begin(), tail, list.end());
}

}  // namespace

std::uint32_t Group::region_of(RegionId r) const {
  const auto it = std::lower_bound(cells.begin(), cells.end(), r,
                                   [](const auto& cell, RegionId id) { return cell.first < id; });
  return it != cells.end() && it->first == r ? it->second : 0;
}

bool Group::has(FaceId f) const { return std::binary_search(faces.begin(), faces.end(), f); }
bool Group::has(EdgeId e) const { return std::binary_search(edges.begin(), edges.end(), e); }
bool Group::has(VertexId v) const { return std::binary_search(vertices.begin(), vertices.end(), v); }

Selection selection_of(const Complex& complex, const Group& group) {
  Selection out;
  out.regions = group.cells;
  const auto entities = static_cast<Component>(group.regions.size() + 1);
  for (FaceId f : group.faces) out.faces.push_back({f, entities});
  for (EdgeId e : group.edges) out.edges.push_back({e, entities});
  for (VertexId v : group.vertices) out.vertices.push_back({v, entities});

  // Cells in the interior of a region: reached from its 3-cells, and no entities.
  Marks<FaceId> faces(complex.face_count());
  Marks<EdgeId> edges(complex.edge_count());
  Marks<VertexId> vertices(complex.points.size());
  for (FaceId f : group.faces) faces[f] = 1;
  for (EdgeId e : group.edges) edges[e] = 1;
  for (VertexId v : group.vertices) vertices[v] = 1;
  const auto add_vertex = [&](VertexId v, Component c) {
    if (vertices[v] || complex.on_frame(v)) return;
    vertices[v] = 1;
    out.vertices.push_back({v, c});
  };
  const auto add_edge = [&](EdgeId e, Component c) {
    if (edges[e] || complex.on_frame(e)) return;
    edges[e] = 1;
    out.edges.push_back({e, c});
    for (VertexId v : complex.edge_ends[e]) add_vertex(v, c);
  };
  for (const auto& [cell, region] : group.cells) {
    for (HalfFace h : complex.region_faces[cell]) {
      const FaceId f = h.face();
      if (faces[f] || complex.on_frame(f)) continue;
      faces[f] = 1;
      out.faces.push_back({f, region});
      for (LoopId l : complex.face_loops[f]) {
        for (HalfEdge e : complex.loop[l]) add_edge(e.edge(), region);
      }
      for (VertexId v : complex.face_vertices[f]) add_vertex(v, region);
    }
    for (EdgeId e : complex.region_wires[cell]) add_edge(e, region);
    for (VertexId v : complex.region_vertices[cell]) add_vertex(v, region);
  }
  merge_tail(out.faces, group.faces.size());
  merge_tail(out.edges, group.edges.size());
  merge_tail(out.vertices, group.vertices.size());
  return out;
}

}  // namespace cnrg
