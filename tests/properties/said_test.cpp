// What is said of regions, sheets, wires and points, through every operator, against brute force on cubical groups
// (csg/SEMANTICS.md#attributes).
//
// CNRG_SEEDS sets the number of trees of each case, CNRG_FIRST_SEED where they start; `tests/campaign/run --family
// said-trees` goes on for hours.
#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/operators/node_value.h"
#include "tests/catch.h"
#include "tests/oracles/cubical_said.h"
#include "tests/scenes/seeds.h"

namespace {

std::string failure_of(const cubical::Grid& grid, const cubical::CubicalDag& dag, cubical::SaidTally* tally) {
  try {
    return cubical::compare_said(grid, dag, tally);
  } catch (const std::exception& error) {
    return std::string("thrown: ") + error.what();
  }
}

/// What kind of difference it is.
std::size_t kind(const std::string& wrong) {
  constexpr const char* kKinds[] = {"thrown",           "simplified counts", "is said", "region at",
                                    "the component at", "warnings",          " says "};
  for (std::size_t k = 0; k < std::size(kKinds); ++k)
    if (wrong.find(kKinds[k]) != std::string::npos) return k;
  return std::size(kKinds);
}

/// The first difference among the seeds, with a tree made smaller; empty if there is none.
std::string run_said(std::uint64_t trees, bool moved, cubical::SaidTally& tally) {
  const cubical::Grid grid(4);
  const auto [first, last] = cnrg::scenes::seeds(trees);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    cubical::CubicalDag least = cubical::random_said_dag(grid, seed, moved);
    std::string wrong = failure_of(grid, least, &tally);
    if (wrong.empty()) continue;
    std::string told = "seed " + std::to_string(seed) + ": " + wrong;
    for (bool progress = true; progress;) {
      progress = false;
      for (cubical::CubicalDag& less : cubical::smaller(grid, least)) {
        const std::string still = failure_of(grid, less, nullptr);
        if (still.empty() || kind(still) != kind(wrong)) continue;
        least = std::move(less);
        wrong = still;
        progress = true;
        break;
      }
    }
    return told + "\nshrunk: " + wrong + "\n" + cubical::tree_file(least);
  }
  return "";
}

TEST_CASE("what is said of each cell, as by brute force", "[cubical]") {
  cubical::SaidTally tally;
  const std::string wrong = run_said(300, false, tally);
  INFO(wrong);
  CHECK(wrong.empty());
  CAPTURE(tally.nodes, tally.said_cells, tally.regions, tally.conflicts, tally.counted);
  CHECK(
      (tally.owners > 0 && tally.said_cells > 0 && tally.regions > 0 && tally.conflicts > 0 && tally.counted > 0));
}

TEST_CASE("what is said of each cell, as by brute force, turned, sheared, reflected", "[cubical]") {
  cubical::SaidTally tally;
  const std::string wrong = run_said(60, true, tally);
  INFO(wrong);
  CHECK(wrong.empty());
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
