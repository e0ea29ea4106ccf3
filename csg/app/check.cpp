// `cnrg check`: faults of a tree that are found without evaluating it, and small features of a model.
#include <algorithm>
#include <iostream>

#include "csg/app/commands.h"
#include "csg/app/evaluation.h"
#include "csg/app/exit_status.h"
#include "csg/app/output.h"
#include "csg/app/progress_bar.h"
#include "csg/evaluate/evaluate.h"
#include "csg/text/escape.h"
#include "csg/text/table.h"
#include "csg/topology/features.h"

namespace cnrg::app {
namespace {

int list_features(const CheckArguments& arguments) {
  const Tree tree = tree_of(arguments);
  const NodeId node = node_of(tree, arguments.node);
  print(reading_warnings(tree, {tree.result, node}), false);
  EvaluateOptions options;
  options.threads = arguments.threads;
  options.rows = Rows::none;
  options.result = node;
  const Evaluation evaluation = evaluate_in_view(tree, options, false);
  ProgressBar bar(false);
  bar.show("features");
  const std::optional<Rational> below = parse_rational(arguments.features);  // a flag without a value is no number
  const std::string text = at_node(tree, node, [&] {
    const Result result = evaluation.result(node);
    return features_text(result, features(result, below));
  });
  bar.clear();
  std::string head;
  append_line(head, "small features of " + shown(tree.nodes[node].name));
  std::cout << head << text << std::flush;
  return kDone;
}

}  // namespace

int run_check(const CheckArguments& arguments) {
  if (!arguments.features.empty()) return list_features(arguments);
  if (!arguments.node.empty()) {
    throw InputError("cnrg: error: --node says of which node to list features; add --features, or leave it out");
  }
  const Tree tree = tree_of(arguments);
  print(reading_warnings(tree, {tree.result}), false);
  print(check(tree), false);
  const auto leaves =
      std::count_if(tree.nodes.begin(), tree.nodes.end(), [](const Node& n) { return n.op == Operator::leaf; });
  std::cout << shown(tree.file) << ": " << counted(tree.nodes.size(), "node", "nodes") << ", "
            << (tree.nodes.size() > 1 ? std::to_string(leaves) + " of them " : "")
            << (leaves == 1 ? "a leaf" : "leaves") << "; no faults\n";
  return kDone;
}

}  // namespace cnrg::app
