// An operator of the tree file is one of two families: a group Boolean (boolean.h, fold.h) takes its operands as
// groups, an operator of CNRG (cnrg.h) as components. Then come the attributes of the node.
#include "csg/evaluate/operate.h"

#include <algorithm>
#include <iterator>

#include "csg/operators/below.h"
#include "csg/operators/blend.h"
#include "csg/operators/fold.h"
#include "csg/operators/identities.h"
#include "csg/operators/material_levels.h"
#include "csg/operators/say.h"
#include "csg/operators/select.h"
#include "csg/tree/selector.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

std::optional<Dominance> stated_dominance(const Node& node) {
  if (!node.dominant) return std::nullopt;
  switch (*node.dominant) {
    case DominantOperand::left: return Dominance::left;
    case DominantOperand::right: return Dominance::right;
    default: return Dominance::equal;
  }
}

}  // namespace

BooleanOp boolean_op(Operator op) {
  switch (op) {
    case Operator::unite: return BooleanOp::unite;
    case Operator::intersect: return BooleanOp::intersect;
    default: return BooleanOp::subtract;
  }
}

Dominance dominance_of(const Node& node, const PartedGroup& a, const PartedGroup& b) {
  if (const auto stated = stated_dominance(node)) return *stated;
  if (a.dominance == b.dominance) return Dominance::equal;
  return a.dominance > b.dominance ? Dominance::left : Dominance::right;
}

StepRule rule_of(const Node& node, Dominance dominance, const PartedGroup& a, const PartedGroup& b) {
  if (node.blend) return StepRule::blend;
  const bool open = node.op != Operator::subtract && dominance == Dominance::equal && !stated_dominance(node);
  return open && (a.ranked || b.ranked) ? StepRule::materials : StepRule::operands;
}

namespace {

void require_identity(const Node& node, const std::string& violation) {
  if (!violation.empty()) throw InvariantError("`" + node.name + "`: " + violation);
}

/// An operand of a group Boolean.
PartedGroup group_operand(const Complex& complex, const Node& node, const Operand& operand) {
  const NodeValue& value = *operand.value;
  if (value.is_group()) {
    if (operand.spent != nullptr) return std::move(operand.spent->parts());
    return value.parts();
  }
  if (value.stands_for) return parted(complex, *value.stands_for);
  const CellSet missing = missing_boundary(complex, value.components());
  if (!missing.empty()) {
    throw InputError("`" + node.operator_name + "` of `" + node.name + "` takes closed values and `" +
                     operand.name + "` is not closed: " + std::to_string(missing.size()) +
                     " cells of its boundary are missing; insert `closure` around it: {closure: " +
                     (operand.name.find('/') == std::string::npos ? operand.name : "{...}") + "}");
  }
  return parted(complex, group_of(complex, value.components()));
}

/// How the steps of a Boolean node are made, besides by its operator.
struct StepRules {
  const Transform& placement;
  const LeafOrder& order;
  Removed removed = Removed::counted;
};

/// One step of a Boolean node.
FoldResult step_of(const Complex& complex, const Node& node, const StepRules& rules, Dominance dominance,
                   PartedGroup left, PartedGroup right) {
  switch (rule_of(node, dominance, left, right)) {
    case StepRule::blend:
      return blended_union(complex, rules.placement, std::move(left), std::move(right), rules.order);
    case StepRule::materials:
      return boolean_by_materials(complex, boolean_op(node.op), std::move(left), std::move(right), rules.order);
    default:
      return boolean_fold(complex, boolean_op(node.op), std::span(&dominance, 1),
                          {std::move(left), std::move(right)}, rules.order, rules.removed);
  }
}

/// What a step gives becomes the value so far.
void add_step(FoldResult step, PartedGroup& value, StepOutcome& outcome) {
  outcome.removals.add(step.removals);
  std::move(step.conflicts.begin(), step.conflicts.end(), std::back_inserter(outcome.conflicts));
  value = std::move(step.group);
}

/// A Boolean node: the fold ((a op b) op c) op ... of its operands.
StepOutcome boolean_of(const Complex& complex, const Node& node, const StepRules& rules,
                       std::span<const Operand> operands) {
  std::vector<PartedGroup> values;
  values.reserve(operands.size());
  std::vector<Dominance> dominances;
  PartedGroup left;  // of the steps so far: its dominance alone
  for (const Operand& operand : operands) {
    values.push_back(group_operand(complex, node, operand));
    if (values.size() == 1) {
      left.dominance = values.back().dominance;
      continue;
    }
    dominances.push_back(dominance_of(node, left, values.back()));
    left.dominance = std::max(left.dominance, values.back().dominance);
  }
  const bool ranked =
      std::any_of(values.begin(), values.end(), [](const PartedGroup& value) { return value.ranked; });
  const bool alike = std::find(dominances.begin(), dominances.end(), Dominance::equal) != dominances.end();
  if (!node.blend && !(ranked && alike && !node.dominant)) {
    FoldResult result =
        boolean_fold(complex, boolean_op(node.op), dominances, std::move(values), rules.order, rules.removed);
    return {std::move(result.group), std::move(result.removals), std::move(result.conflicts)};
  }
  StepOutcome outcome;
  PartedGroup value = std::move(values[0]);
  for (std::size_t k = 1; k < values.size(); ++k) {
    add_step(step_of(complex, node, rules, dominances[k - 1], std::move(value), std::move(values[k])), value,
             outcome);
  }
  outcome.value = std::move(value);
  return outcome;
}

/// The same in folds of two, each shown to `see` as whole groups.
StepOutcome boolean_in_steps(const Complex& complex, const Node& node, const StepRules& rules,
                             std::span<const Operand> operands,
                             const std::function<void(const BooleanStep&)>& see) {
  const BooleanOp op = boolean_op(node.op);
  StepOutcome outcome;
  PartedGroup value = group_operand(complex, node, operands[0]);
  for (std::size_t k = 1; k < operands.size(); ++k) {
    PartedGroup right = group_operand(complex, node, operands[k]);
    const Dominance dominance = dominance_of(node, value, right);
    const Group left_whole = whole(value), right_whole = whole(right);
    const StepRule rule = rule_of(node, dominance, value, right);
    FoldResult step = step_of(complex, node, rules, dominance, std::move(value), std::move(right));
    const Group result = whole(step.group);
    see({op, dominance, left_whole, right_whole, result, k, rule});
    add_step(std::move(step), value, outcome);
  }
  outcome.value = std::move(value);
  return outcome;
}

/// What of a solid is below or above a surface: the solid cut to the part that is there.
StepOutcome side_of(const Complex& complex, const Node& node, std::span<const Operand> operands,
                    const NodePlace& place, const std::function<void(const BooleanStep&)>& see) {
  const Group surface = whole(group_operand(complex, node, operands[0]));
  PartedGroup block = group_operand(complex, node, operands[1]);
  const Group left = whole(block);
  if (left.cells.empty() && left.faces.empty() && left.edges.empty() && left.vertices.empty())
    return {std::move(block), {}, {}};
  const Side side = node.op == Operator::below ? Side::below : Side::above;
  const Group right =
      part_of(complex, side, surface, operands[0].name, left, operands[1].name, place.transform, place.proven);
  const Dominance dominance = Dominance::left;
  FoldResult cut = boolean_fold(complex, BooleanOp::intersect, std::span(&dominance, 1),
                                {std::move(block), parted(complex, right)}, place.order, place.removed);
  if (see) see({BooleanOp::intersect, dominance, left, right, whole(cut.group), 1, StepRule::operands});
  return {std::move(cut.group), std::move(cut.removals), std::move(cut.conflicts)};
}

void require_surface(const Complex& complex, const Selector::Side& side, const std::vector<LeafId>& leaves) {
  const auto is_solid = [&](LeafId leaf) { return complex.leaf_regions[leaf] != 0; };
  const auto is_of_surface = [&](const Soup::Face& face) {
    return !is_solid(face.leaf) && std::binary_search(leaves.begin(), leaves.end(), face.leaf);
  };
  if (std::any_of(complex.sources.begin(), complex.sources.end(), is_of_surface)) return;
  const auto is_wire_or_point = [&](LeafId leaf) {
    const auto& points = complex.isolated_leaves.values();
    return std::any_of(complex.wires.begin(), complex.wires.end(),
                       [&](const auto& w) { return w.leaf == leaf; }) ||
           std::find(points.begin(), points.end(), leaf) != points.end();
  };
  if (std::none_of(leaves.begin(), leaves.end(),
                   [&](LeafId leaf) { return is_solid(leaf) || is_wire_or_point(leaf); }))
    throw FaultAt(side.at, "a node that joins lies above `" + side.name +
                               "`, and what is joined has no sides of surfaces; pick before it is joined");
  if (std::none_of(leaves.begin(), leaves.end(), is_solid))
    throw FaultAt(side.at, "`" + side.name + "` has no face, so no front and no back; name a surface");
  throw FaultAt(side.at, "`" + side.name + "` is a solid and parts nothing by a front and a back; " +
                             "name a surface, or pick what is in it by `inside: " + side.name + "`");
}

/// What is picked out of the first operand; the others are sets of points in which, or at which, it lies.
StepOutcome selected(const Complex& complex, const Node& node, std::span<const Operand> operands, bool validate,
                     const NodePlace& place) {
  Criteria criteria = node.selector->criteria;
  const std::vector<Selector::Side>& sides = node.selector->sides;
  const std::size_t others = operands[0].below.size() - sides.size();
  if (others != 0) criteria.leaves = *operands[0].below[0];
  for (std::size_t i = 0; i < sides.size(); ++i) {
    criteria.sides.push_back({*operands[0].below[others + i], sides[i].front});
    require_surface(complex, sides[i], criteria.sides.back().surfaces);
  }
  const std::span<const Operand> places = operands.subspan(1);
  const auto points = [&](std::span<const Operand> of) {
    std::optional<CellSet> set;
    for (const Operand& operand : of) {
      const CellSet more = support(selection_of(complex, *operand.value));
      set = set ? unite(*set, more) : more;
    }
    return set;
  };
  criteria.inside = points(places.first(node.selector->inside));
  criteria.touching = points(places.subspan(node.selector->inside));
  const NodeValue& of = *operands[0].value;
  if (place.proven && (of.is_group() ? picks_by_drawn_numbers(complex, of.group(), criteria)
                                     : picks_by_drawn_numbers(complex, of.components(), criteria))) {
    throw InputError(
        "`" + operands[0].name +
        "` has curved faces, and its regions are numbered by vertices of facets; leave out --certify, or "
        "pick regions by leaves or places");
  }
  if (!of.is_group()) return {select(complex, of.components(), criteria), {}, {}};
  if (!criteria.region_numbers.empty()) {
    const std::vector<Component> numbers = own_numbers(complex, of.group(), place.transform);
    const std::vector<Component> wanted = std::exchange(criteria.region_numbers, {});
    for (const Component number : wanted) {
      const auto it = std::find(numbers.begin() + 1, numbers.end(), number);
      criteria.region_numbers.push_back(it == numbers.end() ? number : Component(it - numbers.begin()));
    }
  }
  Group picked = select(complex, of.group(), criteria);
  if (validate) require_identity(node, check_group(complex, picked));
  return {NodeValue(complex, std::move(picked)), {}, {}};
}

StepOutcome validated_boolean(const Complex& complex, const Node& node, const StepRules& rules,
                              std::span<const Operand> operands) {
  return boolean_in_steps(complex, node, rules, operands, [&](const BooleanStep& step) {
    require_identity(node, check_boolean(complex, step.op, step.left, step.right, step.result));
  });
}

StepOutcome of_components(ComponentsResult result) {
  return {std::move(result.value), {}, std::move(result.conflicts)};
}

/// The operands as components, and pointers to these.
struct ComponentOperands {
  ComponentOperands(const Complex& complex, std::span<const Operand> operands, const Transform& transform) {
    values.reserve(operands.size());
    for (const Operand& operand : operands) {
      values.push_back(components_of(complex, *operand.value, transform));
      pointers.push_back(&values.back());
    }
  }
  std::vector<Components> values;
  std::vector<const Components*> pointers;
};

/// sum, product and subtract from left to right. A product is made in steps always: these cost no more.
StepOutcome overlay_of(const Complex& complex, const Node& node, std::span<const Operand> operands, bool validate,
                       const Transform& transform) {
  if (!validate && operands.size() > 2 && node.op != Operator::product) {
    const ComponentOperands all(complex, operands, transform);
    return of_components(node.op == Operator::sum ? sum(complex, all.pointers, stated_dominance(node))
                                                  : subtract(complex, all.pointers));
  }
  StepOutcome outcome;
  Components value = components_of(complex, *operands[0].value, transform);
  for (const Operand& operand : operands.subspan(1)) {
    const Components right = components_of(complex, *operand.value, transform);
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
      default: step = subtract(complex, value, right);
    }
    if (validate) require_identity(node, check_overlay(law, complex, value, right, step.value));
    outcome.conflicts.insert(outcome.conflicts.end(), step.conflicts.begin(), step.conflicts.end());
    value = std::move(step.value);
  }
  outcome.value = std::move(value);
  return outcome;
}

StepOutcome aggregate_all(const Complex& complex, std::span<const Operand> operands, const Transform& transform) {
  const ComponentOperands all(complex, operands, transform);
  std::vector<std::string> names;
  for (const Operand& operand : operands) names.push_back(operand.name);
  return of_components(aggregate(complex, all.pointers, names));
}

Name called_after(const Node& node) {
  return Name(std::vector{NamePart{node.regions_called(), 0, NameOrigin::node}});
}

/// A component with a single name keeps it; without one, or with several joined, it is called after the node.
void name_after(const Node& node, StepOutcome& outcome) {
  for (ComponentAttributes& a : outcome.value.components().attributes) {
    if (a.name.parts().size() != 1 || a.name.is_of_entities()) a.name = called_after(node);
  }
}

StepOutcome complement_of(const Complex& complex, const Node& node, const NodeValue& operand, bool validate) {
  StepOutcome outcome = of_components(complement(complex, components_of(complex, operand)));
  name_after(node, outcome);
  if (!operand.is_group()) return outcome;
  Group closed = complement(complex, operand.group());
  if (validate) require_identity(node, check_complement(complex, operand.group(), closed));
  closed.dominance = operand.group().dominance;
  for (RegionAttributes& region : closed.regions) {
    if (region.name.empty()) region.name = called_after(node);
  }
  outcome.value.stands_for = std::move(closed);
  return outcome;
}

PartedGroup regularized(const Complex& complex, const PartedGroup& value) {
  return changed(complex, value, [&](Group& group) { group = regularize(complex, group); });
}

StepOutcome topology_of(const Complex& complex, const Node& node, const Operand& of, bool validate,
                        const Transform& transform) {
  const Topological op = topological(node.op);
  const NodeValue& operand = *of.value;
  if (operand.is_group() && !node.each) {
    if (op == Topological::closure) return {operand.parts(), {}, {}};
    if (op == Topological::regularize) return {regularized(complex, operand.parts()), {}, {}};
  }
  const Components x = components_of(complex, operand, transform);
  ComponentsResult result = node.each ? topological_operation_of_each(complex, op, x, *of.below[0])
                                      : topological_operation(complex, op, x, *of.below[0]);
  if (validate) require_identity(node, check_topological(complex, op, node.each, x, result.value));
  return of_components(std::move(result));
}

/// The attributes of a node on a group; a leaf's regions and components have theirs already.
void add_attributes(const Complex& complex, const Node& node, const RegionMaterial& material, PartedGroup& group) {
  if (node.regularize) group = regularized(complex, group);
  const Attributes given{node.label, material, node.properties};
  const bool says = node.op != Operator::leaf && !given.empty();
  if (node.forget_features || says) {
    group = changed(complex, group, [&](Group& part) {
      if (node.forget_features) part.features = {};
      if (!says) return;
      for (RegionAttributes& region : part.regions) replace(region, given);
      // A layer is called sand, not the horizon that it ends at.
      const bool is_layer = node.op == Operator::below || node.op == Operator::above;
      say(complex, given, is_layer ? Saying::replaces_standing : Saying::replaces, part);
    });
  }
  if (node.dominance) group.dominance = *node.dominance;
}

void add_attributes(const Complex& complex, const Node& node, const RegionMaterial& material,
                    Components& components) {
  if (node.regularize) components = topological_operation(complex, Topological::regularize, components).value;
  if (node.forget_features) components.features = {};
  const Attributes given{node.label, material, node.properties};
  const bool says = node.op != Operator::leaf && !given.empty();
  for (ComponentAttributes& attributes : components.attributes) {
    if (says) replace(attributes, given);
    if (node.dominance) attributes.dominance = *node.dominance;
  }
  if (says) say(complex, given, Saying::replaces, components);
}

}  // namespace

void for_each_step(const Complex& complex, const Node& node, std::span<const Operand> operands,
                   const NodePlace& place, const std::function<void(const BooleanStep&)>& see) {
  if (node.op == Operator::below || node.op == Operator::above) side_of(complex, node, operands, place, see);
  else boolean_in_steps(complex, node, {{}, place.order}, operands, see);
}

template <class IdT>
Verdict verdict(const Complex& complex, const BooleanStep& step, IdT cell) {
  Dominance dominance = step.dominance;
  if (step.rule == StepRule::materials) dominance = levels_at(complex, step.left, step.right, cell).dominance();
  if (step.rule == StepRule::blend) dominance = step.left.has(cell) ? Dominance::left : Dominance::right;
  return verdict(complex, step.op, dominance, step.left, step.right, step.result, cell);
}

template Verdict verdict(const Complex&, const BooleanStep&, FaceId);
template Verdict verdict(const Complex&, const BooleanStep&, EdgeId);
template Verdict verdict(const Complex&, const BooleanStep&, VertexId);

std::vector<std::span<const NodeId>> leaves_wanted(const Node& node, bool first_operand) {
  if (is_topological(node.op)) return {std::span<const NodeId>()};
  std::vector<std::span<const NodeId>> lists;
  if (node.op != Operator::select || !first_operand) return lists;
  if (!node.selector->from.empty()) lists.push_back(node.selector->from);
  for (const Selector::Side& side : node.selector->sides) lists.emplace_back(&side.of, 1);
  return lists;
}

Topological topological(Operator op) {
  switch (op) {
    case Operator::interior: return Topological::interior;
    case Operator::closure: return Topological::closure;
    case Operator::boundary: return Topological::boundary;
    default: return Topological::regularize;
  }
}

StepOutcome first_steps(const Complex& complex, const Node& node, std::span<const Operand> operands,
                        const LeafOrder& order, Removed removed) {
  return boolean_of(complex, node, {{}, order, removed}, operands);
}

StepOutcome operate(const Complex& complex, const Node& node, const RegionMaterial& material,
                    std::span<const Operand> operands, bool validate, const NodePlace& place) {
  StepOutcome outcome;
  switch (node.op) {
    case Operator::unite:
    case Operator::intersect:
    case Operator::subtract:
      outcome = validate
                    ? validated_boolean(complex, node, {place.placement, place.order, place.removed}, operands)
                    : boolean_of(complex, node, {place.placement, place.order, place.removed}, operands);
      break;
    case Operator::sum:
    case Operator::product:
    case Operator::cnrg_subtract: outcome = overlay_of(complex, node, operands, validate, place.transform); break;
    case Operator::aggregate: outcome = aggregate_all(complex, operands, place.transform); break;
    case Operator::unify:
      outcome = of_components(unify(complex, components_of(complex, *operands[0].value, place.transform)));
      name_after(node, outcome);
      break;
    case Operator::complement: outcome = complement_of(complex, node, *operands[0].value, validate); break;
    case Operator::interior:
    case Operator::closure:
    case Operator::boundary:
    case Operator::regularize: outcome = topology_of(complex, node, operands[0], validate, place.transform); break;
    case Operator::below:
    case Operator::above:
      outcome = side_of(complex, node, operands, place, [&](const BooleanStep& step) {
        if (validate) require_identity(node, check_boolean(complex, step.op, step.left, step.right, step.result));
      });
      break;
    case Operator::simplify:
      if (operands[0].value->is_group()) {
        outcome.value = operands[0].value->parts();
      } else {
        outcome.value = operands[0].value->components();
        outcome.value.stands_for = operands[0].value->stands_for;
      }
      break;
    case Operator::select: outcome = selected(complex, node, operands, validate, place); break;
    case Operator::leaf: throw InvariantError("operate: `" + node.name + "` is a leaf");
  }
  apply_attributes(complex, node, material, outcome.value);
  return outcome;
}

void apply_attributes(const Complex& complex, const Node& node, const RegionMaterial& material, NodeValue& value) {
  if (value.is_group()) {
    add_attributes(complex, node, material, value.parts());
    return;
  }
  add_attributes(complex, node, material, value.components());
  if (!value.stands_for) return;
  if (node.regularize) {
    value.stands_for.reset();
    return;
  }
  PartedGroup closed = parted(complex, std::move(*value.stands_for));
  add_attributes(complex, node, material, closed);
  value.stands_for = whole(closed);
}

}  // namespace cnrg
