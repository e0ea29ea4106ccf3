// Random scenes of all dimensions with names, materials and attributes, whose parts nearly touch: what is joined
// or snapped is held against what it was (tests/oracles/moved_result.h).

#include "tests/catch.h"
#include "tests/oracles/near_trees.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {
namespace {

template <class Failure>
void attack(std::uint64_t usual, NearTree (*make)(std::uint64_t), const Failure& failure_of) {
  const auto [first, last] = scenes::seeds(usual);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    NearTree tree = make(seed);
    std::string failure = failure_of(tree);
    if (failure.empty()) {
      SUCCEED();
      continue;
    }
    const std::string found = failure;
    for (bool progress = true; progress;) {
      progress = false;
      for (NearTree& less : smaller(tree)) {
        std::string f = failure_of(less);
        if (f.empty()) continue;
        tree = std::move(less), failure = std::move(f), progress = true;
        break;
      }
    }
    FAIL_CHECK("seed " << seed << ": " << found << "\nshrunk: " << failure << "\n" << text_of(tree, "joined"));
  }
}

}  // namespace

TEST_CASE("What is joined is what it was", "[moved]") { attack(50, near_tree, join_failure); }

TEST_CASE("What is snapped is what it was", "[moved]") { attack(40, slight_tree, snap_failure); }

}  // namespace cnrg::properties
