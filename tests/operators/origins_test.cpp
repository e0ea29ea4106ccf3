// Sets of leaves that grow step by step, against sets that are listed at each step.
#include "csg/operators/origins.h"

#include <random>

#include "tests/catch.h"

namespace cnrg {
namespace {

std::vector<LeafId> list(std::span<const LeafId> leaves) { return {leaves.begin(), leaves.end()}; }

TEST_CASE("unions of sets of leaves are those of their lists", "[origins][random]") {
  std::mt19937 random(1);
  for (int scene = 0; scene < 20; ++scene) {
    LeafSets sets;
    LeafUnions unions;
    std::vector<LeafSetId> listed{LeafSetId(0)}, kept{LeafSetId(0)};
    for (int i = 0; i < 60; ++i) {
      if (random() % 3 == 0) {
        const LeafId leaf(random() % 8);
        listed.push_back(sets.intern(leaf));
        kept.push_back(unions.intern(std::span(&leaf, 1)));
      } else {
        const std::size_t a = random() % listed.size(), b = random() % listed.size();
        listed.push_back(sets.unite(listed[a], listed[b]));
        kept.push_back(unions.unite(kept[a], kept[b]));
      }
      REQUIRE(unions[kept.back()] == list(sets[listed.back()]));
    }
  }
}

TEST_CASE("a set that takes in n leaves, one by one, is kept in n steps", "[origins][growth]") {
  LeafUnions unions;
  LeafSetId all(0);
  constexpr std::size_t kLeaves = 10'000;
  for (std::size_t i = 0; i < kLeaves; ++i) {
    const LeafId leaf(i);
    const LeafSetId own = unions.intern(std::span(&leaf, 1));
    all = unions.unite(all, own);
    CHECK(unions.unite(all, own) == all);  // again the same: nothing new
  }
  CHECK(unions.size() <= 2 * kLeaves + 1);
  CHECK(unions[all].size() == kLeaves);
}

}  // namespace
}  // namespace cnrg
