#include "csg/evaluate/chains.h"

#include <algorithm>
#include <utility>

#include "csg/operators/fold.h"

namespace cnrg {

bool can_be_in_chain(const Node& node) {
  return !node.blend &&
         (node.op == Operator::unite || node.op == Operator::intersect || node.op == Operator::subtract);
}

bool can_be_followed(const Node& node) {
  return !node.regularize && !node.forget_features && node.material.empty() && node.label.empty() &&
         node.properties.empty();
}

std::optional<ChainOutcome> evaluate_chain(const Complex& complex, std::span<const ChainNode> chain, bool totals,
                                           const LeafOrder& order, Removed removed) {
  std::vector<PartedGroup> operands;
  std::vector<Dominance> dominances;
  PartedGroup left;  // the value so far: its dominance alone, and whether materials may decide
  for (const ChainNode& of : chain) {
    for (const Operand& operand : of.operands) {
      if (!operand.value->is_group()) return std::nullopt;
      operands.push_back(operand.value->parts());
      const PartedGroup& next = operands.back();
      if (operands.size() == 1) {
        left.dominance = next.dominance;
      } else {
        dominances.push_back(dominance_of(*of.node, left, next));
        if (rule_of(*of.node, dominances.back(), left, next) != StepRule::operands) return std::nullopt;
        left.dominance = std::max(left.dominance, next.dominance);
      }
      left.ranked = left.ranked || next.ranked;
    }
    if (of.node->dominance) left.dominance = *of.node->dominance;
  }
  FoldInSteps fold = boolean_fold_in_steps(complex, boolean_op(chain.front().node->op), dominances,
                                           std::move(operands), totals, order, removed);
  ChainOutcome out;
  auto step = fold.steps.begin();
  for (const ChainNode& of : chain) {
    const std::size_t steps = of.operands.size() - (&of == &chain.front() ? 1 : 0);
    ChainStep& node = out.nodes.emplace_back();
    for (std::size_t k = 0; k < steps; ++k, ++step) {
      if (!step->conflicts.empty() || (totals && !step->totals)) return std::nullopt;
      node.removals.add(step->removals);
      node.seconds += step->seconds;
      node.totals = std::move(step->totals);
    }
  }
  fold.group.dominance = left.dominance;
  out.value = std::move(fold.group);
  return out;
}

}  // namespace cnrg
