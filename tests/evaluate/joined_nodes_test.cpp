// `simplify` with `within`: what it hands on is what `join` makes of the operand's result, wherever it goes then.
#include "csg/evaluate/joined_nodes.h"

#include "csg/result/join.h"
#include "kernel/base/error.h"
#include "tests/catch.h"
#include "tests/result/region_volumes.h"
#include "tests/scenes/seeds.h"

using namespace cnrg;

namespace {

Tree parse(const std::string& nodes, const std::string& result) {
  return parse_tree("cnrg: 1\nnodes:\n" + nodes + "result: " + result + "\n", "t.yaml");
}

Evaluation evaluation_of(const Tree& tree, const std::vector<std::string>& nodes) {
  EvaluateOptions options;
  options.validate = true;
  for (const std::string& name : nodes) options.nodes.push_back(tree.find(name));
  return evaluate(tree, options);
}

/// Of a node without the others: which points are constructed, and so which go, depends on who is there.
Result alone(Tree tree, const std::string& node) {
  tree.result = tree.find(node);
  return evaluate(tree).result();
}

Rational sum_of(const std::map<std::string, Rational>& volumes) {
  Rational all = 0;
  for (const auto& [name, volume] : volumes) all += volume;
  return all;
}

const char* const kGaps = R"(
  bolt:   {polyline: [[60, 50, 30], [60, 50, 47.9999]], name: steel}
  fault:  {polygon: [[20, 0, 0], [70, 0, 60], [70, 100, 60], [20, 100, 0]]}
  ground: {box: {min: [0, 0, 0], max: [100, 100, 60]}, name: rock, attributes: {density: 2.7}}
  cover:  {box: {min: [0, 0, 60], max: [100, 100, 60.0002]}, name: dust}
  spot:   {points: [[10, 10, 59.99995]]}
  model:  {union: [bolt, fault, ground, cover, spot], dominance: left}
  joined: {simplify: {of: model, within: 0.001}}
  moved:  {simplify: {of: model, within: 0.001}, scale: 2, translate: [500, 0, 0], name: stone}
  both:   {union: [joined, moved, {simplify: joined, translate: [0, 500, 0]}]}
  tunnel: {box: {min: [30, -1, 10], max: [35, 101, 12]}}
  cut:    {difference: [joined, tunnel]}
)";

}  // namespace

TEST_CASE("a joined node is the joined result of its operand", "[joined]") {
  const Tree tree = parse(kGaps, "both");
  const Evaluation e = evaluation_of(tree, {"joined", "moved", "cut"});
  JoinReport report;
  const Result by_hand = join(alone(tree, "model"), Rational(1, 1000), &report);
  const Result joined = e.result("joined");
  CHECK(volumes(joined) == volumes(by_hand));
  CHECK(volumes(joined).count("dust") == 0);
  CHECK(e.value(tree.find("joined")).group().regions.size() == 2);  // the fault parts the rock
  for (const RegionAttributes& region : e.value(tree.find("joined")).group().regions) {
    CHECK(region.name == "rock");
    CHECK(region.properties.count("density") == 1);
  }
  // The bolt is a wire that ends in the fault, and still steel.
  const auto counts = active_counts(joined.cells());
  const auto wanted = active_counts(by_hand.cells());
  CHECK(counts[3] == wanted[3]);
  CHECK(counts[2] == wanted[2]);
  JoinReport again;
  join(joined, Rational(1, 1000), &again);
  CHECK(again.rounds == 0);
  // Placed, named anew, cut, used twice.
  CHECK(volumes(e.result("moved")) == std::map<std::string, Rational>{{"stone", 8 * sum_of(volumes(joined))}});
  CHECK(sum_of(volumes(e.result("both"))) == 10 * sum_of(volumes(joined)));
  CHECK(sum_of(volumes(joined)) - sum_of(volumes(e.result("cut"))) == 5 * 100 * 2);
  REQUIRE(e.joined.size() == 2);
  CHECK(e.joined[0].report.merged == report.merged);
  CHECK(e.joined[0].report.lost_regions == report.lost_regions);
  std::string told;
  for (const Diagnostic& d : e.diagnostics) told += d.text() + "\n";
  CHECK_THAT(told, Catch::Contains("t.yaml:10:12: notice: `joined`: joined ") &&
                       Catch::Contains("warning: `joined`: the region dust, r"));
}

TEST_CASE("a joined node in which nothing is near is its operand", "[joined]") {
  const Tree tree = parse(R"(
  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  b: {cylinder: {from: [0, 0, 3], to: [0, 0, 4], radius: 1, segments: 8}}
  w: {polyline: [[3, 0, 0], [4, 0, 0]]}
  open: {interior: {aggregate: [a, b, w]}}
  all: {aggregate: [a, b, w]}
  one: {simplify: {of: all, within: 0.01}}
  two: {simplify: {of: one, within: 0.02, mode: points}}
  inner: {simplify: {of: open, within: 0.01}}
  none: {intersection: [a, b]}
  empty: {simplify: {of: none, within: 1}}
)",
                          "one");
  const Evaluation e = evaluation_of(tree, {"all", "two", "open", "inner", "empty"});
  for (const auto& [before, after] :
       std::vector<std::pair<std::string, std::string>>{{"all", "one"}, {"all", "two"}, {"open", "inner"}}) {
    INFO(after);
    CHECK(active_counts(e.result(before).cells())[3] == active_counts(e.result(after).cells())[3]);
    CHECK(volumes(e.result(before)) == volumes(e.result(after)));
    CHECK(e.result(before).component_count() == e.result(after).component_count());
  }
  CHECK(active_counts(e.result("all").cells()) == active_counts(e.result("one").cells()));
  CHECK(active_counts(e.result("open").cells()) == active_counts(e.result("inner").cells()));
  CHECK(active_counts(e.result("empty").cells()) == std::array<std::size_t, 4>{});
}

TEST_CASE("what joined nodes refuse", "[joined]") {
  const auto fails = [](const std::string& node, const std::string& what) {
    const Tree tree = parse(
        "  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n  p: {plane: {point: [0, 0, 0], normal: "
        "[0, 0, 1]}}\n  n: {" +
            node + "}\n",
        "n");
    CHECK_THROWS_WITH(evaluate(tree), Catch::StartsWith("t.yaml:5:7: error: `n`: ") && Catch::Contains(what));
  };
  fails("simplify: {of: a, within: 1}", "the whole result is 1 long; give a smaller distance");
  fails("simplify: {of: p, within: 1}", "cut the node with a box first");
}
