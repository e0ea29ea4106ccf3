// A part of a group's entities, with all that a group knows of them.
#pragma once

#include "csg/operators/group.h"
#include "kernel/selection/scratch.h"

namespace cnrg {

/// Entities that are wanted, closed: what bounds one of them is wanted, too.
class WantedEntities {
 public:
  explicit WantedEntities(const Complex& complex);
  void add(FaceId f);
  void add(EdgeId e);
  void add(VertexId v) { vertices_[v] = 1; }

  /// Those of `g` that are wanted, with their features and origins: a group without regions, with the dominance of
  /// `g`.
  Group of(const Group& g) const;

 private:
  const Complex& complex_;
  Marks<FaceId> faces_;
  Marks<EdgeId> edges_;
  Marks<VertexId> vertices_;
};

}  // namespace cnrg
