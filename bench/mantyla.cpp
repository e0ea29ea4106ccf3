// Mäntylä's Boolean stage after stage: a table on the terminal, and a tree file with a node per stage.
#include <functional>
#include <sstream>

#include "bench/baseline/steps_tree.h"
#include "bench/cases/tree_problem.h"
#include "bench/command.h"
#include "bench/sweep/judged.h"
#include "bench/sweep/process.h"
#include "bench/sweep/store.h"
#include "csg/text/table.h"
#include "csg/tree/tree_of_file.h"

namespace cnrg::bench {
namespace {

struct Options {
  std::vector<std::string> files;
  std::string operation, node, system = "mantyla-published", tree;
  std::optional<double> seconds, gigabytes;
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

void print_row(std::ostream& out, const std::string& name, const std::string& text) {
  out << name << std::string(name.size() < 15 ? 16 - name.size() : 1, ' ') << shown(text) << '\n';
}

void print(std::ostream& out, const mantyla::Steps& steps) {
  using mantyla::Stage;
  const mantyla::StepCounts& counts = steps.counts;
  const auto row = [&](Stage stage, const std::string& text) { print_row(out, to_string(stage), text); };
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
    print_row(out, "",
              "at " + cnrg::to_string(p[0]) + ", " + cnrg::to_string(p[1]) + ", " + cnrg::to_string(p[2]));
}

/// What a process says, which is given nothing but the options: operands may be such that nothing ever ends.
Reply told_of(const Options& options, const Limits& limits,
              const std::function<nlohmann::json(std::ostream&, const Problem&, const mantyla::Steps&)>& work) {
  const mantyla::Variant variant = mantyla::parse_variant(options.system).value();
  Told told = cnrg::bench::told(limits, [&](std::ostream& out) {
    const Problem problem = problem_of(options);
    const mantyla::Steps steps =
        mantyla::steps_of(problem.operands[0], problem.operands[1], problem.steps[0], variant);
    return work(out, problem, steps);
  });
  if (told.reply.head.is_null())
    throw std::runtime_error(told.reason + ": --seconds and --gigabytes give it more, or take smaller operands");
  if (!told.reason.empty()) throw std::runtime_error(told.reason);
  return std::move(told.reply);
}

/// Verdict on the result that Mäntylä's Boolean has.
mantyla::StepsTitle title_of(const Options& options, const Limits& limits) {
  const mantyla::Variant variant = mantyla::parse_variant(options.system).value();
  const Reply reply = told_of(
      options, limits, [](std::ostream& out, const Problem&, const mantyla::Steps& steps) -> nlohmann::json {
        if (steps.failure)
          return {{"refused",
                   std::string("refused in ") + to_string(steps.failure->stage()) + ": " + steps.failure->what()}};
        write_model(out, steps.result);
        return nlohmann::json::object();
      });
  if (reply.head.contains("refused")) return {options.system, reply.head["refused"], false, false};
  const auto [judgement, reason] = judged([&] { return problem_of(options); }, judging_limits(limits),
                                          variant.fractions ? 0 : variant.epsilon, reply.rest);
  if (!judgement) return {options.system, "unjudged: " + reason, false, true};
  return {options.system,
          to_string(judgement->verdict) + (judgement->message.empty() ? "" : ": " + judgement->message),
          judgement->facts.has_value(),
          judgement->verdict != Verdict::same && judgement->verdict != Verdict::contact_duplicated};
}

int run(const Options& options) {
  if (!mantyla::parse_variant(options.system))
    throw std::runtime_error("'" + options.system +
                             "' is no variant of Mäntylä's; such are mantyla-published, mantyla-published-exact, "
                             "mantyla-double:1e-8, mantyla-exact");
  const Limits limits = run_limits(options.seconds, options.gigabytes);
  const mantyla::StepsTitle title = title_of(options, limits);
  const Reply reply =
      told_of(options, limits, [&](std::ostream& out, const Problem& problem, const mantyla::Steps& steps) {
        std::ostringstream table;
        print(table, steps);
        print_row(table, "verdict", title.verdict);
        if (!options.tree.empty())
          out << steps_tree(problem.operands[0], problem.operands[1], problem.steps[0], steps, title);
        return nlohmann::json{{"table", table.str()}};
      });
  std::fputs(reply.head.at("table").get<std::string>().c_str(), stdout);
  if (!options.tree.empty()) write_whole(options.tree, reply.rest);
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
  add_limits(program, options.seconds, options.gigabytes, ", and five times as long for the verdict");
  program.add_option("--tree", options.tree, "Write the stages as nodes of this tree file")
      ->type_name("FILE.yaml");
  program.footer("\nbench/run mantyla ... --steps PAGE.html: the tree as a page of cnrg view, one node per stage");
  return command(program, argc, argv, [&] { return run(options); });
}

}  // namespace
}  // namespace cnrg::bench

int main(int argc, char** argv) { return cnrg::bench::main_of_mantyla(argc, argv); }
