// The operator `select` in trees: leaves that are told by nodes, however they are placed and used, points by
// further operands, and what the program can list counts what the operator picks.
#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/topology/selectables.h"
#include "csg/tree/selector.h"
#include "tests/catch.h"
#include "tests/scenes/scene.h"

namespace cnrg {
namespace {

Evaluation evaluated_nodes(const Tree& tree, const std::vector<std::string>& nodes, bool raw = false) {
  EvaluateOptions options;
  options.raw = raw;
  options.validate = true;
  for (const std::string& node : nodes) options.nodes.push_back(tree.find(node));
  return evaluate(tree, options);
}

/// Vertices, edges, faces, 3-cells, as files have them, and regions.
using Counts = std::array<std::size_t, 5>;
Counts counts_of(const Evaluation& evaluation, const std::string& node) {
  const auto row = std::find_if(evaluation.rows.begin(), evaluation.rows.end(),
                                [&](const NodeRow& r) { return r.name == node; });
  REQUIRE(row != evaluation.rows.end());
  return {row->cells[0], row->cells[1], row->cells[2], row->cells[3], row->regions};
}

constexpr const char* kBolts = R"(cnrg: 1
nodes:
  rock:   {box: {min: [0, 0, 0], max: [9, 9, 9]}}
  bolt:   {polyline: [[1, 1, 5], [1, 1, 12]], attributes: {diameter: 25}}
  second: {union: [bolt, {points: [[1, 1, 13]]}], translate: [2, 0, 0]}
  third:  {aggregate: [{simplify: bolt, translate: [4, 0, 0], attributes: {diameter: 30}}]}
  bolts:  {union: [bolt, second, third]}
  model:  {union: [rock, bolts], dominance: right}
  all:    {select: {of: model, from: bolt}}
  one:    {select: {of: model, from: second, dimension: 1}}
  two:    {select: {of: model, from: [second, third], dimension: 1}}
  moved:  {select: {of: model, from: second, dimension: 1}, translate: [0, 0, 1]}
  thick:  {select: {of: model, attributes: {diameter: [30, 31]}}}
  deep:   {select: {of: model, from: bolt, inside: rock}}
  loose:  {select: {of: model, dimension: 1, touching: {points: [[3, 1, 12]]}}}
  again:  {union: [rock, loose], dominance: right}
  first:  {select: {of: {box: {min: [0, 0, 0], max: [1, 1, 1]}}, region: 1}}
  none:   {select: {of: rock, region: "1"}}
result: model
)";

TEST_CASE("leaves are asked for by nodes, in all places where these are used", "[select]") {
  const Tree tree = parse_tree(kBolts, "t.yaml");
  const Evaluation e =
      evaluated_nodes(tree, {"all", "one", "two", "moved", "thick", "deep", "loose", "again", "first", "none"});
  CHECK(counts_of(e, "all") == Counts{6, 3, 0, 0, 0});
  CHECK(counts_of(e, "one") == Counts{2, 1, 0, 0, 0});
  CHECK(counts_of(e, "two") == Counts{4, 2, 0, 0, 0});
  CHECK(counts_of(e, "moved") == Counts{2, 1, 0, 0, 0});
  CHECK(counts_of(e, "thick") == Counts{2, 1, 0, 0, 0});
  CHECK(counts_of(e, "deep") == Counts{6, 3, 0, 0, 0});   // from z = 5 to 9
  CHECK(counts_of(e, "loose") == Counts{2, 1, 0, 0, 0});  // from z = 9 to 12
  CHECK(counts_of(e, "again") == Counts{8 + 2, 12 + 1, 6, 1, 1});
  CHECK(counts_of(e, "first") == Counts{8, 12, 6, 1, 1});
  CHECK(counts_of(e, "none") == Counts{0, 0, 0, 0, 0});
  REQUIRE(e.diagnostics.size() == 1);
  CHECK(e.diagnostics[0].text() ==
        "t.yaml:18:12: warning: `none` picks nothing of `rock`; `cnrg eval --list --node rock` lists what can be "
        "picked");
}

TEST_CASE("a selection may be added to a tree that was read", "[select]") {
  Tree tree = parse_tree(kBolts, "t.yaml");
  const NodeId one = add_selection(tree, tree.find("model"), "{from: second, dimension: 1}", "words");
  const NodeId near =
      add_selection(tree, tree.find("model"), "{dimension: 1, touching: {points: [[3, 1, 12]]}}", "words");
  CHECK(tree.nodes[one].name == "model/select");
  tree.result = one;
  CHECK(counts_of(evaluated_nodes(tree, {}), "model/select") == Counts{2, 1, 0, 0, 0});
  tree.result = near;
  CHECK(counts_of(evaluated_nodes(tree, {}), "model/select") == Counts{2, 1, 0, 0, 0});
  CHECK_THROWS_WITH(add_selection(tree, one, "{dimension: 5}", "words"), Catch::StartsWith("words:1:13: error: "));
  CHECK_THROWS_WITH(add_selection(tree, one, "{of: rock}", "words"), Catch::Contains("unknown key `of`"));
  CHECK_THROWS_WITH(add_selection(tree, one, "{from: one}", "words"),
                    Catch::Contains("nothing of `model/select`"));
}

/// The criterion as a tree says it.
std::string selector_text(const Selectable& s) { return "{" + s.key + ": " + s.value + ", dimension: "; }

// On the cells of the refinement: simplification would unite faces where the edge between them goes with others.
// Edges and vertices come along with faces, so these are not compared.
TEST_CASE("what is listed is what can be picked", "[select][random]") {
  for (int seed = 1; seed <= 12; ++seed) {
    scenes::Random random(static_cast<std::uint64_t>(seed));
    std::string text = "cnrg: 1\nmaterials: {rock: {}, clay: {}}\nnodes:\n";
    std::string list;
    for (int i = 0; i < 4; ++i) {
      std::string corners[2];
      for (int axis = 0; axis < 3; ++axis) {
        const int low = static_cast<int>(random.below(4)), high = low + 1 + static_cast<int>(random.below(4));
        corners[0] += (axis ? ", " : "") + std::to_string(low);
        corners[1] += (axis ? ", " : "") + std::to_string(high);
      }
      const std::string name = "b" + std::to_string(i);
      text += "  " + name + ": {box: {min: [" + corners[0] + "], max: [" + corners[1] +
              "]}, material: " + (random.below(2) ? "rock" : "clay") +
              ", attributes: {n: " + std::to_string(random.below(3)) + "}}\n";
      list += (i ? ", " : "") + name;
    }
    text += "  model: {union: [" + list + "], dominance: right}\nresult: model\n";
    Tree tree = parse_tree(text, "t.yaml");
    const NodeId model = tree.result;
    const std::vector<Selectable> listed = selectables(evaluated_nodes(tree, {}, true).result(model));
    REQUIRE(listed.size() > 8);
    for (const Selectable& s : listed) {
      if (s.key == "dimension") continue;
      for (const int dimension : {2, 3}) {
        tree.result = add_selection(tree, model, selector_text(s) + std::to_string(dimension) + "}", "words");
        const Evaluation e = evaluated_nodes(tree, {}, true);
        const NodeRow& picked = e.rows.back();
        CAPTURE(seed, s.key, s.value, dimension);
        if (dimension == 3) CHECK(picked.raw_cells[3] == s.cells[3]);
        else CHECK(picked.raw_cells[2] == s.cells[2]);
      }
    }
  }
}

}  // namespace
}  // namespace cnrg
