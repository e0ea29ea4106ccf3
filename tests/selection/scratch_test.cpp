// Scratch arrays are zeroed when they are handed on, whatever was written before, and joined sets forgotten.
#include "kernel/selection/scratch.h"

#include "tests/catch.h"

namespace cnrg {
namespace {

TEST_CASE("a scratch array is zeroed each time", "[scratch]") {
  constexpr std::size_t n = 100000;
  for (const std::size_t step : {1u, 7u, 5000u, 90000u}) {  // most pages touched, then few
    for (int round = 0; round < 3; ++round) {
      Scratch<FaceId, std::uint32_t> a(n);
      Scratch<FaceId, std::uint32_t> b(n);
      const auto& read = a;
      std::size_t other = 0;
      for (std::size_t i = 0; i < n; ++i) other += read[FaceId(i)] != 0;
      CHECK(other == 0);
      for (std::size_t i = 0; i < n; i += step) a[FaceId(i)] = b[FaceId(n - 1 - i)] = 7;
      for (std::size_t i = 0; i < n; ++i) other += read[FaceId(i)] != (i % step == 0 ? 7u : 0u);
      CHECK(other == 0);
    }
  }
}

TEST_CASE("marked ids are listed in ascending order, each once", "[scratch]") {
  constexpr std::size_t n = 20000;
  for (const std::size_t step : {1u, 3u, 4096u, 9001u, 30000u}) {
    Marks<EdgeId> marks(n);
    std::vector<EdgeId> expected;
    for (std::size_t i = 0; i < n; i += step) expected.push_back(EdgeId(i));
    for (auto it = expected.rbegin(); it != expected.rend(); ++it) marks.set(*it, 2), marks.set(*it, 1);
    CHECK(marks.ids() == expected);
  }
  CHECK(Marks<EdgeId>(n).ids().empty());
}

TEST_CASE("sparse sets are named by their smallest member", "[scratch]") {
  for (int round = 0; round < 2; ++round) {
    SparseSets<EdgeId> sets(10);
    CHECK(sets.unite(EdgeId(7), EdgeId(9)));
    CHECK(sets.unite(EdgeId(9), EdgeId(3)));
    CHECK(!sets.unite(EdgeId(3), EdgeId(7)));
    CHECK(sets.find(EdgeId(9)) == EdgeId(3));
    CHECK(sets.find(EdgeId(0)) == EdgeId(0));
    CHECK(sets.unite(EdgeId(0), EdgeId(9)));
    CHECK(sets.find(EdgeId(7)) == EdgeId(0));
  }
}

}  // namespace
}  // namespace cnrg
