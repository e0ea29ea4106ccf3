#include "bench/sweep/node_unit.h"

#include <sstream>

#include "bench/sweep/tree_node.h"

namespace cnrg::bench {
namespace {

TreeNode made_node(const Setup& setup, const std::string& problem) {
  const Setup::Planned& planned = setup.planned(problem);
  Tree tree = setup.experiments[planned.experiment].tree(planned.problem);
  const NodeId node = tree.find(planned.problem.values.at("node"));
  return {std::move(tree), node};
}

std::string sets_text(const Setup& setup, const System& system, const TreeNode& node) {
  const SetProblem sets = node.set_problem();
  if (!system.asserted) return comparison_text(sets, system);
  std::ostringstream problem;
  write_set_problem(problem, sets);
  return asserted_text(setup.asserted, "compare", system.name, problem.str());
}

std::string regions_text(const System& system, const TreeNode& node) {
  const RegionProblem problem = node.region_problem();
  Measurement measurement;
  const Arrangement arrangement = system.arrange(problem.operands);
  measurement.lap("arrangement");
  const Measures measures = measurement.stop();
  const RegionJudgement judgement = judge_regions(problem, regions_of(problem, arrangement), system.rounding);
  return comparison_text(judgement.verdict, judgement.verdict == Verdict::same ? "" : "regions", judgement.message,
                         measures);
}

/// Nef polyhedra are what the value is compared with; of regions volumes and places alone are looked at.
void set_confirmation(Compared compared, SweepRow& row) {
  if (compared == Compared::regions) {
    row.confirmation = {"none", "numbers and volumes of regions are compared, not their points"};
    return;
  }
  const bool same = row.verdict == Verdict::same;
  row.confirmation = {"Nef", ""};
  row.truth.confirmed = same ? "Nef" : "DISAGREES";
  if (!same) row.truth.reason = row.system + ": " + row.message;
}

}  // namespace

bool can_compare(const System& system, Compared compared) {
  switch (compared) {
    case Compared::results: return static_cast<bool>(system.evaluate);
    case Compared::sets: return static_cast<bool>(system.compare_sets);
    case Compared::regions: break;
  }
  return static_cast<bool>(system.arrange);
}

nlohmann::json described_node(const Setup& setup, const std::string& problem) {
  const TreeNode node = made_node(setup, problem);
  std::ostringstream text;
  std::size_t triangles = 0;
  try {
    const SetProblem sets = node.set_problem();
    write_set_problem(text, sets);
    for (const MarkedSet& operand : sets.operands)
      for (const Model& layer : operand.layers) triangles += layer.triangle_count();
  } catch (const Refusal&) {  // each row says so, and there is nothing to tell apart
  }
  return {{"operands", node.operand_count()},
          {"digest", digest(text.str())},
          {"triangles", triangles},
          {"operation", node.node().operator_name}};
}

void compare_node(const Setup& setup, const System& system, SweepRow& row) {
  const Compared compared = setup.experiment_of(row.problem).compared;
  const Limits limits = setup.limits(row.problem);
  const Run run = run_made<TreeNode>(
      row.problem, compared == Compared::sets ? judging_limits(limits) : limits,
      [&] { return made_node(setup, row.problem); },
      [&](const TreeNode& node) {
        return guarded_reply([&] {
          return compared == Compared::sets ? sets_text(setup, system, node) : regions_text(system, node);
        });
      });
  row.peak_bytes = run.child.peak_bytes;
  row.truth.facts.volume.clear();
  if (!run.answered()) {
    no_answer(run, row);
    return;
  }
  const nlohmann::json& head = run.reply.head;
  for (const nlohmann::json& stage : head.at("stages")) {
    row.stages.emplace_back(stage.at(0).get<std::string>(), stage.at(1).get<double>());
    row.seconds += row.stages.back().second;
  }
  head.at("own_bytes").get_to(row.own_bytes);
  row.verdict = parse_verdict(head.at("verdict").get<std::string>()).value();
  head.at("stage").get_to(row.stage);
  head.at("message").get_to(row.message);
  if (compared == Compared::sets) row.note = "with CGAL's assertions";
  set_confirmation(compared, row);
}

}  // namespace cnrg::bench
