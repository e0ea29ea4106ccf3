// The removed entities of each operand become a group of their own, and are counted in the refinement of the two
// operands alone.
#include "csg/operators/removed_entities.h"

#include <algorithm>

namespace cnrg {
namespace {

void clear_entities(Group& group) {
  for_each_entity([](auto&... lists) { (lists.clear(), ...); }, group, group.origins);
  group.features.edges.clear(), group.features.vertices.clear();
}

template <class IdT>
using WithOrigins = std::vector<std::pair<IdT, LeafSetId>>;

template <class List>
void sort(List& list) {
  if (!std::is_sorted(list.begin(), list.end())) std::sort(list.begin(), list.end());
}

template <class IdT>
void take_flagged(const EntityMarks<IdT>& marks, std::uint8_t flag, const std::vector<IdT>& cells,
                  std::vector<IdT>& out) {
  for (const IdT cell : cells) {
    if (marks.has(cell, flag)) out.push_back(cell);
  }
}

}  // namespace

void RemovedEntities::count(std::span<const Group* const> next, std::map<std::size_t, std::size_t>& rows) {
  if (removed_.faces.empty() && removed_.edges.empty() && removed_.vertices.empty()) return;
  if (!pair_) pair_.emplace(complex_);
  take_held(), take_next(next);
  pair_->refine(held_, next_);
  const auto count = [&](auto& removed) {
    for (const auto& [cell, row] : removed) {
      if (pair_->is_first(cell)) ++rows[row];
    }
    removed.clear();
  };
  for_each_entity(count, removed_);
}

void RemovedEntities::take_held() {
  clear_entities(held_);
  const auto take = [&](const auto& removed, const auto& marks, auto& cells, auto& origins) {
    for (const auto& [cell, row] : removed) {
      if (marks.has(cell, kHeld)) cells.push_back(cell);
    }
    sort(cells);
    for (const auto cell : cells) origins.push_back(sets_(marks.origin.get(cell)));
  };
  for_each_entity(take, removed_, marks_, held_, held_.origins);
  take_features(kHeldFeature, held_);
}

void RemovedEntities::take_next(std::span<const Group* const> next) {
  clear_entities(next_);
  OfEntities<WithOrigins> taken;
  for (const Group* part : next) {
    LeafSetMap sets(part->origins.sets, next_.origins.sets);
    const auto take = [&](const auto& marks, const auto& cells, const auto& origins, auto& out) {
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (marks.has(cells[i], kRemoved)) out.emplace_back(cells[i], sets(origins[i]));
      }
    };
    for_each_entity(take, marks_, *part, part->origins, taken);
  }
  const auto put = [](auto& list, auto& cells, auto& origins) {
    sort(list);
    for (const auto& [cell, origin] : list) cells.push_back(cell), origins.push_back(origin);
  };
  for_each_entity(put, taken, next_, next_.origins);
  take_features(kNextFeature, next_);
}

void RemovedEntities::take_features(std::uint8_t flag, Group& of) const {
  take_flagged(marks_.edges, flag, of.edges, of.features.edges);
  take_flagged(marks_.vertices, flag, of.vertices, of.features.vertices);
}

}  // namespace cnrg
