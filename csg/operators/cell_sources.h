// The leaves that the cells of a value came from and what is said of them, as `simplify` and writers ask for them.
//
// A cell that is not active (the boundary of an open set) came from what the active cells of its star came from.
//
// A cell *speaks for itself* if what is said of it is said of a thing of its own dimension: of a sheet, the faces
// speak, not the edges and vertices that bound them. An edge of a sheet speaks where it is all that is left, as
// where two sheets were intersected. And a cell is silent if nothing is said of it that is not said of its
// component: a bolt in rock that somebody has called rock is rock.
#pragma once

#include <memory>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "csg/operators/components.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

class NodeValue;

class ValueSources : public CellSources {
 public:
  /// What is said of a cell that speaks for itself; nullptr for others, and where nothing is said.
  template <class IdT>
  const Attributes* said(IdT cell) const {
    const LeafSetId set = said_set(cell);
    return set.valid() ? &sets_.said(set)->attributes : nullptr;
  }

  /// The same of an active cell that does not speak for itself but lies in the closure of what does.
  template <class IdT>
  const Attributes* said_around(IdT cell) const {
    const LeafSetId set = set_of(cell);
    return set.valid() && sets_.said(set) ? &sets_.said(set)->attributes : nullptr;
  }

  bool marks_anything() const override { return !marks_.empty(); }
  std::uint32_t mark(FaceId f) const override { return mark_of(said_set(f)); }
  std::uint32_t mark(EdgeId e) const override { return mark_of(said_set(e)); }
  std::uint32_t mark(VertexId v) const override { return mark_of(said_set(v)); }

 protected:
  /// Keeps references to its arguments.
  ValueSources(const Complex& complex, const LeafSets& sets);
  /// The set of an active cell, of a group: of an entity; none() for other cells.
  virtual LeafSetId set_of(FaceId f) const = 0;
  virtual LeafSetId set_of(EdgeId e) const = 0;
  virtual LeafSetId set_of(VertexId v) const = 0;
  /// The same, but none() for a cell whose component says as much.
  virtual LeafSetId telling_set_of(FaceId f) const { return set_of(f); }
  virtual LeafSetId telling_set_of(EdgeId e) const { return set_of(e); }
  virtual LeafSetId telling_set_of(VertexId v) const { return set_of(v); }
  /// It is there, and not just a cut that some leaf makes in the interior of a component.
  virtual bool stands_out(FaceId f) const { return set_of(f).valid(); }
  virtual bool stands_out(EdgeId e) const { return set_of(e).valid(); }

  const Complex& complex_;
  const LeafSets& sets_;

 private:
  /// It bounds: something is said of it, or it stands out.
  template <class IdT>
  bool bounds(IdT cell) const {
    const LeafSetId set = set_of(cell);
    return set.valid() && (mark_of(set) != 0 || stands_out(cell));
  }
  std::uint32_t mark_of(LeafSetId set) const { return set.valid() ? marks_[set.index()] : 0; }
  /// The set of a cell that speaks for itself; none() for others.
  LeafSetId said_set(FaceId f) const;
  LeafSetId said_set(EdgeId e) const;
  LeafSetId said_set(VertexId v) const;
  std::vector<std::uint32_t>
      marks_;  // by set: equal for equal attributes, 0 for none; empty: nobody says anything
};

/// Both keep references to their arguments.
class GroupSources : public ValueSources {
 public:
  GroupSources(const Complex& complex, const Group& group)
      : ValueSources(complex, group.origins.sets), group_(group) {}
  void leaves_of(FaceId f, std::vector<LeafId>& out) const override;
  void leaves_of(EdgeId e, std::vector<LeafId>& out) const override;

 private:
  LeafSetId set_of(FaceId f) const override;
  LeafSetId set_of(EdgeId e) const override;
  LeafSetId set_of(VertexId v) const override;
  const Group& group_;
};

class ComponentSources : public ValueSources {
 public:
  ComponentSources(const Complex& complex, const Components& x);
  void leaves_of(FaceId f, std::vector<LeafId>& out) const override;
  void leaves_of(EdgeId e, std::vector<LeafId>& out) const override;

 private:
  LeafSetId set_of(FaceId f) const override;
  LeafSetId set_of(EdgeId e) const override;
  LeafSetId set_of(VertexId v) const override;
  LeafSetId telling_set_of(FaceId f) const override;
  LeafSetId telling_set_of(EdgeId e) const override;
  LeafSetId telling_set_of(VertexId v) const override;
  bool stands_out(FaceId f) const override;
  bool stands_out(EdgeId e) const override;
  template <class IdT>
  LeafSetId telling_set(IdT cell) const;
  /// A cell of a component, not just of none, with a 3-cell around it that is not of that component.
  bool is_beside(std::span<const RegionId> around, Component own) const;
  const Components& x_;
  std::set<std::pair<Component, LeafSetId>> repeated_;  // of cells of which the same is said as of their component
};

/// Those of a value of either kind, which must outlive them (defined with it, in node_value.cpp).
std::unique_ptr<const ValueSources> sources_of(const Complex& complex, const NodeValue& value);

}  // namespace cnrg
