// Random soups of mixed dimension on tiny grids against Nef polyhedra.

#include "tests/catch.h"
#include "tests/oracles/soup_nef.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {
namespace {

using scenes::Leaf;

/// Soups on which Nef itself failed.
std::uint64_t soup_oracle_failures = 0;

std::string soup_failure(const std::vector<Leaf>& leaves) try {
  return compare_soup_with_nef(leaves);
} catch (const OracleFailure&) {
  ++soup_oracle_failures;
  return {};
} catch (const std::exception& error) {
  return std::string("thrown: ") + error.what();
}

/// Drops parts while it still fails.
std::vector<Leaf> shrink_soup(std::vector<Leaf> leaves) {
  const auto try_without = [&](auto&& part_of) {
    for (std::size_t l = 0; l < leaves.size(); ++l)
      for (std::size_t i = part_of(leaves[l]).size(); i > 0; --i) {
        std::vector<Leaf> less = leaves;
        auto& list = part_of(less[l]);
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(i - 1));
        if (!soup_failure(less).empty()) leaves = std::move(less);
      }
  };
  for (int round = 0; round < 2; ++round) {
    try_without([](Leaf & leaf) -> auto& { return leaf.faces; });
    try_without([](Leaf & leaf) -> auto& { return leaf.wires; });
    try_without([](Leaf & leaf) -> auto& { return leaf.points; });
  }
  return leaves;
}

void run_soups(int parts, int size, std::uint64_t usual) {
  const auto [first, last] = scenes::seeds(usual);
  soup_oracle_failures = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const std::vector<Leaf> leaves = random_soup(seed, parts, size);
    const std::string failure = soup_failure(leaves);
    if (failure.empty()) {
      SUCCEED();
      continue;
    }
    scenes::Scene least{shrink_soup(leaves), scenes::leaf_expression(0)};
    FAIL_CHECK("seed " << seed << ": " << failure << "\nshrunk: " << soup_failure(least.leaves) << "\n"
                       << scenes::tree_file(least));
  }
  INFO(soup_oracle_failures << " soups on which Nef itself failed");
  CHECK(soup_oracle_failures <= 1 + (last - first) / 100);
}

}  // namespace

TEST_CASE("A few parts on a tiny grid", "[soups]") { run_soups(6, 2, 60); }
TEST_CASE("Parts on a small grid", "[soups]") { run_soups(10, 3, 40); }
TEST_CASE("Many parts on a grid", "[soups]") { run_soups(16, 6, 8); }

}  // namespace cnrg::properties
