// Nodes of trees as other systems have them: sets of marked cells by Nef polyhedra, regions by OpenCASCADE. And
// that a system that lies is found out.
#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "bench/peers/program.h"
#include "bench/sweep/node_unit.h"
#include "bench/sweep/tree_node.h"
#include "tests/catch.h"

namespace {

using namespace cnrg;
using namespace cnrg::bench;
using Catch::Contains;

/// Two boxes that overlap, a fault through the first one, a wire that leaves it, and every operator.
const std::string kTree = R"(cnrg: 1
nodes:
  a:        {box: {min: [0, 0, 0], max: [2, 2, 2]}}
  b:        {box: {min: [1, 1, 1], max: [3, 3, 3]}}
  fault:    {polygon: [[1/2, -1, -1], [1/2, 3, -1], [1/2, 3, 3], [1/2, -1, 3]]}
  half:     {polygon: [[1/2, -1, -1], [1/2, 1, -1], [1/2, 1, 3], [1/2, -1, 3]]}
  wire:     {polyline: [[1, 1, 1/3], [1, 1, 5]]}
  plane:    {plane: {point: [0, 0, 1], normal: [0, 0, 1]}}
  left:     {union: [a, b], dominance: left}
  right:    {union: [a, b], dominance: right}
  equal:    {union: [a, b]}
  blended:  {union: [a, b], blend: linear}
  parted:   {union: [fault, a], dominance: left}
  whole:    {union: [half, a], dominance: left}
  faulted:  {intersection: [parted, left], dominance: left}
  without:  {difference: [{union: [wire, parted], dominance: left}, b]}
  outside:  {complement: a}
  trimmed:  {difference: [fault, outside]}
  hollow:   {intersection: [b, outside]}
  most:     {sum: [parted, b]}
  common:   {product: [parted, b]}
  rest:     {subtract: [left, fault, b]}
  one:      {unify: left}
  open:     {interior: left}
  again:    {closure: open}
  each:     {interior: left, each: true}
  shell:    {boundary: {union: [wire, left], dominance: left}}
  solid:    {regularize: {union: [wire, left], dominance: left}}
  kept:     {union: [wire, a], regularize: true}
  simple:   {simplify: left}
  apart:    {aggregate: [{interior: a}, {box: {min: [5, 0, 0], max: [6, 1, 1]}}, {boundary: a}]}
  moved:    {union: [a, b], dominance: left, translate: [1/3, 0, 0]}
  low:      {below: plane, within: a}
  picked:   {select: {of: left, dimension: 3}}
  endless:  {union: [plane, a], dominance: left}
result: left
)";

/// Rows of both kinds, by experiment and node.
class Nodes {
 public:
  explicit Nodes(const std::string& tree = kTree) {
    std::ofstream(folder_.file("t.yaml")) << tree;
    setup_.systems = systems();
    setup_.asserted = CNRG_ASSERTED;
    setup_.seconds = 60;
    std::set<std::string> used;
    for (Experiment& experiment : read_experiments(folder_.file("t.yaml"), {}, used)) {
      for (const Experiment::Named& problem : experiment.problems())
        setup_.problems.push_back({setup_.experiments.size(), problem});
      setup_.experiments.push_back(std::move(experiment));
    }
  }

  bool has_occt() const { return setup_.system("occt").absent.empty(); }
  const System& system(const std::string& name) const { return setup_.system(name); }
  void add(System system) { setup_.systems.push_back(std::move(system)); }
  SweepRow row(const std::string& problem, const std::string& system) const {
    return run_unit(setup_, problem, system, Truth{});
  }
  std::vector<std::string> problems(Compared compared) const {
    std::vector<std::string> names;
    for (const auto& [experiment, problem] : setup_.problems)
      if (setup_.experiments[experiment].compared == compared) names.push_back(problem.name);
    return names;
  }

 private:
  TemporaryFolder folder_;
  Setup setup_;
};

void check_refusal(const SweepRow& row, const std::map<std::string, std::string>& stages) {
  INFO(row.problem << ", " << row.system << ": " << row.message);
  const std::string node = row.values.at("node");
  CHECK(row.verdict == (stages.contains(node) ? Verdict::refused : Verdict::same));
  CHECK(row.stage == (stages.contains(node) ? stages.at(node) : ""));
}

}  // namespace

TEST_CASE("Nef polyhedra have the marked cells of every node", "[nodes]") {
  const Nodes nodes;
  const std::vector<std::string> problems = nodes.problems(Compared::sets);
  CHECK(problems.size() == 32);  // 27 with a name, 5 inline
  for (const std::string& problem : problems) {
    const SweepRow row = nodes.row(problem, "nef");
    check_refusal(row, {{"low", "operator"}, {"picked", "operator"}, {"endless", "operand"}});
    if (row.verdict != Verdict::same) continue;
    CHECK(row.confirmation.by == "Nef");
    CHECK(row.truth.confirmed == "Nef");
  }
  CHECK_THAT(nodes.row("t.sets-picked", "nef").message, Contains("no other system has `select`"));
}

TEST_CASE("OpenCASCADE has the regions of every node", "[nodes]") {
  const Nodes nodes;
  if (!nodes.has_occt()) return;
  for (const std::string& problem : nodes.problems(Compared::regions))
    check_refusal(nodes.row(problem, "occt"),
                  {{"low", "operator"}, {"picked", "operator"}, {"outside", "value"}, {"endless", "operand"}});
}

TEST_CASE("another set is told from the value, if one cell differs", "[nodes]") {
  const Nodes nodes;
  const auto problem_of = [](const std::string& node) {
    Tree tree = parse_tree(kTree, "t.yaml");
    const NodeId id = tree.find(node);
    return TreeNode(std::move(tree), id).set_problem();
  };
  const auto difference = [&](const SetProblem& problem) {
    return nodes.system("nef").compare_sets(problem).difference;
  };
  for (const char* node : {"left", "open", "shell", "without", "outside"}) {
    INFO(node);
    CHECK(difference(problem_of(node)).empty());
  }
  SetProblem open = problem_of("open");
  open.value.layers.pop_back();  // closed now
  CHECK_THAT(difference(open), Catch::StartsWith("too much: ") && Contains("12 facets"));
  SetProblem closed = problem_of("again");
  closed.value = problem_of("open").value;
  CHECK_THAT(difference(closed), Catch::StartsWith("missing: "));
  SetProblem outside = problem_of("outside");
  outside.value.complement = false;
  CHECK_THAT(difference(outside), Contains("too much: ") && Contains("missing: "));
  SetProblem bare = problem_of("without");
  bare.value.layers.at(0).wires.pop_back();
  CHECK_THAT(difference(bare), Catch::StartsWith("missing: ") && Contains(" 1 edges"));
  SetProblem point = problem_of("left");
  point.value.layers.at(0).points.push_back({9, 9, 9});
  point.value.layers.at(0).isolated.push_back(static_cast<std::uint32_t>(point.value.layers[0].points.size() - 1));
  CHECK(difference(point) == "too much: 1 vertices, 0 edges, 0 facets, 0 volumes, one of them at 9, 9, 9");
  SetProblem other = problem_of("rest");
  std::replace(other.words.begin(), other.words.end(), std::string("without"), std::string("union"));
  CHECK_THAT(difference(other), Catch::StartsWith("missing: "));
}

TEST_CASE("a system that lies about a set is wrong, and the truth disputed", "[nodes]") {
  Nodes nodes;
  System liar = nodes.system("nef");
  liar.name = "liar";
  liar.asserted = false;
  liar.compare_sets = [honest = liar.compare_sets](SetProblem problem) {
    problem.words.push_back("closure");
    return honest(problem);
  };
  nodes.add(liar);
  CHECK(nodes.row("t.sets-left", "liar").verdict == Verdict::same);  // it is closed
  const SweepRow row = nodes.row("t.sets-open", "liar");
  CHECK(row.verdict == Verdict::wrong);
  CHECK(row.stage == "set");
  CHECK_THAT(row.message, Catch::StartsWith("missing: "));
  CHECK(row.truth.confirmed == "DISAGREES");
}

TEST_CASE("a system that lies about regions is wrong", "[nodes]") {
  Nodes nodes;
  if (!nodes.has_occt()) return;
  int liars = 0;
  const auto row = [&](const std::string& node, const std::function<void(Arrangement&)>& lie) {
    System liar = nodes.system("occt");
    liar.name = "liar" + std::to_string(++liars);
    liar.arrange = [lie, honest = liar.arrange](const std::vector<ParcelledOperand>& operands) {
      Arrangement arrangement = honest(operands);
      lie(arrangement);
      return arrangement;
    };
    nodes.add(liar);
    return nodes.row("t.regions-" + node, liar.name);
  };
  const auto is_wrong = [&](const std::string& node, const std::function<void(Arrangement&)>& lie,
                            const std::string& words) {
    const SweepRow found = row(node, lie);
    INFO(node << ": " << found.message);
    CHECK(found.verdict == Verdict::wrong);
    CHECK(found.stage == "regions");
    CHECK_THAT(found.message, Contains(words));
  };
  is_wrong(
      "left", [](Arrangement& a) { a.parts[1].volume += 1e-3; }, "2 regions, ours 2; ours alone: ");
  CHECK(row("left", [](Arrangement& a) { a.parts[1].volume += 1e-9; }).verdict == Verdict::same);
  const auto no_walls = [](Arrangement& a) {
    for (Arrangement::Face& face : a.faces) face.of.assign(face.of.size(), 0);
  };
  is_wrong("left", no_walls, "1 regions, ours 2");
  is_wrong("parted", no_walls, "1 regions, ours 2");
  is_wrong("faulted", no_walls, "1 regions, ours ");
  // The overlap given to nobody, and to the other operand alone.
  const auto in_both = [](const Arrangement::Part& part) { return part.regions[0] != 0 && part.regions[1] != 0; };
  const auto given_to = [&](std::vector<std::uint32_t> regions) {
    return [=](Arrangement& a) {
      for (Arrangement::Part& part : a.parts)
        if (in_both(part)) part.regions = regions;
    };
  };
  for (const char* node : {"left", "common", "most"}) is_wrong(node, given_to({0, 0}), "ours alone: ");
  is_wrong("left", given_to({0, 1}), "theirs alone: ");
}

TEST_CASE("what is thinner than the rounding is told apart from what is wrong", "[nodes]") {
  RegionProblem problem;
  problem.operands.resize(1);
  problem.extent = 1;
  problem.regions = {{{{1}, {1, 6}}}, {{{2}, {Rational(1) / 100'000'000, 2}}}};
  const auto verdict = [&](const std::vector<FoundRegion>& found, double rounding, const Walls& walls = {}) {
    return judge_regions(problem, {found, walls}, rounding).verdict;
  };
  CHECK(verdict({{{{1}, 1}}, {{{2}, 1e-8}}}, 1e-7) == Verdict::same);
  CHECK(verdict({{{{1}, 1}}}, 1e-7) == Verdict::within_rounding);
  CHECK(verdict({{{{1}, 1}}}, 1e-12) == Verdict::wrong);
  CHECK(verdict({{{{2}, 1e-8}}}, 1e-7) == Verdict::wrong);
  CHECK(verdict({{{{1}, 1}}, {{{2}, 1e-8}}, {{{3}, 1e-2}}}, 1e-7) == Verdict::wrong);
  // Two that share a wall are not one; two that share none may be, at a gap; and the other way round at a bridge.
  problem.regions = {{{{1}, {1, 6}}}, {{{1}, {2, 10}}}};
  CHECK(verdict({{{{1}, 3}}}, 1e-7) == Verdict::within_rounding);
  CHECK(verdict({{{{1}, 3.1}}}, 1e-7) == Verdict::wrong);
  problem.walls = {{{0, 1}, 1}};
  CHECK(verdict({{{{1}, 3}}}, 1e-7) == Verdict::wrong);
  problem.regions = {{{{1}, {3, 14}}}};
  problem.walls = {};
  CHECK(verdict({{{{1}, 1}}, {{{1}, 2}}}, 1e-7) == Verdict::within_rounding);
  CHECK(verdict({{{{1}, 1}}, {{{1}, 2}}}, 1e-7, {{{0, 1}, 1}}) == Verdict::wrong);
}

TEST_CASE("problems of sets are written and read", "[nodes]") {
  Tree tree = parse_tree(kTree, "t.yaml");
  const NodeId id = tree.find("rest");
  const SetProblem problem = TreeNode(std::move(tree), id).set_problem();
  std::stringstream text;
  write_set_problem(text, problem);
  std::ostringstream again;
  write_set_problem(again, read_set_problem(text));
  CHECK(again.str() == text.str());
  CHECK(problem.words == std::vector<std::string>{"0", "1", "without", "2", "without"});
  for (const char* broken : {"", "words\noperands x\n", "words\noperands 1\nmodel", "words\noperands 0\nset a"}) {
    std::istringstream in(broken);
    CHECK_THROWS_AS(read_set_problem(in), std::runtime_error);
  }
}
