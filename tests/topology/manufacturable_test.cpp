// Can a value be made: what stands in the way, by name and place; and, on random groups, what has no thickness is
// what `regularize` takes away.
#include "csg/topology/manufacturable.h"

#include "csg/evaluate/evaluate.h"
#include "csg/operators/boolean.h"
#include "csg/topology/topology.h"
#include "tests/catch.h"
#include "tests/scenes/scene.h"
#include "tests/scenes/seeds.h"

using namespace cnrg;

namespace {

/// The end of the topology of the node `result`.
std::string verdict_on(const std::string& nodes) {
  const Tree tree = parse_tree("cnrg: 1\nnodes:\n" + nodes + "result: result\n", "t.yaml");
  const std::string text = topology_report(evaluate(tree, {}).result(tree.result)).text;
  const std::size_t at = text.find("manufacturable: ");
  REQUIRE(at != std::string::npos);
  return text.substr(at);
}

TEST_CASE("parts side by side can be made, whatever walls they share", "[manufacturable]") {
  CHECK(verdict_on("  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}}\n"
                   "  b: {box: {min: [1, 1, 1], max: [3, 3, 3]}}\n"
                   "  result: {union: [a, b], dominance: left}\n") == "manufacturable: yes, 2 solids\n");
  // Open sets are judged by their closure.
  CHECK(verdict_on("  result: {interior: {box: {min: [0, 0, 0], max: [2, 2, 2]}}}\n") ==
        "manufacturable: yes, 1 solid\n");
  // Two parts may touch along an edge; a wire on a wall is on the wall.
  CHECK(verdict_on("  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n"
                   "  b: {box: {min: [1, 1, 0], max: [2, 2, 1]}}\n"
                   "  c: {polyline: [[0, 0, 0], [1, 1, 0]]}\n"
                   "  result: {union: [c, a, b], dominance: left}\n") == "manufacturable: yes, 2 solids\n");
}

TEST_CASE("what has no thickness is in the way, inside and outside", "[manufacturable]") {
  CHECK(verdict_on("  box: {box: {min: [0, 0, 0], max: [4, 4, 4]}}\n"
                   "  crack: {polygon: [[1, 1, 1], [3, 1, 1], [3, 3, 1], [1, 3, 1]]}\n"
                   "  fin: {polygon: [[4, 1, 1], [6, 1, 1], [6, 3, 1], [4, 3, 1]]}\n"
                   "  bolt: {polyline: [[2, 2, 2], [2, 2, 3]]}\n"
                   "  dot: {points: [[9, 9, 9]]}\n"
                   "  result: {union: [crack, fin, bolt, dot, box], dominance: left}\n") ==
        "manufacturable: no\n"
        "  faces without thickness: f5, f7\n"  // the crack and the fin
        "  wires: e11\n"
        "  loose points: v18\n");
  CHECK(verdict_on("  result: {polyline: [[0, 0, 0], [1, 0, 0]]}\n") ==
        "manufacturable: no\n  there is no solid\n  wires: e0\n");
}

TEST_CASE("a component that touches itself is no 2-manifold, also where others fill the rest",
          "[manufacturable]") {
  const std::string boxes =
      "  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n"
      "  b: {box: {min: [1, 1, 0], max: [2, 2, 1]}}\n"
      "  c: {box: {min: [1, 0, 0], max: [2, 1, 1]}}\n"
      "  d: {box: {min: [0, 1, 0], max: [1, 2, 1]}}\n"
      "  one: {unify: {union: [a, b]}}\n"
      "  two: {subtract: [{unify: {union: [c, d]}}, one]}\n";
  const std::string alone = verdict_on(boxes + "  result: {simplify: one}\n");
  CHECK(alone.find("manufacturable: no\n  1 one, 4 boundary faces meet: 2 solid sectors: e") == 0);
  // The block is full there; the first and the second component meet around its middle line by turns.
  const std::string block = verdict_on(boxes + "  result: {aggregate: [one, two]}\n");
  CHECK(block.find("manufacturable: no\n  1 one, 4 boundary faces meet: 2 solid sectors: e") == 0);
  CHECK(block.find("  2 two, 4 boundary faces meet: 2 solid sectors: e") != std::string::npos);
  // In a vertex alone.
  CHECK(verdict_on("  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n"
                   "  b: {box: {min: [1, 1, 1], max: [2, 2, 2]}}\n"
                   "  result: {unify: {union: [a, b]}}\n") ==
        "manufacturable: no\n  1 result, 2 solid cones touch: v7\n");
}

TEST_CASE("what is unbounded is not made", "[manufacturable]") {
  CHECK(verdict_on("  a: {halfspace: {point: [0, 0, 1], normal: [0, 0, 1]}}\n"
                   "  b: {box: {min: [0, 0, 0], max: [1, 1, 2]}}\n"
                   "  result: {union: [a, b], dominance: left}\n") == "manufacturable: no\n  1 a is unbounded\n");
}

TEST_CASE("what is in the way for its thickness is what regularization takes", "[manufacturable]") {
  const auto [begin, end] = scenes::seeds(60);
  std::size_t thin = 0, regular = 0;
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    const auto drawn = scenes::random_leaves(seed + 500, 2, scenes::Position::degenerate);
    const auto complex = build_complex(scenes::make_soup(drawn), {.threads = 1});
    const std::vector<Group> leaves = leaf_groups(*complex);
    Neighbourhoods neighbourhoods(*complex);
    for (const BooleanOp op : {BooleanOp::unite, BooleanOp::intersect, BooleanOp::subtract}) {
      const Group group = boolean_operation(*complex, op, Dominance::left, leaves[0], leaves[1]).group;
      const Group kept = regularize(*complex, group);
      const Selection selection = selection_of(*complex, group);
      const Manufacturability m =
          manufacturability(*complex, selection, simplify(*complex, selection, group.features), neighbourhoods);
      const bool same = kept.faces == group.faces && kept.edges == group.edges && kept.vertices == group.vertices;
      CAPTURE(seed, name(op));
      CHECK((m.dangling_faces.empty() && m.wires.empty() && m.loose_points.empty()) == same);
      ++(same ? regular : thin);
    }
  }
  CHECK((end - begin < 60 || (thin > 10 && regular > 10)));
}

}  // namespace
