// Lookups in a group, and the selection of its point set.
#include "csg/operators/group.h"

#include <algorithm>

#include "kernel/complex/by_dimension.h"
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
  OfEntities<Marks> seen(complex);
  const auto add_entities = [&](const auto& cells, auto& marks, auto& list) {
    for (const auto cell : cells) {
      marks[cell] = 1;
      list.push_back({cell, entities});
    }
  };
  for_each_entity(add_entities, group, seen, out);

  // Cells in the interior of a region: reached from its 3-cells, and no entities.
  const auto add = [&](auto cell, Component c) {
    if (list_for(seen, cell)[cell] || complex.on_frame(cell)) return false;
    list_for(seen, cell)[cell] = 1;
    list_for(out, cell).push_back({cell, c});
    return true;
  };
  const auto add_edge = [&](EdgeId e, Component c) {
    if (!add(e, c)) return;
    for (VertexId v : complex.edge_ends[e]) add(v, c);
  };
  for (const auto& [cell, region] : group.cells) {
    for (HalfFace h : complex.region_faces[cell]) {
      const FaceId f = h.face();
      if (!add(f, region)) continue;
      for (LoopId l : complex.face_loops[f]) {
        for (HalfEdge e : complex.loop[l]) add_edge(e.edge(), region);
      }
      for (VertexId v : complex.face_vertices[f]) add(v, region);
    }
    for (EdgeId e : complex.region_wires[cell]) add_edge(e, region);
    for (VertexId v : complex.region_vertices[cell]) add(v, region);
  }
  for_each_entity([](auto& list, const auto& cells) { merge_tail(list, cells.size()); }, out, group);
  return out;
}

}  // namespace cnrg
