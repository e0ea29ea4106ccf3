// Facets of closed surfaces laid out in parameters: where a seam is needed and where not, without any geometry.
#include "csg/exports/unrolled.h"

#include <cmath>
#include <set>

#include "tests/catch.h"

namespace cnrg {
namespace {

/// A grid of facets on a surface that closes after `columns` (and, if it is a torus, after `rows`): parameters are
/// whole numbers, and begin anew at 0.
struct Grid {
  int columns = 6, rows = 4;
  bool torus = false;
  std::set<std::array<int, 2>> without;  // facets that are not there
  int poles = 0;                         // 1: the last row is a point; 2: the first one, too

  std::uint32_t point(int i, int j) const {
    i %= columns;
    if (torus) j %= rows;
    if (is_pole(j)) i = 0;
    return static_cast<std::uint32_t>(100 * j + i);
  }
  bool is_pole(int j) const { return (poles > 0 && j == rows) || (poles > 1 && j == 0); }

  std::optional<Unrolled> unroll() const {
    std::vector<UnrollFacet> facets;
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < rows; ++j) {
        if (without.count({i, j}) != 0) continue;
        std::vector<UnrollCorner> loop;
        for (const auto& [a, b] :
             {std::pair(i, j), std::pair(i + 1, j), std::pair(i + 1, j + 1), std::pair(i, j + 1)}) {
          const std::uint32_t p = point(a, b);
          if (!loop.empty() && (loop.back().point == p || loop.front().point == p)) continue;
          // As an arc tangent has it: between -columns / 2 and columns / 2.
          const double u = a % columns > columns / 2 ? a % columns - columns : a % columns;
          loop.push_back(
              {p, {is_pole(b) ? 17.0 : u, static_cast<double>(torus ? b % rows : b)}, {is_pole(b), false}});
        }
        facets.push_back({loop});
      }
    }
    return cnrg::unroll(facets, {static_cast<double>(columns), torus ? static_cast<double>(rows) : 0.0},
                        {1e-6, 1e-6});
  }
};

/// Steps that a loop makes, and where it ends against its begin: 0 for a closed one.
void check_closed(const Unrolled& unrolled) {
  for (const auto& loop : unrolled.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto &to = loop[i].to, &from = loop[(i + 1) % loop.size()].from;
      CHECK(to.point == from.point);
      if (to.free[0]) continue;
      CHECK(to.at == from.at);
    }
  }
}

TEST_CASE("a part of a cylinder needs no seam, wherever its parameters begin", "[unroll]") {
  Grid grid;
  grid.without = {{3, 0}, {3, 1}, {3, 2}, {3, 3}};
  const auto unrolled = grid.unroll();
  REQUIRE(unrolled);
  CHECK(unrolled->seams.empty());
  CHECK(unrolled->loops.size() == 1);
  CHECK(unrolled->loops[0].size() == 18);
  CHECK(unrolled->area == Approx(20));
  check_closed(*unrolled);
}

TEST_CASE("a whole cylinder is cut once, from rim to rim", "[unroll]") {
  const auto unrolled = Grid().unroll();
  REQUIRE(unrolled);
  CHECK(unrolled->seams.size() == 4);
  CHECK(unrolled->loops.size() == 1);
  CHECK(unrolled->loops[0].size() == 20);
  CHECK(unrolled->area == Approx(24));
  check_closed(*unrolled);
}

TEST_CASE("a hole on the line where parameters begin parts the seam", "[unroll]") {
  Grid grid;
  grid.without = {{0, 1}, {5, 1}, {0, 2}, {5, 2}};
  const auto unrolled = grid.unroll();
  REQUIRE(unrolled);
  CHECK(unrolled->seams.size() == 2);
  CHECK(unrolled->loops.size() == 1);
  CHECK(unrolled->area == Approx(20));
  check_closed(*unrolled);
}

TEST_CASE("a hole beside the seam is a loop of its own", "[unroll]") {
  Grid grid;
  grid.without = {{2, 1}};
  const auto unrolled = grid.unroll();
  REQUIRE(unrolled);
  CHECK(unrolled->seams.size() == 4);
  CHECK(unrolled->loops.size() == 2);
  check_closed(*unrolled);
}

TEST_CASE("a sphere has a seam from pole to pole, and a jump at each of them", "[unroll]") {
  Grid grid;
  grid.poles = 2;
  const auto unrolled = grid.unroll();
  REQUIRE(unrolled);
  CHECK(unrolled->seams.size() == 4);
  REQUIRE(unrolled->loops.size() == 1);
  CHECK(unrolled->loops[0].size() == 8);
  int jumps = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const auto &to = unrolled->loops[0][i].to, &from = unrolled->loops[0][(i + 1) % 8].from;
    if (to.at == from.at) continue;
    ++jumps;
    CHECK(to.free[0]);
    CHECK(std::abs(to.at[0] - from.at[0]) == Approx(6));
  }
  CHECK(jumps == 2);
  CHECK(unrolled->area == Approx(24));
}

TEST_CASE("a torus is cut along both parameters, a ring of it along one", "[unroll]") {
  Grid grid;
  grid.torus = true;
  const auto whole = grid.unroll();
  REQUIRE(whole);
  CHECK(whole->seams.size() == 10);
  CHECK(whole->loops.size() == 1);
  CHECK(whole->area == Approx(24));
  check_closed(*whole);
  for (int i = 0; i < 6; ++i) grid.without.insert({i, 3});
  const auto ring = grid.unroll();
  REQUIRE(ring);
  CHECK(ring->seams.size() == 3);
  CHECK(ring->area == Approx(18));
}

TEST_CASE("a boundary that touches itself becomes loops that do not", "[unroll]") {
  Grid grid;
  grid.columns = 8;
  grid.without = {{6, 0}, {6, 1}, {6, 2}, {6, 3}, {1, 1}, {2, 2}};
  const auto unrolled = grid.unroll();
  REQUIRE(unrolled);
  CHECK(unrolled->seams.empty());
  CHECK(unrolled->loops.size() == 3);
  for (const auto& loop : unrolled->loops) {
    std::set<std::uint32_t> points;
    for (const auto& step : loop) CHECK(points.insert(step.from.point).second);
  }
}

TEST_CASE("facets that contradict each other are refused", "[unroll]") {
  const UnrollFacet a{{{0, {0, 0}, {}}, {1, {1, 0}, {}}, {2, {0, 1}, {}}}};
  const UnrollFacet b{{{2, {0, 1}, {}}, {1, {1.5, 0}, {}}, {3, {1, 1}, {}}}};
  CHECK(!unroll({a, b}, {0, 0}, {1e-6, 1e-6}));
  CHECK(!unroll({a, b}, {7, 7}, {1e-6, 1e-6}));
}

}  // namespace
}  // namespace cnrg
