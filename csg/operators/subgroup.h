// A part of a group's entities, with all that a group knows of them.
#pragma once

#include "csg/operators/group.h"
#include "kernel/complex/by_dimension.h"
#include "kernel/selection/scratch.h"

namespace cnrg {

/// Entities that are wanted, closed: what bounds one of them is wanted, too.
class WantedEntities {
 public:
  explicit WantedEntities(const Complex& complex) : complex_(complex), wanted_(complex) {}
  template <class IdT>
  void add(IdT cell) {
    const auto want = [&](auto of) { list_for(wanted_, of)[of] = 1; };
    want(cell);
    if constexpr (!std::is_same_v<IdT, VertexId>) for_each_bounding(complex_, cell, want);
  }

  /// Those of `g` that are wanted, with their features and origins: a group without regions, with the dominance of
  /// `g`.
  Group of(const Group& g) const;

 private:
  const Complex& complex_;
  OfEntities<Marks> wanted_;
};

}  // namespace cnrg
