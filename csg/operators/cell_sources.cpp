// Of a group only entities are asked about, and these have origins. Components may be open: for a cell that they
// lack, the active cells around it answer.
#include "csg/operators/cell_sources.h"

#include <algorithm>

#include "csg/operators/component_lists.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

// Faces and edges that bound something kept are entities: a group is closed, and walls in a region are entities.
template <class IdT>
void leaves_of_entity(const std::vector<IdT>& list, const std::vector<LeafSetId>& origins, const LeafSets& sets,
                      IdT cell, std::vector<LeafId>& out) {
  const auto it = std::lower_bound(list.begin(), list.end(), cell);
  require(it != list.end() && *it == cell, "a group was asked for the origin of a cell that is no entity");
  const auto leaves = sets[origins[static_cast<std::size_t>(it - list.begin())]];
  out.assign(leaves.begin(), leaves.end());
}

template <class IdT>
bool add_leaves(const std::vector<std::pair<IdT, Component>>& list, const std::vector<LeafSetId>& origins,
                const LeafSets& sets, IdT cell, std::vector<LeafId>& out) {
  const std::size_t k = place_in(list, cell);
  if (k == list.size()) return false;
  const auto leaves = sets[origins[k]];
  out.insert(out.end(), leaves.begin(), leaves.end());
  return true;
}

}  // namespace

void GroupSources::leaves_of(FaceId f, std::vector<LeafId>& out) const {
  leaves_of_entity(group_.faces, group_.origins.faces, group_.origins.sets, f, out);
}

void GroupSources::leaves_of(EdgeId e, std::vector<LeafId>& out) const {
  leaves_of_entity(group_.edges, group_.origins.edges, group_.origins.sets, e, out);
}

void ComponentSources::leaves_of(FaceId f, std::vector<LeafId>& out) const {
  out.clear();
  if (add_leaves(x_.selection.faces, x_.origins.faces, x_.origins.sets, f, out)) return;
  for (const RegionId r : complex_.face_regions[f]) {
    add_leaves(x_.selection.regions, x_.origins.regions, x_.origins.sets, r, out);
  }
  sort_unique(out);
}

void ComponentSources::leaves_of(EdgeId e, std::vector<LeafId>& out) const {
  out.clear();
  if (add_leaves(x_.selection.edges, x_.origins.edges, x_.origins.sets, e, out)) return;
  std::vector<RegionId> regions;
  for (const FaceUse& use : complex_.edge_uses[e]) {
    add_leaves(x_.selection.faces, x_.origins.faces, x_.origins.sets, use.face, out);
  }
  complex_.star_regions(e, regions);
  for (const RegionId r : regions) add_leaves(x_.selection.regions, x_.origins.regions, x_.origins.sets, r, out);
  sort_unique(out);
}

}  // namespace cnrg
