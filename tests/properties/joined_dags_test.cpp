// Random dags with joined nodes: what each is of its operand, and what the nodes above make of it.
#include "tests/oracles/joined_dags.h"

#include "tests/catch.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {

TEST_CASE("Joined nodes of random dags", "[dag][moved]") {
  const auto [first, last] = scenes::seeds(60);
  std::size_t joined = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const RandomDag dag = joined_dag(seed + 7'000'000);
    joined += joined_nodes(dag) > 0;
    const std::string failure = joined_failure(dag);
    if (failure.empty()) continue;
    const auto [least, why] = shrink(dag, failure, joined_failure);
    FAIL_CHECK("seed " << seed << ": " << failure << "\nshrunk: " << why << "\n" << tree_file(least));
  }
  if (last - first >= 50) CHECK(joined * 10 > last - first);
}

}  // namespace cnrg::properties
