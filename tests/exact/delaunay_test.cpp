// Delaunay triangulations against their definition, by rationals: every circle is empty, the whole hull is
// covered.
#include "kernel/exact/delaunay.h"

#include <algorithm>
#include <random>

#include "kernel/exact/rational.h"
#include "tests/catch.h"

using namespace cnrg;

namespace {

using Points = std::vector<std::array<double, 2>>;

struct Plane {
  Rational x, y;
};

Plane exact(const std::array<double, 2>& p) { return {from_double(p[0]), from_double(p[1])}; }

/// Twice the area of a triangle, positive if it is counter-clockwise.
Rational area(const Plane& a, const Plane& b, const Plane& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Positive if d is inside of the circle through the counter-clockwise a, b, c.
Rational in_circle(const Plane& a, const Plane& b, const Plane& c, const Plane& d) {
  const auto row = [&](const Plane& p) {
    const Rational x = p.x - d.x, y = p.y - d.y;
    return std::array<Rational, 3>{x, y, x * x + y * y};
  };
  const auto p = row(a), q = row(b), r = row(c);
  return p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) +
         p[2] * (q[0] * r[1] - q[1] * r[0]);
}

void check_delaunay(const Points& points) {
  const Delaunay made = delaunay(points);
  Rational covered = 0;
  for (const auto& [i, j, k] : made.triangles) {
    const Plane a = exact(points[i]), b = exact(points[j]), c = exact(points[k]);
    const Rational twice = area(a, b, c);
    REQUIRE(twice > 0);
    covered += twice;
    for (const auto& p : points) REQUIRE(in_circle(a, b, c, exact(p)) <= 0);
  }
  // The border turns left or goes straight on, and all points are on its left: it is the hull.
  Rational hull = 0;
  const std::size_t n = made.border.size();
  REQUIRE(n >= 3);
  for (std::size_t i = 0; i < n; ++i) {
    const Plane a = exact(points[made.border[i]]), b = exact(points[made.border[(i + 1) % n]]);
    for (const auto& p : points) REQUIRE(area(a, b, exact(p)) >= 0);
    hull += a.x * b.y - a.y * b.x;
  }
  CHECK(covered == hull);
  CHECK(made.triangles.size() == 2 * points.size() - 2 - n);  // no point is left out
}

/// Triangles as sets of places.
std::vector<std::array<std::array<double, 2>, 3>> places(const Points& points) {
  std::vector<std::array<std::array<double, 2>, 3>> result;
  for (const auto& [i, j, k] : delaunay(points).triangles) {
    auto& t = result.emplace_back(std::array{points[i], points[j], points[k]});
    std::sort(t.begin(), t.end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

TEST_CASE("Delaunay triangulations are what they are called") {
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    // Doubles of no kind, a fine lattice far from the origin (nearly on lines and circles), and a coarse one.
    Points any, lattice, far;
    for (int i = 0; i < 40; ++i) {
      any.push_back(
          {std::ldexp(static_cast<double>(random()), -20), std::ldexp(static_cast<double>(random()), -29)});
      lattice.push_back({static_cast<double>(random() % 7), static_cast<double>(random() % 5)});
      far.push_back({6e6 + std::ldexp(static_cast<double>(random() % 8), -29),
                     7e6 + std::ldexp(static_cast<double>(random() % 9), -29)});
    }
    for (Points* points : {&any, &lattice, &far}) {
      std::sort(points->begin(), points->end());
      points->erase(std::unique(points->begin(), points->end()), points->end());
      check_delaunay(*points);
    }
  }
}

TEST_CASE("a Delaunay triangulation does not depend on the order of points") {
  Points points;
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 9; ++j) points.push_back({i * 0.5, j * 0.5});
  }
  const auto first = places(points);
  CHECK(first.size() == 2 * 11 * 8);
  std::mt19937 random(3);
  for (int round = 0; round < 30; ++round) {
    std::shuffle(points.begin(), points.end(), random);
    CHECK(places(points) == first);
  }
}

TEST_CASE("points on a line have no triangles") {
  CHECK(delaunay({}).triangles.empty());
  const Points line = {{0, 0}, {1, 3}, {2, 6}, {-1, -3}};
  for (std::size_t n = 1; n <= line.size(); ++n) {
    const Delaunay made = delaunay({line.data(), n});
    CHECK(made.triangles.empty());
    CHECK(made.border.empty());
  }
  const Points nearly = {{0, 0}, {1, 3}, {2, std::nextafter(6, 7)}};
  CHECK(delaunay(nearly).triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}});
}
