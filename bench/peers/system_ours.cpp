// The library: one refinement of all operands, groups on it, group Booleans, the point set simplified.
#include <tbb/global_control.h>

#include "bench/cases/soup_of.h"
#include "bench/cases/value_model.h"
#include "bench/peers/built_in.h"
#include "csg/evaluate/evaluate.h"
#include "csg/evaluate/operate.h"
#include "csg/operators/group.h"
#include "kernel/base/error.h"

namespace cnrg::bench {
namespace {

Operator operator_of(Operation operation) {
  switch (operation) {
    case Operation::unite: return Operator::unite;
    case Operation::intersect: return Operator::intersect;
    default: return Operator::subtract;
  }
}

/// One n-ary node, as a tree has it.
NodeValue node_value(const Complex& complex, Operation operation, std::vector<NodeValue> values) {
  Node node;
  node.op = operator_of(operation);
  node.name = "node";
  node.operator_name = to_string(operation);
  node.dominant = DominantOperand::equal;
  std::vector<Operand> operands;
  for (NodeValue& value : values) operands.push_back({&value, "operand", &value, {}});
  return std::move(operate(complex, node, {}, operands, false, {}).value);
}

/// An operand has one leaf, or one for its solid and one for what hangs loose.
NodeValue operand_value(const Complex& complex, std::vector<Group>& groups, const std::vector<LeafId>& leaves) {
  std::vector<NodeValue> values;
  for (const LeafId leaf : leaves) values.emplace_back(complex, std::move(groups[leaf.index()]));
  if (values.size() == 1) return std::move(values[0]);
  return node_value(complex, Operation::unite, std::move(values));
}

/// Runs of one operation are one node each: (m0 op m1 op m2 ...).
NodeValue folded_value(const Complex& complex, const Problem& problem, std::vector<NodeValue> operands) {
  NodeValue value = std::move(operands[0]);
  for (std::size_t i = 0; i < problem.steps.size();) {
    std::vector<NodeValue> run;
    run.push_back(std::move(value));
    std::size_t end = i;
    for (; end < problem.steps.size() && problem.steps[end] == problem.steps[i]; ++end)
      run.push_back(std::move(operands[end + 1]));
    value = node_value(complex, problem.steps[i], std::move(run));
    i = end;
  }
  return value;
}

std::shared_ptr<const Complex> complex_of(const Soup& soup, RefineReport& report) {
  try {
    return build_complex(soup, {.threads = 1}, &report);
  } catch (const InputError& error) {
    throw Refusal("input", error.what());
  }
}

Answer answer_of_ours(const Problem& problem) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  Measurement measurement;
  Soup soup;
  std::vector<std::vector<LeafId>> leaves;
  for (const Model& operand : problem.operands) leaves.push_back(add_model(soup, operand));
  measurement.lap("conversion");
  RefineReport report;
  const auto built_complex = complex_of(soup, report);
  const Complex& complex = *built_complex;
  measurement.lap("complex");
  std::vector<Group> groups = leaf_groups(complex);
  std::vector<NodeValue> operands;
  for (const std::vector<LeafId>& of_operand : leaves)
    operands.push_back(operand_value(complex, groups, of_operand));
  measurement.lap("leaves");
  const NodeValue value = folded_value(complex, problem, std::move(operands));
  measurement.lap("Boolean");
  const SimplifiedComplex simplified = point_set(complex, value);
  measurement.lap("simplify");

  Answer answer;
  answer.measures = measurement.stop();
  answer.model = model_of(complex, simplified);
  answer.exact_share = report.stages.exact_share();
  answer.note = "constructed " + std::to_string(report.constructed);
  return answer;
}

/// As `cnrg eval`: what is below the node in its tree, with the proof of curved surfaces.
Answer answer_of_our_tree(const Problem& problem) {
  if (!problem.tree) throw Refusal("input", "the problem is no node of a tree");
  EvaluateOptions options;
  options.threads = 1;
  options.rows = Rows::none;
  options.result = problem.node;
  Measurement measurement;
  const Evaluation evaluation = evaluate(*problem.tree, options);
  measurement.lap("evaluation");
  evaluation.kept.front().simplified.counts();
  measurement.lap("simplify");
  Answer answer;
  answer.measures = measurement.stop();
  answer.model = model_of(*evaluation.complex, point_set(*evaluation.complex, *evaluation.kept.front().value));
  answer.exact_share = evaluation.refine.stages.exact_share();
  return answer;
}

}  // namespace

System our_tree_system() {
  System system = our_system();
  system.name = "ours-tree";
  system.title = "cnrg, whole tree";
  system.guarantee =
      "a node as `cnrg eval` has it: its leaves are drawn and curved ones proven; exact; one thread";
  system.if_named = true;
  system.evaluate = answer_of_our_tree;
  return system;
}

System our_system() {
  return {.name = "ours",
          .title = "cnrg",
          .guarantee = "solids by winding number, surfaces, wires and points; exact; one thread",
          .version = [] { return std::string(CNRG_VERSION); },
          .rounding = 0,
          .regularized = false,
          .absent = "",
          .evaluate = answer_of_ours};
}

}  // namespace cnrg::bench
