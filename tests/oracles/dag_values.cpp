#include "tests/oracles/dag_values.h"

namespace cnrg::properties {

std::vector<const NodeValue*> DagValues::operands(const DagNode& node) const {
  std::vector<const NodeValue*> out;
  for (const std::size_t i : node.operands) out.push_back(values[i].get());
  return out;
}

DagValues evaluate(const RandomDag& dag, int threads) {
  const Tree tree = parse_tree(tree_file(dag), "dag.yaml");
  EvaluateOptions options;
  options.threads = threads;
  options.validate = true;
  options.keep_all = true;
  DagValues out;
  out.evaluation = evaluate(tree, options);
  out.values.resize(dag.nodes.size());
  for (std::size_t i = 0; i < dag.nodes.size(); ++i) {
    const NodeId node = tree.find(name_of(dag, i));
    for (const InstanceId k : IdRange<InstanceId>(out.evaluation.instances.size()))
      if (out.evaluation.instances[k].node == node) out.values[i] = out.evaluation.values[k];
  }
  return out;
}

Evaluation evaluate_result(const RandomDag& dag) {
  EvaluateOptions options;
  options.threads = 1;
  return evaluate(parse_tree(tree_file(dag), "dag.yaml"), options);
}

Attempt attempt(const RandomDag& dag) {
  Attempt out;
  try {
    out.values = std::make_unique<DagValues>(evaluate(dag));
  } catch (const TreeError& error) {
    out.failure = std::string(kRefused) + error.what();
  } catch (const std::exception& error) {
    out.failure = std::string("thrown: ") + error.what();
  }
  return out;
}

}  // namespace cnrg::properties
