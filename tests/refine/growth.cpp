// What many facets cost. Oblique ones in pairs that are looked at: a few per facet, however they are turned. Holes
// of one face in predicates.
#include <tbb/global_control.h>

#include <cmath>
#include <functional>

#include "kernel/complex/complex.h"
#include "kernel/exact/integers.h"
#include "kernel/exact/predicates.h"
#include "tests/catch.h"
#include "tests/scenes/fixture.h"

namespace cnrg::scenes {
namespace {

using Point = std::array<double, 3>;

/// Points turned by 30 degrees about (1, 2, 3), rounded to doubles or to fractions of 3^20.
class Turn {
 public:
  explicit Turn(bool fractions) : fractions_(fractions) {}
  /// As it is, or a third of it.
  PointId add_exactly(Soup& soup, const Point& p) const {
    if (!fractions_) return soup.add_point(p[0], p[1], p[2]);
    return soup.add_point({from_double(p[0]) / 3, from_double(p[1]) / 3, from_double(p[2]) / 3});
  }
  PointId add(Soup& soup, const Point& p) const {
    const double a[3] = {1 / std::sqrt(14.0), 2 / std::sqrt(14.0), 3 / std::sqrt(14.0)};
    const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
    const double along = (a[0] * p[0] + a[1] * p[1] + a[2] * p[2]) * (1 - c);
    Point q;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      q[k] = c * p[k] + s * (a[i] * p[j] - a[j] * p[i]) + along * a[k];
    }
    if (!fractions_) return soup.add_point(q[0], q[1], q[2]);
    const Rational unit = fraction(1, 3486784401);
    RationalPoint r;
    for (std::size_t k = 0; k < 3; ++k) r[k] = unit * to_integer(std::llround(q[k] * 3486784401));
    return soup.add_point(r);
  }

 private:
  bool fractions_;
};

/// n long narrow triangles side by side in one plane; their corners are sums of two vectors, so that they are
/// coplanar exactly.
Soup strip(int n, const Turn& turn) {
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  const Point along{7, 11, -5}, step{0.0078125, -0.00390625, 0.001953125};
  std::vector<PointId> p;
  for (int i = 0; i <= n / 2; ++i) {
    for (int end = 0; end < 2; ++end) {
      Point q;
      for (std::size_t k = 0; k < 3; ++k) q[k] = end * along[k] + i * step[k];
      p.push_back(turn.add_exactly(soup, q));
    }
  }
  for (std::uint32_t i = 0; i + 2 < p.size(); i += 2) {
    soup.add_triangle(leaf, p[i], p[i + 2], p[i + 1], i, i);
    soup.add_triangle(leaf, p[i + 1], p[i + 2], p[i + 3], i + 1, i + 1);
  }
  return soup;
}

PointId on_circle(Soup& soup, const Turn& turn, int i, int n, double radius, double height) {
  const double angle = 2 * M_PI * i / n;
  return turn.add(soup, {radius * std::cos(angle), radius * std::sin(angle), height});
}

/// The side of a cylinder of n rectangles, cut into triangles.
Soup tube(int n, const Turn& turn) {
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  std::vector<PointId> p;
  for (int i = 0; i < n; ++i) {
    p.push_back(on_circle(soup, turn, i, n, 1, 0));
    p.push_back(on_circle(soup, turn, i, n, 1, 4));
  }
  const auto m = static_cast<std::uint32_t>(p.size());
  for (std::uint32_t i = 0; i < m; i += 2) {
    soup.add_triangle(leaf, p[i], p[(i + 2) % m], p[i + 1], i, i);
    soup.add_triangle(leaf, p[i + 1], p[(i + 2) % m], p[(i + 3) % m], i + 1, i + 1);
  }
  return soup;
}

/// n triangles around a tip, steep.
Soup cone(int n, const Turn& turn) {
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  const PointId tip = turn.add(soup, {0, 0, 4});
  std::vector<PointId> p;
  for (int i = 0; i < n; ++i) p.push_back(on_circle(soup, turn, i, n, 1, 0));
  for (std::uint32_t i = 0; i < p.size(); ++i) soup.add_triangle(leaf, p[i], p[(i + 1) % p.size()], tip, i, i);
  return soup;
}

TEST_CASE("many oblique facets: a few pairs are looked at for each", "[refine][growth]") {
  const std::vector<std::pair<const char*, std::function<Soup(int, const Turn&)>>> scenes{
      {"strip", strip}, {"tube", tube}, {"cone", cone}};
  for (const auto& [name, make] : scenes) {
    for (const bool fractions : {false, true}) {
      for (const int n : {1000, 4000}) {
        CAPTURE(name, fractions, n);
        const Soup soup = make(n, Turn(fractions));
        RefineReport report;
        const auto complex = build_complex(soup, {}, &report);
        CHECK(complex->face_count() == soup.face_count());
        CHECK(report.candidates < 20 * soup.face_count());
      }
    }
  }
}

std::uint64_t signs_of(const Soup& soup, std::size_t faces) {
  reset_stage_counts();
  const auto complex = build_complex(soup);
  const StageCounts counts = stage_counts();
  CHECK(complex->face_count() == faces);
  return counts.filter + counts.interval + counts.exact;
}

TEST_CASE("the holes of a face cost by their number", "[sheets][growth]") {
  const auto signs = [](int n) {
    const auto at = [](int x, int y) { return std::to_string(x) + " " + std::to_string(y) + " 0"; };
    std::string text =
        "leaf none\nface -1 -1 0, " + at(4 * n, -1) + ", " + at(4 * n, 4 * n) + ", " + at(-1, 4 * n);
    for (int i = 0; i < n * n; ++i) {
      const int x = 4 * (i % n), y = 4 * (i / n);
      text += " | " + at(x, y) + ", " + at(x + 2, y) + ", " + at(x, y + 2);
    }
    return signs_of(make_soup(parse_fixture(text)), 1);
  };
  const auto few = signs(20), many = signs(40);  // 400 and 1,600 holes
  CHECK(few > 400);
  CHECK(double(many) < 2.5 * 2.5 * double(few));
}

/// A disc of n coplanar triangles, in a plane that is turned where `fractions` is.
Soup disc(int n, bool fractions) {
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  const auto add = [&](double x, double y) {
    if (!fractions) return soup.add_point(x, y, 0.0);
    const Rational u = from_double(x) / 3, v = from_double(y) / 3;
    return soup.add_point({u + 2 * v, u - v, -u + v / 2});
  };
  const PointId middle = add(0, 0);
  std::vector<PointId> p;
  for (int i = 0; i < n; ++i) p.push_back(add(std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n)));
  for (std::uint32_t i = 0; i < p.size(); ++i) soup.add_triangle(leaf, middle, p[i], p[(i + 1) % p.size()], i, i);
  return soup;
}

TEST_CASE("the triangles of a disc around its middle cost by their number", "[sheets][growth]") {
  for (const bool fractions : {false, true}) {
    CAPTURE(fractions);
    const auto few = signs_of(disc(1000, fractions), 1000), many = signs_of(disc(4000, fractions), 4000);
    CHECK(few > 1000);
    CHECK(double(many) < 6 * double(few));
  }
}

/// Two grids of n x n squares in one turned plane, one half a square aside.
Soup grids(int n) {
  Soup soup;
  for (int leaf = 0; leaf < 2; ++leaf) {
    const LeafId id = soup.add_leaf(Fill::none);
    std::vector<PointId> p;
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        const Rational u = (i + Rational(leaf, 2)) / 3, v = (j + Rational(leaf, 2)) / 3;
        p.push_back(soup.add_point({u + 2 * v, u - v, -u + v / 2}));
      }
    }
    const auto m = static_cast<std::uint32_t>(n + 1);
    for (std::uint32_t i = 0; i + 1 < m; ++i) {
      for (std::uint32_t j = 0; j + 1 < m; ++j) {
        const std::uint32_t a = i * m + j;
        soup.add_triangle(id, p[a], p[a + m], p[a + m + 1], a, a);
        soup.add_triangle(id, p[a], p[a + m + 1], p[a + 1], a, a);
      }
    }
  }
  return soup;
}

TEST_CASE("faces are not compared where others show that they are coplanar", "[sheets][growth]") {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);  // each finds out alone
  reset_stage_counts();
  RefineReport report;
  const Soup soup = grids(20);
  build_complex(soup, {}, &report);
  CHECK(report.candidates > 8 * soup.face_count());
  CHECK(stage_counts().exact < report.candidates);
}

TEST_CASE("many segments with an end in common, some on top of each other", "[sheets]") {
  // Ways from the middle to the border of a square, in 400 directions; on every fifth a wire ends half way and
  // another goes on behind it, and a third starts where the second ends, outside.
  const auto at = [](int x, int y) { return std::to_string(x) + " " + std::to_string(y) + " 0"; };
  std::string text = "leaf none\nface -1000 -1000 0, 1000 -1000 0, 1000 1000 0, -1000 1000 0\nleaf none\n";
  int directions = 0;
  for (int x = -50; x <= 50; ++x) {
    for (const int y : {-50, 50}) {
      for (const bool swapped : {false, true}) {
        if (swapped && (x == 50 || x == -50)) continue;
        const int a = swapped ? y : x, b = swapped ? x : y;
        text += "wire 0 0 0, " + at(4 * a, 4 * b) + "\n";
        if (++directions % 5 != 0) continue;
        text += "wire " + at(2 * a, 2 * b) + ", 0 0 0\n";
        text += "wire 0 0 0, " + at(8 * a, 8 * b) + "\n";
      }
    }
  }
  REQUIRE(directions == 400);
  const auto complex = build_complex(make_soup(parse_fixture(text)));
  CHECK(complex->face_count() == 1);
  CHECK(complex->vertex_count() == 4 + 1 + 400 + 2 * 80);
  CHECK(complex->edge_count() == 4 + 400 + 2 * 80);
}

}  // namespace
}  // namespace cnrg::scenes
