// Random trees of curved, flat and unbounded leaves: each node's identities, both classifications, and what a
// simplified value promises to its readers (csg/SEMANTICS.md#identities; CNRG_SEEDS and CNRG_FIRST_SEED as for
// cubical pairs).
#include "tests/oracles/curved_trees.h"

#include <cstdlib>
#include <string>

#include "csg/carriers/common_lines.h"
#include "csg/evaluate/evaluate.h"
#include "csg/evaluate/prepared_leaves.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

std::uint64_t from_environment(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

void check_random_trees(std::uint64_t count, bool swept) {
  const std::uint64_t first = from_environment("CNRG_FIRST_SEED", 0);
  count = from_environment("CNRG_SEEDS", count);
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const std::string text = properties::random_curved_tree(seed, swept);
    INFO("seed " << seed << "\n" << text);
    REQUIRE(properties::check_curved_tree(text) == "");
  }
}

TEST_CASE("random trees of curved and unbounded leaves satisfy every identity", "[trees]") {
  check_random_trees(400, false);
}

TEST_CASE("random trees with sweeps and patches satisfy every identity", "[trees]") {
  check_random_trees(150, true);
}

/// True if leaves of the result have common lines, which they have not where each is alone.
bool shares_lines(const Tree& tree) {
  const Unfolding unfolding = unfold(tree, {tree.result});
  const std::vector<LeafInstance> own = PreparedLeaves(tree, unfolding).instances();
  const std::vector<LeafInstance> common = with_common_lines(own);
  return !std::equal(own.begin(), own.end(), common.begin(),
                     [](const LeafInstance& a, const LeafInstance& b) { return a.leaf == b.leaf; });
}

// What else is evaluated cuts cells and covers them, and changes no count of the simplified result.
TEST_CASE("random trees: every node alone has the counts that it has among the others", "[trees]") {
  const std::uint64_t first = from_environment("CNRG_FIRST_SEED", 0);
  const std::uint64_t count = from_environment("CNRG_SEEDS", 150);
  std::uint64_t compared = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const std::string text = properties::random_curved_tree(seed, seed % 2 == 1);
    INFO("seed " << seed << "\n" << text);
    const Tree tree = parse_tree(text, "random.yaml");
    if (shares_lines(tree)) continue;
    ++compared;
    const std::vector<NodeRow> together = evaluate(tree).rows;
    for (const NodeRow& row : together) {
      if (row.node == tree.result) continue;
      INFO(row.name);
      Tree alone = parse_tree(text, "random.yaml");
      alone.result = row.node;
      const NodeRow own = evaluate(alone).rows.back();
      REQUIRE(own.name == row.name);
      REQUIRE(own.cells == row.cells);
      REQUIRE(own.volume() == row.volume());
    }
  }
  REQUIRE(compared > count / 2);
}

}  // namespace
}  // namespace cnrg
