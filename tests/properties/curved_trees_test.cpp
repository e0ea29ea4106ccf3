// Random trees of curved, flat and unbounded leaves: each node's identities, both classifications, and what a
// simplified value promises to its readers (csg/SEMANTICS.md#identities; CNRG_SEEDS and CNRG_FIRST_SEED as for
// cubical pairs).
#include "tests/oracles/curved_trees.h"

#include <cstdlib>
#include <string>

#include "csg/evaluate/evaluate.h"
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

// What else is evaluated cuts cells, covers them and shares surfaces with them, and changes no row.
TEST_CASE("random trees: every node alone has the counts that it has among the others", "[trees]") {
  const std::uint64_t first = from_environment("CNRG_FIRST_SEED", 0);
  const std::uint64_t count = from_environment("CNRG_SEEDS", 150);
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const std::string text = properties::random_curved_tree(seed, seed % 2 == 1);
    INFO("seed " << seed << "\n" << text);
    const Tree tree = parse_tree(text, "random.yaml");
    const std::vector<NodeRow> together = evaluate(tree).rows;
    for (const NodeRow& row : together) {
      if (row.node == tree.result) continue;
      INFO(row.name);
      EvaluateOptions alone;
      alone.result = row.node;
      const NodeRow own = evaluate(tree, alone).rows.back();
      REQUIRE(own.name == row.name);
      REQUIRE(own.cells == row.cells);
      REQUIRE(own.volume() == row.volume());
    }
  }
}

}  // namespace
}  // namespace cnrg
