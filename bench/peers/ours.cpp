#include <tbb/global_control.h>

#include "bench/cases/boolean_node.h"
#include "bench/cases/soup_of.h"
#include "bench/peers/peer.h"
#include "csg/evaluate/evaluate.h"
#include "csg/operators/group.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/simplify.h"

namespace cnrg::bench {
namespace {

Outcome evaluate_trees(const Case& c, int threads) {
  std::vector<Tree> trees;
  for (const std::string& text : c.trees) trees.push_back(parse_tree(text, "tree.yaml"));
  EvaluateOptions options;
  options.threads = threads;
  options.rows = Rows::kept;
  Outcome outcome;
  Rational volume = 0;
  Measurement measurement;
  for (const Tree& tree : trees) {
    const Evaluation evaluation = cnrg::evaluate(tree, options);
    const SimplifiedComplex& result = *evaluation.kept[0].simplified;
    outcome.vertices += result.vertices.size();
    outcome.faces += result.faces.size();
    for (const NodeRow& row : evaluation.rows) {
      if (row.node == evaluation.kept[0].node && row.total) volume += *row.total;
    }
  }
  measurement.lap("evaluation");
  outcome.measures = measurement.stop();
  outcome.volume = to_double(volume);
  outcome.exact_volume = cnrg::to_string(volume);
  outcome.note = "exact";
  return outcome;
}

}  // namespace

Outcome evaluate_ours(const Case& c, const Checks& checks, int threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  if (!c.trees.empty()) return evaluate_trees(c, threads);
  const Soup soup = soup_of(c);
  RefineReport report;
  Measurement measurement;
  const auto built_complex = build_complex(soup, {.threads = threads}, &report);
  const Complex& complex = *built_complex;
  measurement.lap("complex");
  std::vector<NodeValue> leaves = values_of(complex, leaf_groups(complex));
  measurement.lap("leaves");
  const NodeValue value = evaluate_node(complex, c.operation, leaves).value;
  measurement.lap("Boolean");
  const Selection selection = selection_of(complex, value);
  const SimplifiedComplex simplified = simplify(complex, selection, value.features());
  measurement.lap("simplify");

  Outcome outcome;
  outcome.measures = measurement.stop();
  outcome.vertices = simplified.vertices.size();
  outcome.faces = simplified.faces.size();
  outcome.cells = complex.vertex_count() + complex.edge_count() + complex.face_count() + complex.region_count;
  outcome.exact_share = report.stages.exact_share();
  outcome.note = "exact; constructed " + std::to_string(report.constructed);
  if (checks.volume) {
    const Rational exact = volume(complex, support(selection).regions).value();
    outcome.volume = to_double(exact);
    outcome.exact_volume = cnrg::to_string(exact);
  }
  if (checks.validate) {
    outcome.invalid = validate(complex);
    outcome.note += outcome.invalid.empty() ? ", valid" : ", INVALID: " + outcome.invalid;
  }
  return outcome;
}

}  // namespace cnrg::bench
