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
  void add(FaceId f);
  void add(EdgeId e);
  void add(VertexId v) { wanted_.vertices[v] = 1; }

  /// Those of `g` that are wanted, with their features and origins: a group without regions, with the dominance of
  /// `g`.
  Group of(const Group& g) const;

 private:
  const Complex& complex_;
  OfEntities<Marks> wanted_;
};

}  // namespace cnrg
