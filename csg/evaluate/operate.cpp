// The operators of the tree file, by those of the two families; see the header.
#include "csg/evaluate/operate.h"

#include <algorithm>

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

std::optional<Dominance> stated_dominance(const Node& node) {
  if (!node.dominant) return std::nullopt;
  switch (*node.dominant) {
    case DominantOperand::left:
      return Dominance::left;
    case DominantOperand::right:
      return Dominance::right;
    default:
      return Dominance::equal;
  }
}

/// What the node says; without a word the greater number dominates.
Dominance dominance_of(const Node& node, const Group& a, const Group& b) {
  if (const auto stated = stated_dominance(node)) return *stated;
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

void require_identity(const Node& node, const std::string& violation) {
  if (!violation.empty()) throw InvariantError("`" + node.name + "`: " + violation);
}

/// An operand of a group Boolean.
class GroupOperand {
 public:
  GroupOperand(const Complex& complex, const Node& node, const NodeValue& value, const std::string& name) {
    if (value.is_group()) {
      group_ = &value.group();
    } else if (value.stands_for) {
      group_ = &*value.stands_for;
    } else {
      const CellSet missing = missing_boundary(complex, value.components());
      if (!missing.empty()) {
        throw InputError("`" + node.operator_name + "` of `" + node.name + "` takes closed values and `" + name +
                         "` is not closed: " + std::to_string(missing.size()) +
                         " cells of its boundary are missing; insert `closure`: {closure: " + name + "}");
      }
      made_ = group_of(complex, value.components());
      group_ = &made_;
    }
  }
  const Group& operator*() const { return *group_; }

 private:
  Group made_;
  const Group* group_;
};

/// ((a op b) op c) op ...
Outcome fold(const Complex& complex, const Node& node, std::span<const NodeValue* const> operands,
             std::span<const std::string> names, bool validate,
             const std::function<void(const BooleanStep&)>& see = {}) {
  Outcome outcome;
  const GroupOperand first(complex, node, *operands[0], names[0]);
  Group value;
  const Group* left = &*first;
  for (std::size_t k = 1; k < operands.size(); ++k) {
    const GroupOperand right(complex, node, *operands[k], names[k]);
    const Dominance dominance = dominance_of(node, *left, *right);
    BooleanResult step = apply(complex, boolean_op(node.op), dominance, *left, *right);
    if (see) see({boolean_op(node.op), dominance, *left, *right, step.group, k});
    if (validate) {
      require_identity(node, check_boolean(complex, boolean_op(node.op), *left, *right, step.group));
    }
    step.group.dominance = std::max(left->dominance, (*right).dominance);
    add_removals(outcome.removals, step.removals);
    outcome.conflicts.insert(outcome.conflicts.end(), step.conflicts.begin(), step.conflicts.end());
    value = std::move(step.group);
    left = &value;
  }
  outcome.value = std::move(value);
  return outcome;
}

/// sum, product and subtract from left to right.
Outcome fold_components(const Complex& complex, const Node& node, std::span<const NodeValue* const> operands,
                        bool validate) {
  Outcome outcome;
  Components value = components_of(complex, *operands[0]);
  for (const NodeValue* operand : operands.subspan(1)) {
    const Components right = components_of(complex, *operand);
    ComponentsResult step;
    OverlayLaw law = OverlayLaw::subtract;
    switch (node.op) {
      case Operator::sum:
        step = sum(complex, value, right, stated_dominance(node));
        law = OverlayLaw::sum;
        break;
      case Operator::product:
        step = product(complex, value, right, stated_dominance(node));
        law = OverlayLaw::product;
        break;
      default:
        step = subtract(complex, value, right);
    }
    if (validate) require_identity(node, check_overlay(law, complex, value, right, step.value));
    outcome.conflicts.insert(outcome.conflicts.end(), step.conflicts.begin(), step.conflicts.end());
    value = std::move(step.value);
  }
  outcome.value = std::move(value);
  return outcome;
}

Outcome aggregate_all(const Complex& complex, const Node& node, std::span<const NodeValue* const> operands,
                      std::span<const std::string> names) {
  std::vector<Components> values;
  for (const NodeValue* operand : operands) values.push_back(components_of(complex, *operand));
  std::vector<const Components*> pointers;
  for (const Components& value : values) pointers.push_back(&value);
  Outcome outcome;
  outcome.value = aggregate(complex, pointers, names).value;
  return outcome;
}

Outcome of_components(ComponentsResult result) {
  return {std::move(result.value), {}, std::move(result.conflicts)};
}

/// One component of one name keeps it; where there is none or several were joined it is called after the node.
void name_after(const Node& node, Outcome& outcome) {
  for (ComponentAttributes& a : std::get<Components>(outcome.value.held).attributes) {
    if (a.name.empty() || a.name == kEntitiesName || a.name.find(" & ") != std::string::npos) a.name = node.name;
  }
}

Outcome complement_of(const Complex& complex, const Node& node, const NodeValue& operand, bool validate) {
  Outcome outcome = of_components(complement(complex, components_of(complex, operand)));
  name_after(node, outcome);
  if (!operand.is_group()) return outcome;
  Group closed = complement(complex, operand.group());
  if (validate) require_identity(node, check_complement(complex, operand.group(), closed));
  closed.dominance = operand.group().dominance;
  for (RegionAttributes& region : closed.regions) {
    if (region.name.empty()) region.name = node.name;
  }
  outcome.value.stands_for = std::move(closed);
  return outcome;
}

Outcome topology_of(const Complex& complex, const Node& node, const NodeValue& operand, bool validate) {
  const Topological op = topological(node.op);
  if (operand.is_group() && !node.each) {
    if (op == Topological::closure) return {operand.group(), {}, {}};
    if (op == Topological::regularize) {
      Group group = regularize(complex, operand.group());
      group.dominance = operand.group().dominance;
      return {std::move(group), {}, {}};
    }
  }
  const Components x = components_of(complex, operand);
  ComponentsResult result = node.each ? apply_each(complex, op, x) : apply(complex, op, x);
  if (validate) require_identity(node, check_topological(complex, op, node.each, x, result.value));
  return of_components(std::move(result));
}

void set_attributes(const Node& node, RegionAttributes& attributes) {
  if (!node.material.empty()) attributes.material = node.material;
  if (!node.label.empty()) attributes.name = node.label;
}

/// The attributes of a node on a group; a leaf's regions and components have names and materials already.
void apply_attributes(const Complex& complex, const Node& node, Group& group) {
  if (node.regularize) {
    Rational dominance = group.dominance;
    group = regularize(complex, group);
    group.dominance = std::move(dominance);
  }
  if (node.forget_features) group.features = {};
  if (node.op != Operator::leaf) {
    for (RegionAttributes& region : group.regions) set_attributes(node, region);
  }
  if (node.dominance) group.dominance = *node.dominance;
}

void apply_attributes(const Complex& complex, const Node& node, Components& components) {
  if (node.regularize) components = apply(complex, Topological::regularize, components).value;
  if (node.forget_features) components.features = {};
  for (ComponentAttributes& attributes : components.attributes) {
    if (node.op != Operator::leaf) set_attributes(node, attributes);
    if (node.dominance) attributes.dominance = *node.dominance;
  }
}

}  // namespace

void for_each_step(const Complex& complex, const Node& node, std::span<const NodeValue* const> operands,
                   std::span<const std::string> names, const std::function<void(const BooleanStep&)>& see) {
  fold(complex, node, operands, names, false, see);
}

Topological topological(Operator op) {
  switch (op) {
    case Operator::interior:
      return Topological::interior;
    case Operator::closure:
      return Topological::closure;
    case Operator::boundary:
      return Topological::boundary;
    default:
      return Topological::regularize;
  }
}

Outcome operate(const Complex& complex, const Node& node, std::span<const NodeValue* const> operands,
                std::span<const std::string> names, bool validate) {
  Outcome outcome;
  switch (node.op) {
    case Operator::unite:
    case Operator::intersect:
    case Operator::subtract:
      outcome = fold(complex, node, operands, names, validate);
      break;
    case Operator::sum:
    case Operator::product:
    case Operator::cnrg_subtract:
      outcome = fold_components(complex, node, operands, validate);
      break;
    case Operator::aggregate:
      outcome = aggregate_all(complex, node, operands, names);
      break;
    case Operator::unify:
      outcome = of_components(unify(complex, components_of(complex, *operands[0])));
      name_after(node, outcome);
      break;
    case Operator::complement:
      outcome = complement_of(complex, node, *operands[0], validate);
      break;
    case Operator::interior:
    case Operator::closure:
    case Operator::boundary:
    case Operator::regularize:
      outcome = topology_of(complex, node, *operands[0], validate);
      break;
    case Operator::simplify:
      outcome.value = *operands[0];
      break;
    case Operator::leaf:
      throw InvariantError("operate: `" + node.name + "` is a leaf");
  }
  apply_attributes(complex, node, outcome.value);
  return outcome;
}

void apply_attributes(const Complex& complex, const Node& node, NodeValue& value) {
  std::visit([&](auto& held) { apply_attributes(complex, node, held); }, value.held);
  if (!value.stands_for) return;
  if (node.regularize) {
    value.stands_for.reset();
  } else {
    apply_attributes(complex, node, *value.stands_for);
  }
}

}  // namespace cnrg
