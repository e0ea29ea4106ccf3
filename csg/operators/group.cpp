// Lookups in a group, and the selection of its point set.
#include "csg/operators/group.h"

#include <algorithm>

#include "csg/operators/component_lists.h"
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

std::uint32_t Group::region_of(RegionId r) const { return component_in(cells, r); }

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
  const auto add = [&](const auto& self, auto cell, Component c) {
    if (list_for(seen, cell)[cell] || complex.on_frame(cell)) return;
    list_for(seen, cell)[cell] = 1;
    list_for(out, cell).push_back({cell, c});
    if constexpr (!std::is_same_v<decltype(cell), VertexId>)
      for_each_bounding(complex, cell, [&](auto of) { self(self, of, c); });
  };
  for (const auto& [cell, region] : group.cells)
    for_each_bounding(complex, cell, [&](auto of) { add(add, of, region); });
  for_each_entity([](auto& list, const auto& cells) { merge_tail(list, cells.size()); }, out, group);
  return out;
}

}  // namespace cnrg
