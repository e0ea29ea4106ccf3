// What lets most pairs through without a predicate: boxes on a grid, planes as filters, fans around vertices.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>

#include "kernel/complex/complex.h"
#include "kernel/exact/cross_filter.h"
#include "kernel/exact/plane_filter.h"
#include "kernel/exact/predicates.h"
#include "kernel/refine/box_pairs.h"
#include "kernel/refine/box_tree.h"
#include "kernel/refine/fans.h"
#include "tests/scenes/seeds.h"

namespace cnrg::scenes {
namespace {

using Random = std::mt19937;

/// Calls `test(seed)` for the seeds asked for.
template <class Test>
void for_each_seed(std::uint64_t usual, const Test& test) {
  const auto [first, last] = seeds(usual);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    CAPTURE(seed);
    test(static_cast<unsigned>(seed));
  }
}

double real(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
int integer(Random& random, int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }

/// Boxes on a small grid, so that many touch, some of them flat; scaled and moved.
std::vector<Box> random_boxes(Random& random) {
  const int n = integer(random, 0, 200), side = integer(random, 1, 12), flat = integer(random, 0, 6);
  const double scale = std::ldexp(1.0, integer(random, -900, 900)),
               shift = scale * integer(random, -100000, 100000);
  std::vector<Box> boxes(static_cast<std::size_t>(n));
  for (Box& box : boxes) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int low = static_cast<int>(k) == flat ? 3 : integer(random, 0, side);
      box.lo[k] = shift + scale * low;
      box.hi[k] = shift + scale * (low + (static_cast<int>(k) == flat ? 0 : integer(random, 0, 3)));
    }
  }
  return boxes;
}

TEST_CASE("a tree of boxes asks about no box that is empty, and about few that are far", "[boxes]") {
  const auto asked = [](std::size_t n) {
    std::vector<Box> boxes(n);
    for (std::size_t i = 0; i < n; ++i) {
      boxes[i].extend({2.0 * static_cast<double>(i), 0, 0}, {2.0 * static_cast<double>(i) + 1, 1, 1});
    }
    const BoxTree tree(boxes);
    const Box last = boxes.back();
    std::size_t tests = 0, found = 0;
    tree.query(
        [&](const Box& box) {
          CHECK(box.lo[0] <= box.hi[0]);
          ++tests;
          return box.meets(last);
        },
        [&](std::uint32_t) { ++found; });
    CHECK(found == 1);
    return tests;
  };
  for (const std::size_t n : {1, 5, 96, 97, 129, 3 * 256}) CHECK(asked(n) <= 2 * 10 + BoxTree::kBlock);
}

TEST_CASE("pairs of boxes: every pair that meets, each once", "[boxes][random]") {
  for_each_seed(400, [](unsigned seed) {
    Random random(seed);
    const std::vector<Box> boxes = random_boxes(random);
    const BoxPairs pairs(boxes);
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    for (std::size_t part = 0; part < pairs.part_count(); ++part) {
      pairs.find(part, [&](std::uint32_t x, std::uint32_t y) {
        CHECK(found.insert(std::minmax(pairs.item(x), pairs.item(y))).second);
      });
    }
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      std::set<std::uint32_t> around;
      pairs.query(boxes[i], [&](std::uint32_t j) { around.insert(j); });
      for (std::uint32_t j = 0; j < boxes.size(); ++j) {
        if (!boxes[i].meets(boxes[j])) continue;
        CHECK(around.count(j) == 1);
        if (i < j) CHECK(found.count({i, j}) == 1);
      }
    }
  });
}

TEST_CASE("a plane as a filter: what it decides is right", "[filter][random]") {
  std::size_t decided = 0, all = 0;
  for_each_seed(2000, [&](unsigned seed) {
    Random random(seed);
    const double scale = std::ldexp(1.0, integer(random, -60, 60));
    std::array<double, 12> c;
    const bool level = seed % 4 == 0;
    for (double& x : c) x = scale * (seed % 3 == 0 ? integer(random, -5, 5) : real(random, -1, 1));
    if (level) c[5] = c[8] = c[2];
    if (seed % 2 == 0) {  // near the plane: a sum of the corners, rounded
      const double s = real(random, -2, 2), t = real(random, -2, 2);
      for (std::size_t k = 0; k < 3; ++k) c[9 + k] = c[k] + s * (c[3 + k] - c[k]) + t * (c[6 + k] - c[k]);
    }
    PointTable table;
    table.add(c);
    const PlaneFilter filter(c.data(), c.data() + 3, c.data() + 6);
    const int exact = orient3d(view_of(table.exact(VertexId(0))), view_of(table.exact(VertexId(1))),
                               view_of(table.exact(VertexId(2))), view_of(table.exact(VertexId(3))));
    ++all;
    if (const int side = filter.side(c.data() + 9); side != kUndecided) {
      CHECK(side == exact);
      ++decided;
    }
    const ExactPlane plane = table.exact_plane(table.add_plane(VertexId(0), VertexId(1), VertexId(2)));
    const Integer* normal[3] = {&plane.a, &plane.b, &plane.c};
    for (int k = 0; k < 3; ++k) {
      if (const int s = filter.normal_sign(k)) CHECK(s == sgn(*normal[k]));
    }
  });
  CHECK(2 * decided > all);
}

/// A closed fan around the origin over n directions that go around `turns` times; heights by chance.
Soup fan(Random& random, int n, int turns, double steep) {
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  const PointId tip = soup.add_point(0, 0, 0);
  std::vector<PointId> rim;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * turns * (i + real(random, -0.3, 0.3)) / n, r = real(random, 0.5, 2);
    rim.push_back(soup.add_point(r * std::cos(angle), r * std::sin(angle), steep * real(random, -1, 1)));
  }
  for (int i = 0; i < n; ++i) {
    const auto f = static_cast<std::uint32_t>(i);
    soup.add_triangle(leaf, tip, rim[static_cast<std::size_t>(i)], rim[static_cast<std::size_t>((i + 1) % n)], f,
                      f);
  }
  return soup;
}

TEST_CASE("an embedded fan meets itself in nothing but what its triangles share", "[fans][random]") {
  std::size_t embedded = 0, crossing = 0, all = 0;
  for_each_seed(600, [&](unsigned seed) {
    Random random(seed);
    const int turns = seed % 3 == 0 ? 2 : 1, n = integer(random, 3 * turns, 9 * turns);
    const Soup soup = fan(random, n, turns, seed % 5 == 0 ? 3 : 0.3);
    RefineReport report;
    const RefineInput input = prepare_input(soup, report);
    const bool certain = embedded_fans(input)[input.vertex_of[0].index()] != 0;
    const auto built_complex = build_complex(soup, {}, &report);
    const Complex& complex = *built_complex;
    const bool apart = report.constructed == 0 && complex.vertex_count() == static_cast<std::size_t>(n) + 1 &&
                       complex.edge_count() == 2 * static_cast<std::size_t>(n);
    if (certain) CHECK(apart);
    if (turns == 2) CHECK_FALSE(certain);
    embedded += certain;
    crossing += !apart;
    ++all;
  });
  CHECK(10 * embedded > all);
  CHECK(10 * crossing > all);
}

}  // namespace
}  // namespace cnrg::scenes
