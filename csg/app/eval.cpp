// `cnrg eval` and `cnrg check`.
#include <algorithm>
#include <iostream>
#include <map>

#include "csg/app/commands.h"
#include "csg/app/evaluation.h"
#include "csg/app/exit_status.h"
#include "csg/app/output.h"
#include "csg/app/progress_bar.h"
#include "csg/app/row_table.h"
#include "csg/evaluate/evaluate.h"
#include "csg/formats/result_file.h"
#include "csg/operators/node_value.h"
#include "csg/text/escape.h"
#include "csg/topology/topology.h"

namespace cnrg::app {
namespace {

/// Files and the nodes that they show: the result; or the one `--node`; or one `--node` for each file.
std::vector<NodeId> nodes_of_files(const Tree& tree, const EvalArguments& arguments,
                                   const std::vector<NodeId>& nodes) {
  const std::size_t n = arguments.files.size();
  if (nodes.empty()) return std::vector<NodeId>(n, tree.result);
  if (nodes.size() == 1) return std::vector<NodeId>(n, nodes[0]);
  if (n != 0 && nodes.size() != n) {
    throw InputError(
        "cnrg: error: " + std::to_string(nodes.size()) + " times --node and " + std::to_string(n) +
        " times -o; give no --node (the files show the result), one for all files, or one for each file");
  }
  return nodes;
}

/// Writes files, and snaps each node that they show once.
class FileWriter {
 public:
  FileWriter(const Tree& tree, const Evaluation& evaluation, const EvalArguments& arguments)
      : tree_(tree), evaluation_(evaluation), arguments_(arguments) {}

  void write_file(const std::string& path, NodeId node) {
    const bool snaps = arguments_.snap && !is_exact(path);
    RoundingReport rounding;
    const Snapped* snapped = nullptr;
    {
      ProgressBar bar(arguments_.quiet);
      if (snaps) {
        bar.show("snap " + tree_.nodes[node].name, 0, 0);
        snapped = &snapped_of(node);
      }
      bar.show("write " + path, 0, 0);
      if (shows_dag(path)) {
        write(path, evaluation_);
      } else {
        const Result shown = snaps ? snapped->result : evaluation_.result(node);
        rounding = at_node(tree_, node, [&] { return write(path, shown, {arguments_.parameters}); });
      }
    }
    if (!rounding.embedded) {
      tell(path + ": warning: rounding moved " + std::to_string(rounding.moved) +
           " vertices and facets cross in this file; use --snap, or write .json for the exact result");
    } else if (!arguments_.quiet && rounding.moved > 0) {
      tell(path + ": notice: rounding moved " + std::to_string(rounding.moved) +
           " vertices; the facets still meet as they should");
    } else if (!arguments_.quiet && snaps && snapped->report.rounds > 0) {
      tell(path + ": notice: " + snapped->report.text());
    } else if (!arguments_.quiet && arguments_.snap && !snaps) {
      tell(path + ": notice: this format is exact; --snap changes nothing in it");
    }
  }

 private:
  const Tree& tree_;
  const Evaluation& evaluation_;
  const EvalArguments& arguments_;
  struct Snapped {
    SnapReport report;
    Result result;
  };
  std::map<NodeId, Snapped> snapped_;

  const Snapped& snapped_of(NodeId node) {
    const auto found = snapped_.find(node);
    if (found != snapped_.end()) return found->second;
    SnapReport report;
    Result result = at_node(tree_, node, [&] { return snap(evaluation_.result(node), &report); });
    return snapped_.emplace(node, Snapped{report, std::move(result)}).first->second;
  }
};

/// Of the nodes asked for; of the result when there are none.
std::string topology_of(const Tree& tree, const Evaluation& evaluation, std::vector<NodeId> nodes) {
  if (nodes.empty()) nodes = {tree.result};
  std::string text;
  for (const NodeId node : nodes) {
    const KeptValue& kept = evaluation.value(node);
    append_line(text += "\n", "topology of " + tree.nodes[node].name);
    text += topology_text(*evaluation.complex, selection_of(*evaluation.complex, *kept.value), *kept.simplified,
                          kept.value->attributes());
  }
  return text;
}

}  // namespace

int run_eval(const EvalArguments& arguments) {
  require_distinct(arguments.files);
  for (const std::string& path : arguments.files) check_file_name(path);  // before the work, not after it
  const Tree tree = tree_of(arguments);
  require_writable(arguments.files, tree);
  EvaluateOptions options;
  options.threads = arguments.threads;
  options.raw = arguments.raw;
  options.rows = !arguments.quiet || std::any_of(arguments.files.begin(), arguments.files.end(), shows_dag);
  options.region_volumes = arguments.trace;
  for (const std::string& name : arguments.nodes) options.nodes.push_back(node_of(tree, name));
  const std::vector<NodeId> shown = nodes_of_files(tree, arguments, options.nodes);
  std::vector<NodeId> roots = options.nodes;
  roots.push_back(tree.result);
  print(unused_nodes(tree, roots), arguments.quiet);

  const Evaluation evaluation = evaluate_in_view(tree, options, arguments.quiet);
  if (arguments.certify) require_certain(tree, evaluation, arguments.quiet);
  else tell_uncertain(tree, evaluation, arguments.quiet);
  if (!arguments.quiet) std::cout << row_table(evaluation.rows, arguments.raw, arguments.trace);
  if (!arguments.quiet && arguments.trace) std::cout << refinement_summary(evaluation);
  if (arguments.topology) std::cout << topology_of(tree, evaluation, options.nodes);
  std::cout << std::flush;

  FileWriter writer(tree, evaluation, arguments);
  for (std::size_t i = 0; i < arguments.files.size(); ++i) writer.write_file(arguments.files[i], shown[i]);
  return kDone;
}

int run_check(const CheckArguments& arguments) {
  const Tree tree = tree_of(arguments);
  print(unused_nodes(tree, {tree.result}), false);
  print(check(tree), false);
  const auto leaves =
      std::count_if(tree.nodes.begin(), tree.nodes.end(), [](const Node& n) { return n.op == Operator::leaf; });
  std::cout << shown(arguments.tree) << ": " << tree.nodes.size() << " nodes, " << leaves
            << " of them leaves; no faults\n";
  return kDone;
}

}  // namespace cnrg::app
