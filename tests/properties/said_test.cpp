// What is said of regions, sheets, wires and points, through every operator, against brute force on cubical groups
// (csg/SEMANTICS.md#attributes).
//
// CNRG_SEEDS sets the number of trees of each case, CNRG_FIRST_SEED where they start; `tests/campaign/run --family
// said-trees` goes on for hours.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>

#include "tests/oracles/cubical_said.h"

namespace {

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

std::string failure_of(const cubical::Grid& grid, const cubical::CubicalDag& dag, cubical::SaidTally* tally) {
  try {
    return cubical::compare_said(grid, dag, tally);
  } catch (const std::exception& error) {
    return std::string("thrown: ") + error.what();
  }
}

/// The first difference among the seeds, with a tree made smaller; empty if there is none.
std::string run(std::uint64_t trees, bool moved, cubical::SaidTally& tally) {
  const cubical::Grid grid(4);
  const std::uint64_t first = from_environment("CNRG_FIRST_SEED", 0);
  const std::uint64_t count = from_environment("CNRG_SEEDS", trees);
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    cubical::CubicalDag least = cubical::random_said_dag(grid, seed, moved);
    std::string wrong = failure_of(grid, least, &tally);
    if (wrong.empty()) continue;
    std::string told = "seed " + std::to_string(seed) + ": " + wrong;
    for (bool progress = true; progress;) {
      progress = false;
      for (cubical::CubicalDag& less : cubical::smaller(grid, least)) {
        const std::string still = failure_of(grid, less, nullptr);
        if (still.empty() || (still.rfind("thrown", 0) == 0) != (wrong.rfind("thrown", 0) == 0)) continue;
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
  const std::string wrong = run(300, false, tally);
  INFO(wrong);
  CHECK(wrong.empty());
  CAPTURE(tally.nodes, tally.said_cells, tally.regions, tally.conflicts, tally.counted);
  CHECK((tally.said_cells > 0 && tally.regions > 0 && tally.conflicts > 0 && tally.counted > 0));
}

TEST_CASE("what is said of each cell, as by brute force, turned, sheared, reflected", "[cubical]") {
  cubical::SaidTally tally;
  const std::string wrong = run(60, true, tally);
  INFO(wrong);
  CHECK(wrong.empty());
}

}  // namespace
