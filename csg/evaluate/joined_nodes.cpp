#include "csg/evaluate/joined_nodes.h"

#include <algorithm>
#include <string>
#include <utility>

#include "csg/result/flat.h"
#include "csg/result/result_data.h"
#include "csg/result/sizes.h"
#include "csg/transfer/stored_value.h"
#include "csg/tree/dag.h"
#include "csg/tree/sizes.h"
#include "kernel/base/part_watch.h"

namespace cnrg {
namespace {

constexpr std::size_t kToldPairs = 20;

/// As nothing is asked of it but its value, its diagnostics and, where all have one, a row per node.
EvaluateOptions options_below(const EvaluateOptions& options) {
  EvaluateOptions below;
  below.threads = options.threads;
  below.validate = options.validate;
  below.rows = options.rows == Rows::all ? Rows::all : Rows::none;
  below.region_volumes = options.region_volumes;
  below.refining = options.refining;
  below.proof = options.proof;
  below.watch = part_of(options.watch, "join");
  return below;
}

std::vector<Diagnostic> diagnostics_of(const Tree& tree, const Node& node, const JoinReport& report) {
  std::vector<Diagnostic> out;
  const auto say = [&](Diagnostic::Level level, const std::string& text) {
    out.push_back({tree.file, node.operator_at, level, "`" + node.name + "`: " + text});
  };
  say(Diagnostic::Level::notice, report.text(*node.within));
  const std::size_t told = std::min(report.merged.size(), kToldPairs);
  for (std::size_t i = 0; i < told; ++i) say(Diagnostic::Level::notice, report.merged[i]);
  if (told < report.merged.size())
    say(Diagnostic::Level::notice, std::to_string(report.merged.size() - told) + " more pairs");
  for (const std::string& warning : report.warnings(*node.within)) say(Diagnostic::Level::warning, warning);
  return out;
}

/// Its leaves may hear a size from users of the node.
Result asking(const Result& result, const Tree& tree) {
  if (!says_sizes(tree)) return result;
  auto data = std::make_shared<Result::Data>(result.data());
  for (LeafInfo& leaf : data->leaves) leaf.asks = leaf.makers == 0;
  return Result(std::move(data));
}

/// By label, as StoredValue gives them.
std::vector<LeafParts> parts_by_label(const ResultView& view, const FlatComplex& flat) {
  std::vector<LeafParts> out(flat.regions.size() + 1);
  const std::vector<LeafParts> parts = region_parts(view, flat);
  for (std::size_t r = 0; r < parts.size(); ++r) out[flat.regions[r].bounded ? r + 1 : 0] = parts[r];
  return out;
}

}  // namespace

JoinedNodes::JoinedNodes(const Tree& tree, const std::vector<NodeId>& roots, const EvaluateOptions& options,
                         const Evaluate& evaluate) {
  if (std::none_of(tree.nodes.begin(), tree.nodes.end(), [](const Node& node) { return node.within.has_value(); }))
    return;
  const std::vector<char> below = tree.dag->reachable(roots);
  const EvaluateOptions alone = options_below(options);
  for (const NodeId id : tree.dag->order()) {
    if (below[id.index()] && tree.nodes[id].within) join_operand(tree, id, alone, evaluate);
  }
}

void JoinedNodes::join_operand(const Tree& tree, NodeId id, const EvaluateOptions& options,
                               const Evaluate& evaluate) {
  const Node& node = tree.nodes[id];
  Evaluation evaluation = evaluate(tree.operands(id).front(), options, leaves_);
  JoinedNode joined{id, {}, std::move(evaluation.rows)};
  try {
    const Result apart = evaluation.result();
    const Result result = join(asking(apart, tree), *node.within, &joined.report, options.watch);
    ResultView view = result.data().view(true);
    // How far joining moves curved surfaces nobody asks.
    view.volume_bound = [&]() -> std::optional<double> {
      return apart.data().volume_bound() == 0.0 ? std::optional(0.0) : std::nullopt;
    };
    FlatComplex flat = flatten(view);
    auto run = std::make_shared<JoinedRun>();
    run->regions = parts_by_label(view, flat);
    run->leaves = *evaluation.leaves;
    run->instances = std::move(evaluation.instances);
    leaves_[id] = {leaf_of(store(view, std::move(flat))), std::move(run)};
  } catch (const TreeError&) {
    throw;
  } catch (const InputError& e) {
    throw TreeError(tree.file, node.operator_at, "`" + node.name + "`: " + e.what());
  }
  refine_seconds_ += evaluation.refine_seconds;
  if (evaluation.certificate) certificate_.add(*evaluation.certificate);
  for (const LeafId leaf : IdRange<LeafId>(evaluation.leaf_names.size())) {
    if (evaluation.parameters->surfaces(leaf)) certificate_.unknown.push_back(evaluation.leaves->node_of(leaf));
  }
  add_diagnostics(std::move(evaluation.diagnostics));
  add_diagnostics(diagnostics_of(tree, node, joined.report));
  joined_.push_back(std::move(joined));
}

/// A leaf that several use is told of once.
void JoinedNodes::add_diagnostics(std::vector<Diagnostic> more) {
  for (Diagnostic& one : more) {
    const std::string text = one.text();
    if (std::none_of(diagnostics_.begin(), diagnostics_.end(), [&](const auto& d) { return d.text() == text; }))
      diagnostics_.push_back(std::move(one));
  }
}

void JoinedNodes::tell(Evaluation& evaluation) {
  if (joined_.empty()) return;
  add_diagnostics(std::move(evaluation.diagnostics));
  evaluation.diagnostics = std::move(diagnostics_);
  evaluation.refine_seconds += refine_seconds_;
  if (evaluation.certificate) {
    certificate_.add(*evaluation.certificate);
    evaluation.certificate = std::make_shared<const Certificate>(certificate_);
  }
  evaluation.joined = std::move(joined_);
}

}  // namespace cnrg
