// The operators of the tree file, by the operators of groups; see the header.
#include "csg/evaluate/operate.h"

#include <algorithm>

#include "csg/operators/boolean.h"
#include "csg/operators/identities.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

BooleanOp boolean_op(Operator op) {
  switch (op) {
    case Operator::unite:
      return BooleanOp::unite;
    case Operator::intersect:
      return BooleanOp::intersect;
    default:
      return BooleanOp::subtract;
  }
}

/// What the node says; without a word the greater number dominates.
Dominance dominance_of(const Node& node, const Group& a, const Group& b) {
  if (node.dominant) {
    switch (*node.dominant) {
      case DominantOperand::left:
        return Dominance::left;
      case DominantOperand::right:
        return Dominance::right;
      case DominantOperand::equal:
        return Dominance::equal;
    }
  }
  if (a.dominance == b.dominance) return Dominance::equal;
  return a.dominance > b.dominance ? Dominance::left : Dominance::right;
}

void add_removals(std::vector<std::pair<std::string, std::size_t>>& sums,
                  const std::vector<std::pair<std::string, std::size_t>>& removals) {
  for (const auto& [id, count] : removals) {
    if (count == 0) continue;
    const auto it = std::find_if(sums.begin(), sums.end(), [&](const auto& sum) { return sum.first == id; });
    if (it == sums.end()) {
      sums.emplace_back(id, count);
    } else {
      it->second += count;
    }
  }
}

std::string words(const MaterialConflict& conflict, const Group& group) {
  return "the region `" + group.regions[conflict.region - 1].name + "` keeps the material `" + conflict.kept +
         "` where `" + conflict.other + "` has equal dominance; give one of the operands a greater `dominance`";
}

void require_identity(const Node& node, const std::string& violation) {
  if (!violation.empty()) throw InvariantError("`" + node.name + "`: " + violation);
}

/// ((a op b) op c) op ...
Outcome fold(const Complex& complex, const Node& node, std::span<const Group* const> operands, bool validate) {
  Outcome outcome;
  const Group* left = operands[0];
  for (const Group* right : operands.subspan(1)) {
    BooleanResult step = apply(complex, boolean_op(node.op), dominance_of(node, *left, *right), *left, *right);
    if (validate) {
      require_identity(node, check_boolean(complex, boolean_op(node.op), *left, *right, step.group));
    }
    step.group.dominance = std::max(left->dominance, right->dominance);
    add_removals(outcome.removals, step.removals);
    for (const MaterialConflict& conflict : step.conflicts)
      outcome.conflicts.push_back(words(conflict, step.group));
    outcome.group = std::move(step.group);
    left = &outcome.group;
  }
  return outcome;
}

}  // namespace

Outcome operate(const Complex& complex, const Node& node, std::span<const Group* const> operands, bool validate) {
  Outcome outcome;
  switch (node.op) {
    case Operator::unite:
    case Operator::intersect:
    case Operator::subtract:
      outcome = fold(complex, node, operands, validate);
      break;
    case Operator::complement:
      outcome.group = complement(complex, *operands[0]);
      if (validate) require_identity(node, check_complement(complex, *operands[0], outcome.group));
      outcome.group.dominance = operands[0]->dominance;
      for (RegionAttributes& region : outcome.group.regions) {
        if (region.name.empty()) region.name = node.name;
      }
      break;
    case Operator::regularize:
      outcome.group = regularize(complex, *operands[0]);
      outcome.group.dominance = operands[0]->dominance;
      break;
    case Operator::simplify:
      outcome.group = *operands[0];
      break;
    case Operator::leaf:
      throw InvariantError("operate: `" + node.name + "` is a leaf");
  }
  apply_attributes(complex, node, outcome.group);
  return outcome;
}

void apply_attributes(const Complex& complex, const Node& node, Group& group) {
  const bool inner = node.op != Operator::leaf;  // a leaf's regions have names and materials already
  if (node.regularize) {
    Rational dominance = group.dominance;
    group = regularize(complex, group);
    group.dominance = std::move(dominance);
  }
  if (node.forget_features) group.features = {};
  for (RegionAttributes& region : group.regions) {
    if (inner && !node.material.empty()) region.material = node.material;
    if (inner && !node.label.empty()) region.name = node.label;
  }
  if (node.dominance) group.dominance = *node.dominance;
}

}  // namespace cnrg
