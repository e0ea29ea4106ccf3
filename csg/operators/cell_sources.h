// The leaves that the cells of a value came from, as `simplify` asks for them.
//
// A cell that is not active (the boundary of an open set) came from what the active cells of its star came from.
#pragma once

#include "csg/operators/components.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

/// Both keep references to their arguments.
class GroupSources : public CellSources {
 public:
  explicit GroupSources(const Group& group) : group_(group) {}
  void leaves_of(FaceId f, std::vector<LeafId>& out) const override;
  void leaves_of(EdgeId e, std::vector<LeafId>& out) const override;

 private:
  const Group& group_;
};

class ComponentSources : public CellSources {
 public:
  ComponentSources(const Complex& complex, const Components& x) : complex_(complex), x_(x) {}
  void leaves_of(FaceId f, std::vector<LeafId>& out) const override;
  void leaves_of(EdgeId e, std::vector<LeafId>& out) const override;

 private:
  const Complex& complex_;
  const Components& x_;
};

}  // namespace cnrg
