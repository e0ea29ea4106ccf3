// A node of a tree as problems for other systems: its operands and its value, which our kernel evaluates, as sets
// of marked cells and as regions.
#pragma once

#include "bench/cases/node_problem.h"
#include "bench/sweep/regions.h"
#include "csg/evaluate/evaluate.h"
#include "csg/tree/tree.h"

namespace cnrg::bench {

class TreeNode {
 public:
  /// Throws as `evaluate` does.
  TreeNode(Tree tree, NodeId node);

  const Node& node() const { return tree_.nodes[node_]; }
  std::size_t operand_count() const { return operands_.size(); }
  /// These throw Refusal at the stage `operator` where other systems lack the operator, at `operand` and `value`
  /// where they lack the set, such as what is bounded by nothing but a plane.
  SetProblem set_problem() const;
  RegionProblem region_problem() const;

 private:
  Tree tree_;
  NodeId node_;
  Evaluation evaluation_;
  const NodeValue* value_ = nullptr;
  std::vector<const NodeValue*> operands_;
};

}  // namespace cnrg::bench
