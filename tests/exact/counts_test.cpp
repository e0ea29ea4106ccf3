// Counts at their limits and beyond them.
#include "kernel/base/counts.h"

#include "kernel/base/ids.h"
#include "kernel/base/union_find.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;

constexpr std::uint64_t kIds = 2147483647, kPlaces = 4294967295;

TEST_CASE("more things than ids can tell apart are an error with the count", "[counts]") {
  CHECK(kMostIds == kIds);
  CHECK(kMostPlaces == kPlaces);
  CHECK_NOTHROW(check_count(kIds, "edges"));
  CHECK_THROWS_AS(check_count(kIds + 1, "edges"), InputError);
  CHECK_THROWS_WITH(check_count(kIds + 1, "edges"),
                    "the model has 2147483648 edges, and at most 2147483647 can be numbered: use fewer or coarser "
                    "leaves, or evaluate its parts one by one");
  CHECK(place32(kPlaces, "corners") == kPlaces);
  CHECK_THROWS_WITH(place32(kPlaces + 1, "corners"), Contains("4294967296 corners, and at most 4294967295 "));
  CHECK(next_number(kPlaces - 1, "points") == kPlaces - 1);
  CHECK_THROWS_WITH(next_number(kPlaces, "points"), Contains("4294967296 points, and at most 4294967295 "));
}

TEST_CASE("the last edge and the last face have two sides, none of which is `none`", "[counts]") {
  const EdgeId edge(kMostIds - 1);
  const FaceId face(kMostIds - 1);
  for (const unsigned side : {0u, 1u}) {
    CHECK(HalfEdge(edge, side).edge() == edge);
    CHECK(HalfEdge(edge, side) != HalfEdge());
    CHECK(HalfFace(face, side).face() == face);
    CHECK(HalfFace(face, side) != HalfFace());
  }
}

TEST_CASE("sizes add up to where lists end, or to an error", "[counts]") {
  std::vector<std::uint32_t> ends{0, 3, 0, 2147483648, 2147483644};
  sum_up(ends, "corners");
  CHECK(ends == std::vector<std::uint32_t>{0, 3, 3, 2147483651, 4294967295});
  // The sum is 1 in 32 bits.
  std::vector<std::uint32_t> more{0, 4294967295, 2};
  CHECK_THROWS_WITH(sum_up(more, "corners"), Contains("4294967297 corners, and at most 4294967295 "));
}

TEST_CASE("containers refuse what their ids cannot name, before they take memory", "[counts]") {
  IdVector<EdgeId, std::uint64_t> edges;
  const auto too_many = Contains("2147483648 edges, and at most 2147483647 ");
  CHECK_THROWS_WITH(edges.resize(kMostIds + 1), too_many);
  CHECK_THROWS_WITH(edges.assign(kMostIds + 1, 0), too_many);
  CHECK_THROWS_WITH((IdVector<EdgeId, std::uint64_t>(kMostIds + 1)), too_many);
  CHECK(edges.empty());
  using Lists = Csr<FaceId, VertexId>;
  const auto too_many_lists = Contains("2147483648 faces, and at most 2147483647 ");
  CHECK_THROWS_WITH(Lists::counted(kMostIds + 1, [](const auto&) {}), too_many_lists);
  CHECK_THROWS_WITH(UnionFind(kMostPlaces + 1), Contains("4294967296 things to join, and at most 4294967295 "));
}

// Two gigabytes.
TEST_CASE("one more id than there are is an error, not the number of another thing", "[counts][.limits]") {
  IdVector<EdgeId, char> edges(kMostIds - 1);
  CHECK(edges.push_back(1) == EdgeId(kMostIds - 1));
  CHECK_THROWS_WITH(edges.push_back(1), Contains("2147483648 edges, and at most 2147483647 "));
  CHECK(edges.size() == kMostIds);
}

// Half a gigabyte: a value is a bit.
TEST_CASE("one more entry of lists than there are places is an error", "[counts][.limits]") {
  using Bits = Csr<FaceId, bool>;
  const auto too_many = Contains("4294967296 entries of lists, and at most 4294967295 ");
  CHECK_THROWS_WITH(Bits::from_parts({0, 0}, std::vector<bool>(kMostPlaces + 1)), too_many);
  Bits lists;
  CHECK(lists.push_back(std::vector<bool>(kMostPlaces)) == FaceId(0));
  CHECK_THROWS_WITH(lists.push_back(std::vector<bool>(1)), too_many);
}

}  // namespace
}  // namespace cnrg
