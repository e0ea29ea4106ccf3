// The entities that a step of a fold removes, counted by row in cells of the refinement of its two operands.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "csg/operators/entity_marks.h"
#include "csg/operators/group.h"
#include "csg/operators/pair_refinement.h"

namespace cnrg {

class RemovedEntities {
 public:
  /// References are kept: `sets` has the origins of held.
  RemovedEntities(const Complex& complex, const OfEntities<EntityMarks>& marks, const LeafUnions& sets)
      : complex_(complex), marks_(marks), sets_(sets, held_.origins.sets) {}

  template <class IdT>
  void add(IdT cell, std::size_t row) {
    list_for(removed_, cell).emplace_back(cell, row);
  }

  /// Adds to the counts of rows what was added since the last time. Marks are those of held and next, with what is
  /// removed, which is open in them: with a cell all entities in its star went.
  void count(std::span<const Group* const> next, std::map<std::size_t, std::size_t>& rows);

 private:
  template <class IdT>
  using Rows = std::vector<std::pair<IdT, std::size_t>>;

  void take_held();
  void take_next(std::span<const Group* const> next);
  void take_features(std::uint8_t flag, Group& of) const;

  const Complex& complex_;
  const OfEntities<EntityMarks>& marks_;
  OfEntities<Rows> removed_;
  Group held_, next_;  // what of them is removed; their sets of leaves stay from step to step
  LeafSetMap<LeafUnions, LeafSets> sets_;
  std::optional<PairRefinement> pair_;
};

}  // namespace cnrg
