// What must not change the values of a dag: the order of its leaves, faces and points, and an exact rigid motion
// (csg/SEMANTICS.md#identities). Values are compared by their canonical forms, component by component.
#include "tests/oracles/dag_invariance.h"

#include "tests/catch.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {
namespace {

using Failure = std::string;
void run_dags(std::uint64_t usual, std::uint64_t offset, const FailureOf& failure_of) {
  const auto [first, last] = scenes::seeds(usual);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const RandomDag dag = random_dag(seed + offset, position_of(seed));
    const Failure failure = failure_of(dag);
    if (failure.empty()) {
      SUCCEED();
      continue;
    }
    const auto [least, why] = shrink(dag, failure, failure_of);
    FAIL_CHECK("seed " << seed << ": " << failure << "\nshrunk: " << why << "\n" << tree_file(least));
  }
}

}  // namespace

TEST_CASE("The order of leaves, faces and points changes no value of a dag", "[dag]") {
  run_dags(100, 3'000'000, permutation_failure);
}

TEST_CASE("An exact rigid motion moves every value of a dag", "[dag]") {
  run_dags(100, 4'000'000, motion_failure);
}

}  // namespace cnrg::properties
