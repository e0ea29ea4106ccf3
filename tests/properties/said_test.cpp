// What is said of regions, sheets, wires and points (csg/SEMANTICS.md#attributes): cases of their own beside the
// family `cube-trees`.
#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/operators/node_value.h"
#include "tests/catch.h"
#include "tests/oracles/cubical_compare.h"

namespace {

TEST_CASE("random trees say something of every kind of cell, and contradict themselves", "[cubical]") {
  const cubical::Grid grid(4);
  cubical::SaidTally tally;
  for (std::uint64_t seed = 0; seed < 160; ++seed)
    CHECK(cubical::compare_by_brute_force(grid, cubical::random_said_dag(grid, seed, false), &tally) == "");
  CAPTURE(tally.nodes, tally.said_cells, tally.regions, tally.conflicts, tally.counted);
  CHECK(
      (tally.owners > 0 && tally.said_cells > 0 && tally.regions > 0 && tally.conflicts > 0 && tally.counted > 0));
}

/// What is said of the one vertex of the result that is a component of its own.
std::string name_of_point(const std::string& nodes) {
  const cnrg::Tree tree = cnrg::parse_tree("cnrg: 1\nnodes:\n" + nodes + "result: named\n", "point.yaml");
  const cnrg::Evaluation evaluation = cnrg::evaluate(tree, {});
  const cnrg::Components& x = evaluation.kept.front().value->components();
  for (std::size_t i = 0; i < x.selection.vertices.size(); ++i) {
    const cnrg::SaidPointer& said = x.origins.sets.said(x.origins.vertices[i]);
    if (x.selection.vertices[i].second != 1 && said) return said->attributes.name;
  }
  return {};
}

TEST_CASE("a point in a component stands for itself, whatever other leaves cut there") {
  const std::string point = "  point: {group: {vertices: [[2, 2, 2]], points: [0]}}\n";
  const std::string named = "  rest: {complement: ends}\n  named: {closure: rest, name: hole}\n";
  CHECK(name_of_point(point + "  ends: {union: [point, point]}\n" + named) == "hole");
  CHECK(name_of_point(point +
                      "  wire: {polyline: [[2, 2, 2], [2, 2, 3]]}\n  ends: {intersection: [wire, point]}\n" +
                      named) == "hole");
  CHECK(name_of_point(
            point +
            "  sheet: {polygon: [[2, 2, 2], [2, 2, 3], [3, 2, 2]]}\n  ends: {intersection: [sheet, point]}\n" +
            named) == "hole");
}

}  // namespace
