// Cells around points, and lines that pass near each other, against exact distances.
#include "csg/result/hot_cells.h"

#include <cmath>
#include <random>

#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"
#include "tests/catch.h"

using namespace cnrg;

namespace {

using Xyz = HotCells::Xyz;

RationalPoint exact(const Xyz& p) { return {from_double(p[0]), from_double(p[1]), from_double(p[2])}; }

double largest(const Xyz& p) { return std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}); }

double distance_to(const Xyz& p, const std::array<Xyz, 2>& line) {
  const Xyz way = minus(line[1], line[0]), area = accurate_cross(way, minus(p, line[0]));
  return std::sqrt(dot(area, area) / dot(way, way));
}

/// Where two lines are nearest: parts of both segments, and the distance.
struct Nearest {
  double x, y, distance;
  explicit Nearest(const std::array<Xyz, 2>& s, const std::array<Xyz, 2>& t) {
    const RationalPoint p = exact(s[1]) - exact(s[0]), q = exact(t[1]) - exact(t[0]),
                        r = exact(s[0]) - exact(t[0]);
    const RationalPoint normal = cnrg::cross(p, q);
    const Rational area = cnrg::dot(normal, normal), apart = cnrg::dot(r, normal);
    x = to_double(-cnrg::dot(cnrg::cross(r, q), normal) / area);
    y = to_double(-cnrg::dot(cnrg::cross(r, p), normal) / area);
    distance = std::sqrt(to_double(apart * apart / area));
  }
};

}  // namespace

// Two edges 200 long that differ by 1e-6 in direction have lost 12 of 16 digits of the square of the area between
// them if that is computed of lengths and a dot product.
TEST_CASE("hot cells: lines are found near each other however small their angle", "[snap]") {
  const double within = 0x1p-32;
  std::mt19937_64 random(5);
  const auto part = [&] { return double(random() % 2'000'001) / 1e6 - 1; };
  int near = 0;
  for (int k = 0; k < 2000; ++k) {
    const double angle = std::exp2(-double(k % 28));
    const Xyz middle{3000 + 5000 * part(), 5000 * part(), 5000 * part()};
    const Xyz way{100 * part() + 150, 100 * part(), 100 * part()};
    const double aside[3] = {100 * angle * part(), 100 * angle * part(), 100 * angle * part()};
    const double off = within * (1 + part());
    std::array<std::array<Xyz, 2>, 2> lines;
    for (std::size_t i = 0; i < 3; ++i) {
      lines[0][0][i] = middle[i] - way[i], lines[0][1][i] = middle[i] + way[i] / 2;
      lines[1][0][i] = middle[i] - way[i] / 3 - aside[i] + off,
      lines[1][1][i] = middle[i] + way[i] + aside[i] + off;
    }
    const Nearest exactly(lines[0], lines[1]);
    const auto found = where_near({lines[0], lines[1]}, within, {});
    INFO("case " << k << ", angle " << angle << ", distance " << exactly.distance);
    const auto inside = [](double t) { return 0.001 < t && t < 0.999; };
    if (exactly.distance > 1.001 * within || !inside(exactly.x) || !inside(exactly.y)) {
      if (exactly.distance > 1.001 * within) CHECK(found.empty());
      continue;
    }
    if (exactly.distance > 0.999 * within) continue;
    ++near;
    REQUIRE(found.size() == 1);
    for (const auto& line : lines) CHECK(distance_to(found[0], line) < 0.51 * within);  // it is in the middle
  }
  CHECK(near > 300);
}

TEST_CASE("hot cells: points that come first stay, what is near goes to the nearest", "[snap]") {
  std::mt19937_64 random(7);
  std::vector<Xyz> points;
  for (int k = 0; k < 3000; ++k) {
    points.push_back({double(random() % 4000) / 64, double(random() % 4000) / 64, double(random() % 200) / 64});
  }
  const double size = 4;
  const HotCells cells(points, size);
  const std::vector<Xyz>& centers = cells.centers();
  REQUIRE(centers[0] == points[0]);
  REQUIRE(centers.size() < points.size());
  std::size_t next = 0;  // center
  for (const Xyz& p : points) {
    double least = INFINITY, before = INFINITY;
    for (std::size_t c = 0; c < centers.size(); ++c) {
      const double distance = largest(minus(p, centers[c]));
      least = std::min(least, distance);
      if (c < next) before = std::min(before, distance);
    }
    const auto cell = cells.cell_of(p);
    REQUIRE(cell);
    CHECK(largest(minus(p, centers[*cell])) == least);
    if (before > size / 2) CHECK(centers[next++] == p);
  }
  CHECK(next == centers.size());
  CHECK(!cells.cell_of({-10, 0, 0}));
}

TEST_CASE("hot cells: what passes comes nearer than what belongs to a cell", "[snap]") {
  const HotCells cells({{0, 0, 0}, {5, 0, 0}, {10, 3, 0}}, 4);
  const auto passed = [&](double height) {
    std::vector<std::size_t> found;
    for (const auto& pass : cells.along({-9, height, 0}, {19, height, 0})) found.push_back(pass.cell);
    return found;
  };
  CHECK(passed(0.5) == std::vector<std::size_t>{0, 1});
  CHECK(passed(1.5).empty());
  CHECK(passed(2.5) == std::vector<std::size_t>{2});
  CHECK(cells.cell_of({1, 1.5, 0}) == 0);
  const auto planes = [&](double height) {
    return cells.across({-9, height, -20}, {19, height, -20}, {4, height, 40}).size();
  };
  CHECK(planes(0.5) == 2);
  CHECK(planes(1.5) == 0);
  CHECK(planes(2.5) == 1);
}
