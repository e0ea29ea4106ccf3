// What became of the entities of a node's operands: where each lies (AinB, INTERS, AoutB, ...), which row of the
// tables was asked, and whether it went.
//
// The cells of a result cannot carry this: what was removed is not among them, and one face of the result may be
// made of pieces that lay differently. So it is a selection of its own on the same complex: a component for each
// fate, simplified and drawn as any other value.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "csg/evaluate/operate.h"
#include "csg/operators/tables.h"

namespace cnrg {

/// The fate of an entity at a node.
struct Fate {
  Relation relation = Relation::common;
  bool dominant = false;  ///< asked in the rows of A > B (and those of the difference)
  bool removed = false;
  bool table = true;  ///< false: removed by an operator that has no table, or by an attribute of the node

  Component component() const;
  static Fate of(Component component);
};

/// The rows that a Boolean asked, and the roles of its operands.
struct AskedRows {
  struct Step {
    std::size_t operand;  ///< the place of the right operand
    Roles roles;
    StepRule rule;
  };
  std::vector<Step> steps;
  /// By row the cells (pair_refinement.h) that it kept and that it removed. A row is here if its part of a table,
  /// dominant or equal, was asked at all.
  std::map<std::size_t, std::array<std::size_t, 2>> cells;
};
/// Nothing for what is no union, intersection or difference.
AskedRows asked_rows(const Tree& tree, const Evaluation& evaluation, InstanceId id);

/// The entities of the operands of an instance, those of dimension 2 at most, each in the component of its fate.
/// An entity that several steps of a fold ask about has the fate of the last that did not merely find it outside.
/// Nothing for leaves and where no table was asked and nothing went.
std::optional<Selection> fates(const Tree& tree, const Evaluation& evaluation, InstanceId id);
/// Those of them that went, all in component 1. The evaluation must have kept all values.
Selection removed_entities(const Tree& tree, const Evaluation& evaluation, const KeptValue& kept);
/// The instance that has this value: the last one of its node.
InstanceId instance_of(const Evaluation& evaluation, const KeptValue& kept);

}  // namespace cnrg
