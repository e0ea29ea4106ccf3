// One n-ary Boolean node, evaluated as that of a tree is.
#pragma once

#include "bench/cases/case.h"
#include "csg/evaluate/operate.h"

namespace cnrg::bench {

inline StepOutcome evaluate_node(const Complex& complex, Operation operation, std::vector<NodeValue>& leaves) {
  Node node;
  node.op = operation == Operation::unite ? Operator::unite : Operator::subtract;
  node.name = "node";
  node.operator_name = operation == Operation::unite ? "union" : "difference";
  std::vector<Operand> operands;
  // As in a tree: nobody needs the operands any more.
  for (NodeValue& leaf : leaves) operands.push_back({&leaf, "leaf", &leaf, {}});
  return operate(complex, node, {}, operands, false, {});
}

inline std::vector<NodeValue> values_of(const Complex& complex, std::vector<Group> groups) {
  std::vector<NodeValue> values;
  values.reserve(groups.size());
  for (Group& group : groups) values.emplace_back(complex, std::move(group));
  return values;
}

}  // namespace cnrg::bench
