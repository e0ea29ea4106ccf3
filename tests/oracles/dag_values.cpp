#include "tests/oracles/dag_values.h"

#include <algorithm>
#include <sstream>

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

void Coverage::add(const RandomDag& dag) {
  ++dags_;
  std::vector<int> uses(dag.nodes.size());
  for (const DagNode& node : dag.nodes) {
    for (const std::size_t i : node.operands) ++uses[i];
    if (node.op == Operator::leaf) continue;
    ++inner_;
    ++operators_[operator_name(node)];
    each_ += node.each;
    regularized_ += node.regularize;
  }
  shared_ += std::any_of(uses.begin(), uses.end(), [](int n) { return n > 1; });
  ++depths_[depths(dag).back()];
}

std::string Coverage::text() const {
  std::ostringstream out;
  out << dags_ << " dags, " << inner_ << " inner nodes, " << shared_ << " dags with shared nodes, " << each_
      << " nodes with `each`, " << regularized_ << " with the attribute `regularize`\noperators:";
  for (const auto& [name, count] : operators_) out << " " << name << " " << count;
  out << "\ndepths:";
  for (const auto& [depth, count] : depths_) out << " " << depth << ": " << count << ";";
  return out.str();
}

bool Coverage::complete() const {
  // 14 operators; interior, closure, boundary and regularize with `each` too, simplify in both modes.
  return operators_.size() == 19 && shared_ > 0 && regularized_ > 0 && depths_.contains(8);
}

}  // namespace cnrg::properties
