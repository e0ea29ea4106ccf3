// The classic contacts of mantyla1988, chapter 15: what the algorithm makes of them, exactly.
#include <catch2/catch.hpp>

#include "bench/baseline/mantyla.h"
#include "tests/baseline/oracle.h"
#include "tests/baseline/shapes.h"

namespace cnrg::bench::baseline_test {

TEST_CASE("two boxes that overlap in a corner") {
  const Model a = box({0, 0, 0}, {2, 2, 2}), b = box({1, 1, 1}, {3, 3, 3});
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract}) {
    const Model answer = mantyla::boolean_exact(a, b, operation);
    const Truth truth = truth_of(a, b, operation, answer);
    CHECK(truth.same_set);
    CHECK(volume_of(answer) == truth.volume);
    const Counts counts = counts_of(answer);
    CHECK(counts.vertices == truth.vertices);
    CHECK(counts.edges == truth.edges);
    CHECK(counts.faces == truth.faces);
  }
}

}  // namespace cnrg::bench::baseline_test
