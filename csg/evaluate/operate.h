// One node: from the values of its operands to its own.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "csg/operators/group.h"
#include "csg/tree/tree.h"

namespace cnrg {

/// What came of one operator.
struct Outcome {
  Group group;
  std::vector<std::pair<std::string, std::size_t>> removals;  ///< by row id of the tables, each id once
  std::vector<std::string> conflicts;  ///< materials that met under equal dominance, in words
};

/// The value of an inner node: its operator on the operands, from left to right, then its attributes. With
/// `validate` each Boolean and complement is checked against the identities of SEMANTICS 5; InvariantError names
/// the node and the first violation.
Outcome operate(const Complex& complex, const Node& node, std::span<const Group* const> operands, bool validate);

/// The attributes of a node on its value: regularize, simplify, material, name, dominance.
void apply_attributes(const Complex& complex, const Node& node, Group& group);

}  // namespace cnrg
