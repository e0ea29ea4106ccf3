// The kernel against a brute-force run of the rules on cubical complexes, cell for cell
// (csg/SEMANTICS.md#the-tables).
//
// CNRG_SEEDS sets the number of pairs of each case, CNRG_FIRST_SEED where they start.
#include <algorithm>
#include <string>

#include "tests/catch.h"
#include "tests/oracles/cubical_pair.h"
#include "tests/scenes/seeds.h"

namespace {

// The first difference among the seeds, with a shrunk pair as fixtures; empty if there is none.
std::string run(std::uint64_t pairs, bool tilted, bool thorough) {
  const cubical::Grid grid(5);
  const auto [first, last] = cnrg::scenes::seeds(pairs);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    cubical::Pair pair = cubical::random_pair(grid, seed);
    if (tilted) pair.presentation.place = cubical::tilt();
    pair.presentation.thorough = thorough;
    const std::string wrong = cubical::compare_pair(grid, pair.a, pair.b, pair.presentation);
    if (wrong.empty()) continue;
    const cubical::Pair small = cubical::shrink(grid, pair);
    return "seed " + std::to_string(seed) + ": " + wrong +
           "\nshrunk: " + cubical::compare_pair(grid, small.a, small.b, small.presentation) + "\n" +
           cubical::tree_file(grid, small);
  }
  return "";
}

TEST_CASE("cubical pairs: every operator and dominance as by brute force", "[cubical]") {
  const std::string wrong = run(1600, false, false);
  INFO(wrong);
  CHECK(wrong.empty());
}

TEST_CASE("cubical pairs: identities, classification, complement, simplified counts", "[cubical]") {
  const std::string wrong = run(300, false, true);
  INFO(wrong);
  CHECK(wrong.empty());
}

TEST_CASE("cubical pairs under a rational rotation", "[cubical]") {
  const std::string wrong = run(400, true, false);
  INFO(wrong);
  CHECK(wrong.empty());
}

}  // namespace
