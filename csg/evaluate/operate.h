// The value of one node from the values of its operands.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "csg/operators/boolean.h"
#include "csg/operators/cnrg.h"
#include "csg/operators/leaf_order.h"
#include "csg/operators/node_value.h"
#include "csg/operators/verdict.h"
#include "csg/tree/tree.h"

namespace cnrg {

/// What came of one operator.
struct StepOutcome {
  NodeValue value;
  Removals removals;
  std::vector<AttributeConflict> conflicts;  ///< materials that met under equal dominance
};

struct Operand {
  const NodeValue* value = nullptr;
  std::string name;            ///< of its node, for messages
  NodeValue* spent = nullptr;  ///< the same value where nobody needs it any more: it may be moved from
  /// Leaves below it, ascending: a list for each of `leaves_wanted`.
  std::vector<std::shared_ptr<const std::vector<LeafId>>> below{};
};

/// Which leaves below an operand its operator wants to know, in several lists: those at or below these nodes, of
/// no nodes all.
std::vector<std::span<const NodeId>> leaves_wanted(const Node& node, bool first_operand);

/// How a node stands among the nodes that use it.
struct NodePlace {
  /// From the coordinates in which it was described to those of the run, its own transform included. In the former
  /// regions of its operands are numbered, and above is above.
  SharedTransform transform;
  SharedTransform placement;  ///< the same without its own: of mixtures that it makes itself (`blend`)
  LeafOrder order;            ///< of the leaves below it
  Removed removed = Removed::counted;
  bool proven = false;  ///< what facets alone tell is refused
};

/// The value of an inner node: its operator on the operands, from left to right, then its attributes; `material`
/// is the node's, empty for none. With `validate` each Boolean, complement and CNRG operator is checked against
/// the identities of csg/SEMANTICS.md#identities; InvariantError names the node and the first violation.
/// InputError when the operands do not suit the operator: the message names the operator to insert.
StepOutcome operate(const Complex& complex, const Node& node, const RegionMaterial& material,
                    std::span<const Operand> operands, bool validate, const NodePlace& place);

/// The first operands of an intersection as one: the fold of these alone, without the node's attributes.
StepOutcome first_steps(const Complex& complex, const Node& node, std::span<const Operand> operands,
                        const LeafOrder& order, Removed removed);

BooleanOp boolean_op(Operator op);
/// The dominance that the node states for a step; if it states none, the operand with the greater number
/// dominates.
Dominance dominance_of(const Node& node, const PartedGroup& a, const PartedGroup& b);

/// Who decides about the entities of a step.
enum class StepRule : std::uint8_t {
  operands,   ///< one dominance for all of them
  materials,  ///< those of the regions around each (csg/operators/material_levels.h)
  blend,      ///< nobody: all stay (csg/operators/blend.h)
};

StepRule rule_of(const Node& node, Dominance dominance, const PartedGroup& a, const PartedGroup& b);

/// One step of the fold ((a op b) op c) of a Boolean node, before the node's attributes.
struct BooleanStep {
  BooleanOp op;
  Dominance dominance;
  const Group &left, &right, &result;
  std::size_t operand;  ///< the place of the right operand
  StepRule rule;
};

/// What became of an entity in a step. Where the materials decide, the row is that of the dominance there; a blend
/// keeps each entity as if its own operand dominated.
template <class IdT>
Verdict verdict(const Complex& complex, const BooleanStep& step, IdT cell);

/// Evaluates a Boolean node as `operate` does and shows every step; of `below` and `above` the one step in which
/// the solid is cut.
void for_each_step(const Complex& complex, const Node& node, std::span<const Operand> operands,
                   const NodePlace& place, const std::function<void(const BooleanStep&)>& see);

/// The operator of a node that is interior, closure, boundary or regularize.
Topological topological(Operator op);

/// The attributes of a node on its value: regularize, simplify, material, name, attributes, dominance.
void apply_attributes(const Complex& complex, const Node& node, const RegionMaterial& material, NodeValue& value);

}  // namespace cnrg
