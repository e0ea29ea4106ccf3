// Height fields on fewer points: how far both surfaces are apart is measured by brute force over the overlay of
// their triangles, which shares nothing with the walk along edges of the program.
#include <random>

#include "tests/exact/rational_text.h"
#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;
using Catch::Contains;

namespace {

using Plan = std::array<Rational, 2>;
using Corners = std::array<RationalPoint, 3>;

std::vector<Corners> triangles_of(const Soup& soup) {
  std::vector<Corners> out;
  for (const SourceId f : IdRange<SourceId>(soup.face_count())) {
    const auto corners = loops(soup, f)[0];
    if (soup.face(f).leaf_face == 0) out.push_back({corners[0], corners[1], corners[2]});
  }
  return out;
}

Rational turn(const Plan& a, const Plan& b, const Plan& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
Plan plan(const RationalPoint& p) { return {p[0], p[1]}; }

/// The height of the first triangle that covers a place.
Rational height(const std::vector<Corners>& surface, const Plan& at) {
  for (const auto& [a, b, c] : surface) {
    const Rational u = turn(plan(b), plan(c), at), v = turn(plan(c), plan(a), at), w = turn(plan(a), plan(b), at);
    if (u >= 0 && v >= 0 && w >= 0) return (u * a[2] + v * b[2] + w * c[2]) / (u + v + w);
  }
  FAIL("no triangle covers a place");
  return 0;
}

/// Corners of both, and all crossings of their sides in plan: there the largest distance is.
Rational distance(const std::vector<Corners>& one, const std::vector<Corners>& other) {
  std::set<Plan> places;
  for (const auto* surface : {&one, &other}) {
    for (const Corners& t : *surface)
      for (const RationalPoint& p : t) places.insert(plan(p));
  }
  for (const Corners& s : one) {
    for (const Corners& t : other) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          const Plan a = plan(s[i]), b = plan(s[(i + 1) % 3]), c = plan(t[k]), d = plan(t[(k + 1) % 3]);
          const Rational before = turn(c, d, a), behind = turn(c, d, b);
          if (before * behind >= 0 || turn(a, b, c) * turn(a, b, d) >= 0) continue;
          const Rational part = before / (before - behind);
          places.insert({Rational(a[0] + part * (b[0] - a[0])), Rational(a[1] + part * (b[1] - a[1]))});
        }
      }
    }
  }
  Rational most = 0;
  for (const Plan& at : places) most = std::max(most, Rational(abs(height(one, at) - height(other, at))));
  return most;
}

std::size_t used_points(const std::vector<Corners>& surface) {
  std::set<RationalPoint> points;
  for (const Corners& t : surface) points.insert(t.begin(), t.end());
  return points.size();
}

}  // namespace

TEST_CASE("a height field within a bound is nowhere farther from the whole one") {
  std::mt19937 random(7);
  std::size_t all = 0, kept = 0;
  for (int round = 0; round < 24; ++round) {
    HeightfieldShape shape;
    const std::size_t columns = 2 + random() % 7, rows = 2 + random() % 7;
    const bool rough = round % 3 == 0;
    for (std::size_t j = 0; j < rows; ++j) {
      auto& row = shape.heights.emplace_back();
      for (std::size_t i = 0; i < columns; ++i) {
        const int x = static_cast<int>(i), y = static_cast<int>(j);
        row.push_back(rough ? Rational(static_cast<int>(random() % 9), 3)
                            : Rational((x - 3) * (x - 3) + x * y - (y == 4 ? 3 : 0), 5));
        row.back().canonicalize();
      }
    }
    shape.spacing_x = 3;
    shape.origin_y = Rational(1, 7);
    shape.base = -9;
    const std::vector<Corners> whole = triangles_of(soup_of(shape));
    for (const char* within : {"1/1000000", "1/5", "1", "100"}) {
      CAPTURE(round, columns, rows, within);
      shape.within = r(within);
      const Soup soup = soup_of(shape);
      CHECK(closed(soup));
      CHECK(volume(soup) > 0);
      CHECK(soup.curve_ends().size() == 4);
      const std::vector<Corners> coarse = triangles_of(soup);
      CHECK(distance(whole, coarse) <= *shape.within);
      all += columns * rows;
      kept += used_points(coarse);
      if (within == std::string("100")) CHECK(coarse.size() == 2);
      CHECK_THAT(prepare(shape)->notices().at(0),
                 Contains("heightfield: " + std::to_string(used_points(coarse)) + " of " +
                          std::to_string(columns * rows) + " points make a surface within "));
    }
  }
  CHECK(kept < all * 2 / 3);
}

TEST_CASE("a ridge that no point tells of is kept") {
  // Corners at 0, and at 1 on the diagonal that the grid does not have: at all points two triangles would do.
  HeightfieldShape shape;
  shape.heights = {{0, 1}, {1, 0}};
  shape.within = Rational(1, 2);
  CHECK(triangles_of(soup_of(shape)).size() == 2);
  HeightfieldShape bent;
  bent.heights = {{0, 0, 0}, {0, 4, 0}, {0, 0, 0}};
  bent.within = Rational(1, 10);
  const std::vector<Corners> kept = triangles_of(soup_of(bent));
  bent.within.reset();
  CHECK(distance(triangles_of(soup_of(bent)), kept) <= Rational(1, 10));
}

TEST_CASE("a plane has four points, and a bound is refused where it means nothing") {
  const Files files;
  HeightfieldShape shape;
  shape.file = files.write(
      "plane.asc", "ncols 40\nnrows 30\nxllcenter 5\nyllcenter 7\ncellsize 10\n" + [] {
        std::string rows;
        for (int j = 0; j < 30; ++j)
          for (int i = 0; i < 40; ++i) rows += std::to_string(3 * i - 2 * j) + (i == 39 ? "\n" : " ");
        return rows;
      }());
  shape.within = Rational(1, 1'000'000'000);
  CHECK(triangles_of(soup_of(shape)).size() == 2);
  shape.file = files.write(
      "gap.asc", "ncols 2\nnrows 2\nxllcenter 5\nyllcenter 7\ncellsize 10\nNODATA_value -1\n1 1\n1 -1\n");
  CHECK_THAT(error_of(shape), Contains("`within` is for grids without gaps"));
  shape.file = files.write("a.xyz", "0 0 1\n1 0 1\n0 1 1\n");
  CHECK_THAT(error_of(shape), Contains("`within` is for grids, and .xyz are points"));
}
