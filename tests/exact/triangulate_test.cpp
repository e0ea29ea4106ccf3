// Triangulation: areas add up exactly, triangles turn left, every vertex and slit is there.
#include "kernel/exact/triangulate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "kernel/base/error.h"
#include "kernel/exact/predicates.h"
#include "tests/catch.h"

using namespace cnrg;

namespace {

using Walks = std::vector<std::vector<VertexId>>;

/// Twice the signed area in the projection.
Rational area2(const PointTable& t, Projection axes, const std::vector<VertexId>& loop) {
  Rational sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const RationalPoint a = t.rational(loop[i]), b = t.rational(loop[(i + 1) % loop.size()]);
    sum += a[axes.u] * b[axes.v] - a[axes.v] * b[axes.u];
  }
  return sum;
}

/// Checks the result against everything that `triangulate` promises; the loops' areas have their signs.
std::vector<std::array<VertexId, 3>> check(const PointTable& t, Projection axes, const Walks& loops,
                                           const std::vector<VertexId>& isolated = {}) {
  const auto triangles = triangulate(t, axes, loops, isolated);
  Rational expected = 0, total = 0;
  std::set<VertexId> wanted(isolated.begin(), isolated.end()), seen;
  std::map<std::pair<VertexId, VertexId>, int> walked, used;
  for (const auto& loop : loops) {
    expected += area2(t, axes, loop);
    wanted.insert(loop.begin(), loop.end());
    for (std::size_t i = 0; i < loop.size(); ++i) ++walked[{loop[i], loop[(i + 1) % loop.size()]}];
  }
  for (const auto& triangle : triangles) {
    REQUIRE(orient2d(t, axes, triangle[0], triangle[1], triangle[2]) > 0);
    total += area2(t, axes, {triangle[0], triangle[1], triangle[2]});
    seen.insert(triangle.begin(), triangle.end());
    for (int k = 0; k < 3; ++k) ++used[{triangle[k], triangle[(k + 1) % 3]}];
  }
  REQUIRE(total == expected);
  REQUIRE(seen == wanted);
  for (const auto& [edge, n] : used) {
    REQUIRE(n == 1);  // each side of an edge has one triangle
    const bool boundary = walked.contains(edge) && !walked.contains({edge.second, edge.first});
    REQUIRE(used.contains({edge.second, edge.first}) == !boundary);
  }
  for (const auto& [edge, n] : walked) REQUIRE(used.contains(edge));
  return triangles;
}

std::vector<VertexId> add(PointTable& t, const std::vector<std::array<double, 2>>& points) {
  std::vector<VertexId> result;
  for (const auto& p : points) result.push_back(t.add(p[0], p[1], 2 * p[0] - p[1]));
  return result;
}

constexpr Projection kXY{0, 1};

}  // namespace

TEST_CASE("a triangle is itself, from both sides") {
  PointTable t;
  const auto p = add(t, {{0, 0}, {1, 0}, {0, 1}});
  CHECK(check(t, kXY, {p}).size() == 1);
  const auto seen_from_below = triangulate(t, Projection{1, 0}, Walks{p});
  REQUIRE(seen_from_below.size() == 1);
  CHECK(orient2d(t, Projection{1, 0}, seen_from_below[0][0], seen_from_below[0][1], seen_from_below[0][2]) > 0);
}

TEST_CASE("quads: convex, with a reflex corner, with a straight corner, reversed") {
  PointTable t;
  CHECK(check(t, kXY, {add(t, {{0, 0}, {2, 0}, {2, 1}, {0, 1}})}).size() == 2);
  CHECK(check(t, kXY, {add(t, {{0, 0}, {4, 0}, {1, 1}, {0, 4}})}).size() == 2);
  CHECK(check(t, kXY, {add(t, {{0, 0}, {1, 0}, {2, 0}, {0, 2}})}).size() == 2);
  CHECK(check(t, kXY, {add(t, {{0, 0}, {2, 0}, {1, 1}, {0, 2}})}).size() == 2);
  const auto q = add(t, {{0, 0}, {0, 1}, {2, 1}, {2, 0}});
  CHECK(triangulate(t, kXY, Walks{q}).size() == 2);
}

TEST_CASE("of two diagonals the shorter one is taken") {
  PointTable t;
  const auto q = add(t, {{0, 0}, {5, 1}, {10, 0}, {5, -1}});
  for (const auto& triangle : triangulate(t, Projection{1, 0}, Walks{q})) {
    CHECK(std::count(triangle.begin(), triangle.end(), q[1]) == 1);
    CHECK(std::count(triangle.begin(), triangle.end(), q[3]) == 1);
  }
}

TEST_CASE("holes, holes that touch, a slit, a bridge and isolated vertices") {
  PointTable t;
  const auto outer = add(t, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  const auto hole = add(t, {{2, 2}, {2, 4}, {4, 4}, {4, 2}});
  const auto point = add(t, {{7, 3}, {8, 8}});
  CHECK(check(t, kXY, {outer, hole}, point).size() == 8 + 2 * 1 - 2 + 2 * 2);
  const auto more = add(t, {{4, 6}, {6, 6}});
  check(t, kXY, {outer, hole, {hole[2], more[0], more[1]}}, point);  // touches the hole in a vertex
  const auto slit = add(t, {{5, 5}, {6, 4}, {7, 5}});
  check(t, kXY, {outer, hole, {slit[0], slit[1], slit[2], slit[1]}}, point);  // a free slit
  // From the outer loop by a bridge to the hole and back.
  check(t, kXY, {{outer[0], outer[1], outer[2], outer[3], outer[0], hole[0], hole[1], hole[2], hole[3], hole[0]}});
}

TEST_CASE("constructed points are corners like any other") {
  PointTable t;
  const VertexId a = t.add(RationalPoint{0, 0, 0}), b = t.add(RationalPoint{3, 0, 0});
  const VertexId c = t.add(RationalPoint{0, 7, 1});
  const VertexId d = t.add(RationalPoint{Rational(1, 3), Rational(1, 7), Rational(1, 49)});
  check(t, kXY, {{a, b, c}}, {d});
}

TEST_CASE("edges are flipped as the caller wishes, but for those that loops walk") {
  PointTable t;
  const auto p = add(t, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  auto triangles = check(t, kXY, {p});
  const auto has = [&](VertexId v, VertexId w) {
    return std::all_of(triangles.begin(), triangles.end(), [&](const auto& corners) {
      return std::count(corners.begin(), corners.end(), v) + std::count(corners.begin(), corners.end(), w) == 2;
    });
  };
  // A wish that never ends comes to its end; one for a diagonal is met.
  flip_edges(triangles, Walks{p}, [](auto...) { return true; });
  for (const auto& wanted : {std::pair{p[0], p[2]}, std::pair{p[1], p[3]}}) {
    flip_edges(triangles, Walks{p}, [&](VertexId from, VertexId, VertexId to, VertexId) {
      return std::minmax(from, to) == std::minmax(wanted.first, wanted.second);
    });
    REQUIRE(triangles.size() == 2);
    CHECK(has(wanted.first, wanted.second));
    for (const auto& [a, b, c] : triangles) CHECK(orient2d(t, kXY, a, b, c) > 0);
  }
  flip_edges(triangles, Walks{p, {p[1], p[3]}}, [](auto...) { return true; });
  CHECK(has(p[1], p[3]));
}

TEST_CASE("faces that are none are refused") {
  PointTable t;
  const auto crossing = add(t, {{0, 0}, {2, 2}, {2, 0}, {0, 2}, {-1, 1}});
  CHECK_THROWS_AS(triangulate(t, kXY, Walks{crossing}), InvariantError);
  const auto twice = add(t, {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}});
  CHECK_THROWS_AS(triangulate(t, kXY, Walks{twice}), InvariantError);
}

TEST_CASE("random star-shaped polygons with holes: areas as fractions, Euler's count") {
  std::mt19937 random(7);
  for (int run = 0; run < 60; ++run) {
    PointTable t;
    const auto star = [&](double x, double y, double r, int n) {
      std::vector<std::array<double, 2>> points;
      for (int i = 0; i < n; ++i) {
        const double angle = 2 * 3.14159265 * (i + 0.3 * double(random() % 100) / 100) / n;
        const double radius = r * (0.3 + 0.7 * double(random() % 1000) / 1000);
        points.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
      }
      return add(t, points);
    };
    Walks loops{add(t, {{0, 0}, {100, 0}, {100, 100}, {0, 100}})};
    std::size_t corners = 4;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        auto hole = star(17 + 33 * i, 17 + 33 * j, 16, 5 + int(random() % 20));
        corners += hole.size();
        std::reverse(hole.begin(), hole.end());
        loops.push_back(hole);
      }
    }
    CHECK(check(t, kXY, loops).size() == corners + 2 * 9 - 2);
    const auto outline = star(500, 500, 300, 40);
    CHECK(check(t, kXY, {outline}, add(t, {{500, 500}})).size() == 40);
  }
}

TEST_CASE("triangles are Delaunay where doubles can tell") {
  PointTable t;
  std::vector<VertexId> grid;
  for (int i = 1; i < 12; ++i) {
    for (int j = 1; j < 12; ++j) grid.push_back(t.add(i + 0.01 * j * j, j + 0.02 * i * (i % 3), 0));
  }
  const auto outer = add(t, {{0, 0}, {20, 0}, {20, 20}, {0, 20}});
  const auto triangles = check(t, kXY, {outer}, grid);
  std::map<std::pair<VertexId, VertexId>, VertexId> opposite;
  for (const auto& triangle : triangles) {
    for (int k = 0; k < 3; ++k) opposite[{triangle[k], triangle[(k + 1) % 3]}] = triangle[(k + 2) % 3];
  }
  for (const auto& [edge, apex] : opposite) {
    const auto other = opposite.find({edge.second, edge.first});
    if (other == opposite.end()) continue;
    const auto d = t.approx(other->second);
    double row[3][3];
    int i = 0;
    for (const VertexId v : {edge.first, edge.second, apex}) {
      const auto p = t.approx(v);
      row[i][0] = p[0] - d[0];
      row[i][1] = p[1] - d[1];
      row[i][2] = row[i][0] * row[i][0] + row[i][1] * row[i][1];
      ++i;
    }
    double in_circle = 0;
    for (int k = 0; k < 3; ++k) {
      const auto &p = row[(k + 1) % 3], &q = row[(k + 2) % 3];
      in_circle += row[k][2] * (p[0] * q[1] - p[1] * q[0]);
    }
    CHECK(in_circle < 1e-9);
  }
}
