// The value of a node: a group or the components of a CNRG operator, and what each is to the other family.
//
// A leaf, a group Boolean, and regularize and closure of a group give a group. Every other operator gives
// components. The complement of a group is the open set space - |X|, as CNRG has it; where a group Boolean takes
// it directly it stands for the group of its closure, whose unbounded region is a region (pereira2012 4, Fig. 10:
// a surface minus the complement of a box).
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <variant>
#include <vector>

#include "csg/geometry/transform.h"
#include "csg/operators/components.h"
#include "csg/operators/parts.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

class NodeValue {
 public:
  NodeValue() : NodeValue(PartedGroup()) {}
  NodeValue(PartedGroup group) : held_(std::move(group)), whole_(std::make_unique<Whole>()) {}
  NodeValue(const Complex& complex, Group group) : NodeValue(parted(complex, std::move(group))) {}
  NodeValue(Components components) : held_(std::move(components)) {}

  bool is_group() const { return std::holds_alternative<PartedGroup>(held_); }
  /// These throw InvariantError when the value is of the other family. The parts are what operators work on; the
  /// group as a whole is made when it is first asked for (thread-safe).
  const PartedGroup& parts() const;
  const Group& group() const;
  const Components& components() const;
  PartedGroup& parts();
  Components& components();

  std::optional<Group> stands_for;  ///< the closed complement, of the complement of a group

  /// What `simplify` keeps: the features of a group. The state of a cell of components is its component alone
  /// (csg/SEMANTICS.md#simplification).
  const Features& features() const;
  const Origins& origins() const;
  /// How many components: the regions of a group and, if it has any, its entities as the last.
  std::size_t component_count() const;
  /// Name, material and leaves of component i from 1. The entities of a group are `entities`.
  const RegionAttributes& attributes(Component i) const;
  /// Those of all components; of component i at i - 1.
  std::vector<RegionAttributes> attributes() const;

 private:
  struct Whole {
    std::once_flag once;
    std::optional<Group> group;
  };
  std::variant<PartedGroup, Components> held_;
  mutable std::unique_ptr<Whole> whole_;
};

/// All that is said in a value: of its components in their order, then of cells by themselves. Lives as long as
/// it.
std::vector<const Attributes*> all_said(const NodeValue& value);

/// What is said of a cell that speaks for itself (csg/operators/cell_sources.h); nullptr for others.
const Attributes* said_of(const Complex& complex, const NodeValue& value, const Location& cell);

Selection selection_of(const Complex& complex, const NodeValue& value);
/// The simplified complex of a value, and its counts (kernel/selection/simplify.h); it depends on the value alone,
/// not on what else is in the complex. `selection` is that of the value.
SimplifiedComplex simplify(const Complex& complex, const NodeValue& value, const Selection& selection,
                           SimplifyMode mode = SimplifyMode::features);
std::array<std::size_t, 4> simplified_counts(const Complex& complex, const NodeValue& value,
                                             const Selection& selection);
Components components_of(const Complex& complex, const NodeValue& value);

/// Regions of a group are numbered by where they are. A node that takes them by number, or makes components of
/// them, must find the numbers that they have where the node stands alone, wherever its users have moved it. So
/// this is, by region of the group, from 1, its number before `transform` moved all that the group came from; that
/// of 0 is 0.
std::vector<Component> own_numbers(const Complex& complex, const Group& group, const Transform& transform);
/// The components of a value; those of a group are numbered so.
Components components_of(const Complex& complex, const NodeValue& value, const Transform& transform);

}  // namespace cnrg
