#include "bench/cases/tree_problem.h"

#include <algorithm>
#include <map>

#include "bench/cases/face_loops.h"
#include "bench/cases/value_model.h"
#include "csg/evaluate/evaluate.h"
#include "csg/leaves/leaf.h"
#include "csg/tree/dag.h"
#include "kernel/base/error.h"
#include "kernel/selection/selection.h"

namespace cnrg::bench {
namespace {

std::optional<Operation> operation_of_node(const Node& node) {
  switch (node.op) {
    case Operator::unite: return Operation::unite;
    case Operator::intersect: return Operation::intersect;
    case Operator::subtract: return Operation::subtract;
    default: return {};
  }
}

[[noreturn]] void fail(const Tree& tree, const Node& node, const std::string& what) {
  throw TreeError(tree.file, node.at, what);
}

/// What other systems know of: a Boolean alone.
bool is_plain(const Node& node) { return operation_of_node(node) && !node.transform && !node.regularize; }

/// If its operands are.
bool is_closed_and_bounded(const Node& node) {
  switch (node.op) {
    case Operator::leaf: return node.operator_name != "plane" && node.operator_name != "halfspace";
    case Operator::unite:
    case Operator::intersect:
    case Operator::subtract:
    case Operator::simplify:
    case Operator::closure:
    case Operator::regularize: return true;
    default: return false;
  }
}

struct Fold {
  std::vector<NodeId> operands;
  std::vector<Operation> steps;
};

/// The operands of an inline node of this operation in its place, else the node itself.
void add_operand(const Tree& tree, NodeId id, Operation merged, Operation step, Fold& fold) {
  const Node& node = tree.nodes[id];
  if (node.is_inline && is_plain(node) && operation_of_node(node) == merged) {
    for (const NodeId operand : tree.operands(id)) add_operand(tree, operand, merged, step, fold);
    return;
  }
  fold.operands.push_back(id);
  fold.steps.push_back(step);
}

void add_fold(const Tree& tree, NodeId id, Fold& fold) {
  const Operation operation = *operation_of_node(tree.nodes[id]);
  const Operation merged = operation == Operation::intersect ? Operation::intersect : Operation::unite;
  const std::vector<NodeId> operands = tree.operands(id);
  const Node& first = tree.nodes[operands[0]];
  if (first.is_inline && is_plain(first)) add_fold(tree, operands[0], fold);
  else fold.operands.push_back(operands[0]);
  for (std::size_t i = 1; i < operands.size(); ++i) add_operand(tree, operands[i], merged, operation, fold);
}

Fold fold_of(const Tree& tree, NodeId id) {
  const Node& node = tree.nodes[id];
  if (tree.weld)
    throw TreeError(tree.file, tree.weld_at,
                    "other systems do not weld: leave `weld` out, or weld the meshes before");
  if (!is_plain(node))
    fail(tree, node,
         "`" + node.name +
             "` is no union, intersection or difference alone, as other systems have them; name one "
             "without a transform and `regularize`");
  Fold fold;
  add_fold(tree, id, fold);
  if (fold.steps.empty()) fail(tree, node, "`" + node.name + "` has one operand; a problem has two or more");
  return fold;
}

/// A mesh as it is given: a solid by winding that is not inside out, or one without regions.
std::optional<Model> given_mesh(const Node& node) {
  if (node.operator_name != "mesh" || node.regularize) return {};
  const auto leaf = prepare(*node.shape);
  const Soup soup = make_soup({{leaf, node.transform ? SharedTransform(*node.transform) : SharedTransform()}});
  const Fill fill = soup.fill(LeafId(0));
  if (fill != Fill::none && fill != Fill::winding) return {};
  Model model;
  for (std::size_t p = 0; p < soup.point_count(); ++p) {
    const double* const xyz = soup.xyz(PointId(p));
    const RationalPoint* const exact = soup.rational(PointId(p));
    model.points.push_back(
        exact != nullptr ? *exact : RationalPoint{from_double(xyz[0]), from_double(xyz[1]), from_double(xyz[2])});
  }
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    Model::Face& face = model.faces.emplace_back();
    face.solid = fill == Fill::winding;
    face.loops.emplace_back();
    for (const PointId p : soup.corners(SourceId(f))) {
      if (p.valid()) face.loops.back().push_back(static_cast<std::uint32_t>(p.index()));
      else face.loops.emplace_back();
    }
  }
  for (const Soup::Wire& wire : soup.wires())
    model.wires.push_back(
        {static_cast<std::uint32_t>(wire.a.index()), static_cast<std::uint32_t>(wire.b.index())});
  for (const Soup::Isolated& point : soup.isolated())
    model.isolated.push_back(static_cast<std::uint32_t>(point.point.index()));
  if (fill == Fill::winding && signed_volume(model) <= 0) return {};
  cut_holes(model);
  return model;
}

/// The point sets of nodes, drawn with all leaves of the first one and as it is proven, so that surfaces that
/// leaves have in common are.
std::map<NodeId, Model> evaluated(const Tree& tree, NodeId among, const std::vector<NodeId>& nodes) {
  EvaluateOptions options;
  options.rows = Rows::none;
  options.result = among;
  options.nodes = nodes;
  options.drawn_together = true;
  options.threads = 1;
  const Evaluation evaluation = evaluate(tree, options);
  const Complex& complex = *evaluation.complex;
  std::map<NodeId, Model> models;
  for (const NodeId id : nodes) {
    const KeptValue& kept = evaluation.value(id);
    const CellSet set = support(selection_of(complex, *kept.value));
    const auto unbounded = [&](RegionId r) { return complex.unbounded(r); };
    if (std::any_of(set.regions.begin(), set.regions.end(), unbounded) ||
        !subtract(closure(complex, set), set).empty())
      fail(tree, tree.nodes[id],
           "`" + tree.nodes[id].name + "` is open or unbounded, which no other system takes");
    Model& model = models[id] = model_of(complex, point_set(complex, *kept.value));
    cut_holes(model);
  }
  return models;
}

}  // namespace

bool is_tree_problem(const Tree& tree, NodeId node) {
  return is_plain(tree.nodes[node]) && tree.operands(node).size() > 1;
}

Model tree_model(const Tree& tree, NodeId node, NodeId among) {
  return std::move(evaluated(tree, among, {node}).at(node));
}

Model operand_model(const Tree& tree, NodeId node) {
  if (std::optional<Model> mesh = given_mesh(tree.nodes[node])) return std::move(*mesh);
  return tree_model(tree, node, node);
}

Problem tree_problem(const Tree& tree, NodeId node) {
  const Fold fold = fold_of(tree, node);
  std::map<NodeId, Model> models;
  std::vector<NodeId> others;
  for (const NodeId operand : fold.operands) {
    if (models.contains(operand) || std::find(others.begin(), others.end(), operand) != others.end()) continue;
    if (std::optional<Model> mesh = given_mesh(tree.nodes[operand])) models.emplace(operand, std::move(*mesh));
    else others.push_back(operand);
  }
  if (!others.empty()) models.merge(evaluated(tree, node, others));
  Problem problem;
  problem.steps = fold.steps;
  for (const NodeId operand : fold.operands) problem.operands.push_back(models.at(operand));
  return problem;
}

void check_tree_problem(const Tree& tree, NodeId node) {
  const Fold fold = fold_of(tree, node);
  check(tree);
  // What may be open or unbounded is known when it is evaluated.
  const std::vector<char> below = tree.dag->reachable(fold.operands);
  for (const NodeId id : IdRange<NodeId>(tree.nodes.size()))
    if (below[id.index()] && !is_closed_and_bounded(tree.nodes[id])) {
      tree_problem(tree, node);
      return;
    }
}

}  // namespace cnrg::bench
