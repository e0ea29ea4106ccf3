// The value of each node of a tree on the grid, by brute force: a group of cubical.h, or the component of each
// cell.
#pragma once

#include <string>
#include <vector>

#include "tests/oracles/cubical.h"
#include "tests/oracles/dag.h"
#include "tests/oracles/dag_reference.h"

namespace cubical {

using Labels = cnrg::properties::CellIncidence::Labels;

/// One operation of a group Boolean, from left to right over its operands.
struct Step {
  Op op;
  cnrg::DominantOperand dominant;
  Group result;
};

struct Value {
  bool is_group = false;
  Group group;              ///< of a group
  Labels labels;            ///< the component of each cell; the entities of a group are the last
  bool complement = false;  ///< the complement of a group: `group` is what it stands for
  Labels first_labels;      ///< of components, before the attribute `regularize`
  int number = 0;           ///< of dominance, where all that is below are leaves and group Booleans
  // of a group Boolean
  std::vector<Group> operands;
  std::vector<Step> steps;
};

/// The values of all nodes, or nothing and the reason why not.
std::string values_by_brute_force(const Grid& grid, const cnrg::properties::RandomDag& dag,
                                  std::vector<Value>& values);

}  // namespace cubical
