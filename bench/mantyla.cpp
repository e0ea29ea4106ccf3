// Mäntylä's Boolean stage after stage: a table on the terminal, and a tree file with a node per stage.
#include <algorithm>
#include <filesystem>

#include "bench/baseline/steps_tree.h"
#include "bench/cases/tree_problem.h"
#include "bench/command.h"
#include "bench/sweep/judge.h"
#include "bench/sweep/store.h"
#include "csg/text/table.h"
#include "csg/tree/tree_of_file.h"

namespace cnrg::bench {
namespace {

struct Options {
  std::vector<std::string> files;
  std::string operation, node, system = "mantyla-published", tree;
};

Problem problem_of(const Options& options) {
  if (options.files.size() == 1) {
    if (!options.operation.empty())
      throw std::runtime_error("--operation is for two files; the node of a tree has its own");
    const Tree tree = tree_of_file(options.files[0]);
    Problem problem = tree_problem(tree, options.node.empty() ? tree.result : tree.find(options.node));
    if (problem.steps.size() != 1)
      throw std::runtime_error(
          options.files[0] + ": the node has " + std::to_string(problem.operands.size()) +
          " operands, and two are looked at: name a node for each step, and give one with --node");
    return problem;
  }
  if (!options.node.empty()) throw std::runtime_error("--node is for one tree; with two files leave it out");
  const std::string name = options.operation.empty() ? "union" : options.operation;
  const std::optional<Operation> operation = parse_operation(name);
  if (!operation)
    throw std::runtime_error("'" + name + "' is no operation; there are union, difference, intersection");
  Problem problem;
  problem.steps = {*operation};
  for (const std::string& file : options.files) {
    const Tree tree = tree_of_file(file);
    problem.operands.push_back(operand_model(tree, tree.result));
  }
  return problem;
}

void print(const mantyla::Steps& steps) {
  using mantyla::Stage;
  const mantyla::StepCounts& counts = steps.counts;
  const auto row = [](Stage stage, const std::string& text) {
    std::printf("%-15s %s\n", to_string(stage), shown(text).c_str());
  };
  const std::pair<Stage, std::string> rows[] = {
      {Stage::reduction, counted(counts.contacts, "contact", "contacts")},
      {Stage::classification, counted(counts.crossings, "crossing", "crossings") + " of neighbourhoods"},
      {Stage::null_edges, counted(counts.null_pairs, "pair", "pairs") + " of null edges"},
      {Stage::connecting, counted(counts.loops, "loop", "loops")},
      {Stage::finishing, "parted and glued"},
      {Stage::output, std::to_string(steps.result.points.size()) + " vertices, " +
                          counted(steps.result.faces.size(), "face", "faces")}};
  for (const auto& [stage, text] : rows) {
    if (steps.failure && stage >= steps.failure->stage()) break;
    row(stage, text);
  }
  if (!steps.failure) return;
  row(steps.failure->stage(), std::string("fails: ") + steps.failure->what());
  for (const RationalPoint& p : steps.failure->places())
    std::printf("%-15s at %s, %s, %s\n", "", cnrg::to_string(p[0]).c_str(), cnrg::to_string(p[1]).c_str(),
                cnrg::to_string(p[2]).c_str());
}

int run(const Options& options) {
  const std::optional<mantyla::Variant> variant = mantyla::parse_variant(options.system);
  if (!variant)
    throw std::runtime_error("'" + options.system +
                             "' is no variant of Mäntylä's; such are mantyla-published, mantyla-published-exact, "
                             "mantyla-double:1e-8, mantyla-exact");
  const Problem problem = problem_of(options);
  const Model &a = problem.operands[0], &b = problem.operands[1];
  const mantyla::Steps steps = mantyla::steps_of(a, b, problem.steps[0], *variant);
  mantyla::StepsTitle title{options.system, "", false, false};
  if (steps.failure) {
    title.verdict = std::string("refused in ") + to_string(steps.failure->stage()) + ": " + steps.failure->what();
  } else {
    const Judgement judgement = judge(problem, steps.result, variant->fractions ? 0 : variant->epsilon);
    title.verdict = to_string(judgement.verdict) + (judgement.message.empty() ? "" : ": " + judgement.message);
    title.solid = judgement.facts.has_value();
    title.differs = judgement.verdict != Verdict::same && judgement.verdict != Verdict::contact_duplicated;
  }
  print(steps);
  std::printf("%-15s %s\n", "verdict", shown(title.verdict).c_str());
  if (!options.tree.empty()) write_whole(options.tree, steps_tree(a, b, problem.steps[0], steps, title));
  return 0;
}

int main_of_mantyla(int argc, char** argv) {
  CLI::App program("Mäntylä's Boolean of two solids, stage after stage, and its result beside the exact one",
                   "bench/run mantyla");
  Options options;
  program
      .add_option("FILES", options.files,
                  "Two solids, as meshes or trees; or one tree with a Boolean of two operands")
      ->required()
      ->expected(1, 2)
      ->type_name("A B | TREE");
  program
      .add_option("--operation", options.operation, "Of two files: union (without it), difference, intersection")
      ->type_name("NAME");
  program.add_option("--node", options.node, "Of a tree: this node, without it the result")->type_name("NAME");
  program.add_option("--system", options.system, "Which variant; as in sweeps")
      ->type_name("NAME")
      ->capture_default_str();
  program.add_option("--tree", options.tree, "Write the stages as nodes of this tree file")
      ->type_name("FILE.yaml");
  program.footer("\nbench/run mantyla ... --steps PAGE.html: the tree as a page of cnrg view, one node per stage");
  return command(program, argc, argv, [&] { return run(options); });
}

}  // namespace
}  // namespace cnrg::bench

int main(int argc, char** argv) { return cnrg::bench::main_of_mantyla(argc, argv); }
