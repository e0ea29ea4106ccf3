// The driver: volumes, counts, dominance, sharing and attributes of small trees, with every invariant checked.
#include "csg/evaluate/evaluate.h"

#include <string>

#include "csg/operators/node_value.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

struct Run {
  Tree tree;
  Evaluation evaluation;
  const NodeRow& row(const std::string& name) const {
    for (const NodeRow& row : evaluation.rows) {
      if (row.name == name) return row;
    }
    FAIL("no row is called " << name);
    throw 0;
  }
  const KeptValue& kept(const std::string& name) const { return evaluation.value(tree.find(name)); }
};

Run run(const std::string& nodes, const std::string& result, std::vector<std::string> others = {}) {
  Run r{
      parse_tree("cnrg: 1\nmaterials: {rock: {}, ore: {}, air: {}}\nnodes:\n" + nodes + "result: " + result + "\n",
                 "t.yaml"),
      {}};
  EvaluateOptions options;
  options.validate = true;
  options.region_volumes = true;
  for (const std::string& name : others) options.nodes.push_back(r.tree.find(name));
  r.evaluation = evaluate(r.tree, options);
  return r;
}

const char* const kBoxes = R"(  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}, material: rock}
  b: {box: {min: [1, 1, 1], max: [3, 3, 3]}, material: ore}
  c: {box: {min: [2, 0, 0], max: [4, 2, 2]}, material: rock}
)";

using Cells = std::array<std::size_t, 4>;

TEST_CASE("a box is a box", "[evaluate]") {
  const Run r = run("  a: {box: {min: [0, 0, 0], max: [1/3, 2, 3]}}\n", "a");
  REQUIRE(r.evaluation.rows.size() == 1);
  const NodeRow& row = r.row("a");
  CHECK(row.operator_name == "box");
  CHECK(row.cells == Cells{8, 12, 6, 1});
  CHECK(*row.volume() == 2);
  CHECK(row.removals.empty());
  CHECK(r.kept("a").group().regions.at(0).name == "a");
  CHECK(r.evaluation.leaf_names == std::vector<std::string>{"a"});
  CHECK(r.kept("a").leaves == std::vector<LeafId>{LeafId(0)});
}

TEST_CASE("without a word the numbers of the operands decide, and the larger is passed on", "[evaluate]") {
  const Run r = run(R"(  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}}
  b: {box: {min: [1, 1, 1], max: [3, 3, 3]}, dominance: 2}
  r: {union: [a, b]}
  c: {complement: r}
  s: {union: [a, a], dominance: 1/2}
  t: {difference: [r, s]}
)",
                    "t", {"r", "c", "s"});
  CHECK(r.row("r").volumes.size() == 2);
  CHECK(r.kept("r").group().dominance == 2);
  CHECK(r.kept("c").value->components().attributes.at(0).dominance == 2);
  CHECK(r.kept("s").group().dominance == Rational(1, 2));
  CHECK(r.kept("t").group().dominance == 2);
}

TEST_CASE("a node under two transforms is two instances, each with a row", "[evaluate]") {
  const Run r = run(R"(  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  b: {simplify: a, translate: [10, 0, 0]}
  c: {simplify: a, scale: [2, -2, 2]}
  r: {union: [a, b, c, a]}
)",
                    "r");
  CHECK(*r.row("a#1").volume() == 1);
  CHECK(*r.row("a#2").volume() == 1);
  CHECK(*r.row("a#3").volume() == 8);
  CHECK(*r.row("r").volume() == 10);
  CHECK(r.evaluation.leaf_names == std::vector<std::string>{"a", "a", "a"});
}

TEST_CASE("the complement of a box is unbounded", "[evaluate]") {
  const Run r = run(
      "  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n  n: {complement: a, material: air}\n  t: {complement: n}\n",
      "t", {"n"});
  CHECK_FALSE(r.row("n").volume().has_value());
  CHECK(r.kept("n").value->attributes(1).material == "air");
  CHECK(r.kept("n").value->attributes(1).name == "n");
  CHECK(*r.row("t").volume() == 1);
}

TEST_CASE("simplify with mode points forgets features", "[evaluate]") {
  const Run r = run(R"(  l: {polyline: [[0, 0, 0], [1, 0, 0], [2, 1, 0]]}
  p: {points: [[1/2, 0, 0]]}
  u: {union: [l, p]}
  s: {simplify: u}
  c: {simplify: {of: u, mode: points}}
  k: {union: [s, c]}
)",
                    "k", {"u", "s", "c"});
  CHECK(r.row("u").cells == Cells{4, 3, 0, 0});
  CHECK(r.row("s").cells == Cells{4, 3, 0, 0});
  CHECK(r.row("c").cells == Cells{3, 2, 0, 0});
  CHECK(r.row("c").raw_cells == Cells{4, 3, 0, 0});
}

TEST_CASE("materials that meet with equal dominance are reported at the node", "[evaluate]") {
  const Run r = run(std::string(kBoxes) + "  u: {union: [a, b]}\n", "u");
  REQUIRE(r.evaluation.diagnostics.size() == 1);
  CHECK_THAT(r.evaluation.diagnostics[0].text(), Catch::StartsWith("t.yaml:7:7: warning: `u`: ") &&
                                                     Catch::Contains("`rock`") && Catch::Contains("`ore`"));
  CHECK(r.kept("u").group().regions.at(0).material == "rock");
}

TEST_CASE("removals are counted by row of the tables", "[evaluate]") {
  const Run r = run(std::string(kBoxes) + "  u: {union: [a, b]}\n", "u");
  CHECK(r.row("u").removed() > 0);
  for (const auto& [row, count] : r.row("u").removals) {
    CHECK_THAT(table_rows()[row].id, Catch::StartsWith("union."));
    CHECK(count > 0);
  }
}

TEST_CASE("a chain of 10,000 nodes evaluates", "[evaluate]") {
  std::string nodes = "  n0: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n";
  for (int i = 1; i <= 10000; ++i) {
    nodes += "  n" + std::to_string(i) + ": {complement: n" + std::to_string(i - 1) + "}\n";
  }
  const Run r = run(nodes, "n10000");
  CHECK(*r.row("n10000").volume() == 1);
  CHECK(r.row("n10000").cells == Cells{8, 12, 6, 1});
}

TEST_CASE("only the nodes that somebody asks for are measured", "[evaluate]") {
  const Tree tree =
      parse_tree("cnrg: 1\nnodes:\n" + std::string("  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n") +
                     "  r: {regularize: a}\nresult: r\n",
                 "t.yaml");
  EvaluateOptions options;
  options.rows = Rows::kept;
  options.validate = true;
  std::vector<std::string> stages;
  options.watch.progress = [&](std::string_view stage, std::size_t, std::size_t) {
    if (stages.empty() || stages.back() != stage) stages.emplace_back(stage);
  };
  const Evaluation e = evaluate(tree, options);
  REQUIRE(e.rows.size() == 2);
  CHECK(e.rows[0].cells == Cells{0, 0, 0, 0});
  CHECK(e.rows[1].cells == Cells{8, 12, 6, 1});
  CHECK(stages == std::vector<std::string>{"leaves", "refine", "refine: input", "refine: contacts",
                                           "refine: crossings", "refine: faces", "refine: cells",
                                           "refine: regions", "nodes"});
  options.rows = Rows::none;
  const Evaluation none = evaluate(tree, options);
  CHECK(none.rows[1].cells == Cells{0, 0, 0, 0});
  CHECK_FALSE(none.rows[1].volume().has_value());
  CHECK(none.kept[0].simplified.counts().simplified == e.rows[1].cells);
  CHECK(none.kept[0].simplified.counts().raw == e.rows[1].raw_cells);
  CHECK(active_counts(*none.kept[0].simplified) == e.rows[1].cells);
}

TEST_CASE("raw keeps the cells of the refinement", "[evaluate]") {
  const Tree tree = parse_tree(
      std::string("cnrg: 1\nmaterials: {rock: {}, ore: {}}\nnodes:\n") + kBoxes +
          "  d: {difference: [{union: [a, b]}, b]}\n  r: {union: [a, d]}\n  x: {union: [r, c]}\nresult: r\n",
      "t.yaml");
  EvaluateOptions options;
  options.raw = true;
  options.validate = true;
  const Evaluation e = evaluate(tree, options);
  const NodeRow& row = e.rows.back();
  CHECK(row.cells == Cells{8, 12, 6, 1});
  CHECK(row.raw_cells[2] > 6);
  CHECK(active_counts(*e.kept[0].simplified) == row.raw_cells);
}

}  // namespace
}  // namespace cnrg
