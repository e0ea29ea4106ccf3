// What lets most pairs through without a predicate: boxes on a grid, planes as filters, fans around vertices.
#include <cmath>
#include <random>
#include <set>

#include "kernel/complex/complex.h"
#include "kernel/exact/cross_filter.h"
#include "kernel/exact/integers.h"
#include "kernel/exact/plane_filter.h"
#include "kernel/exact/predicates.h"
#include "kernel/refine/box_pairs.h"
#include "kernel/refine/box_tree.h"
#include "kernel/refine/fans.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

namespace cnrg::scenes {
namespace {

using Mersenne = std::mt19937;

/// Calls `test(seed)` for the seeds asked for.
template <class Test>
void for_each_seed(std::uint64_t usual, const Test& test) {
  const auto [first, last] = seeds(usual);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    CAPTURE(seed);
    test(static_cast<unsigned>(seed));
  }
}

double real(Mersenne& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
int integer(Mersenne& random, int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }

/// Boxes on a small grid, so that many touch, some of them flat; scaled and moved.
std::vector<Box> random_boxes(Mersenne& random) {
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
    Mersenne random(seed);
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

/// Long oblique segments and triangles, as lists of corners on a fine grid: strips side by side, and what crosses
/// some of them in points known exactly.
struct Oblique {
  std::vector<std::vector<std::array<double, 3>>> items;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> meeting;  // two items with a common point
};

Oblique random_oblique(Mersenne& random) {
  using P = std::array<double, 3>;
  Oblique out;
  const double scale = std::ldexp(1.0, integer(random, -300, 300));
  const auto point = [&](int size) {
    return P{double(integer(random, -size, size)), double(integer(random, -size, size)),
             double(integer(random, -size, size))};
  };
  const auto sum = [](const P& a, const P& b, double t) {
    return P{a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
  };
  const P along = point(1 << 20), step = point(1 << 6), begin = point(1 << 20);
  const int n = integer(random, 200, 1500);
  for (int i = 0; i < n; ++i) {
    const P a = sum(begin, step, i), b = sum(a, step, 1), c = sum(a, along, 1);
    if (i % 2 == 0) out.items.push_back({a, c});
    else out.items.push_back({a, b, c});
    if (i > 0 && (i - 1) % 2 != 0)
      out.meeting.push_back({std::uint32_t(i - 1), std::uint32_t(i)});  // b is the next a
  }
  for (int i = 0; i < 40; ++i) {
    const auto j = static_cast<std::uint32_t>(integer(random, 0, n - 1));
    const auto& other = out.items[j];
    // A quarter or half of the way from one corner to another, and a segment with its middle there.
    const P at = sum(sum(P{}, other[0], 0.75), other[1], 0.25), way = point(integer(random, 0, 1) ? 1 << 20 : 3);
    out.meeting.push_back({j, static_cast<std::uint32_t>(out.items.size())});
    out.items.push_back({sum(at, way, 1), sum(at, way, -1)});
  }
  for (auto& item : out.items) {
    for (P& p : item) p = {p[0] * scale, p[1] * scale, p[2] * scale};
  }
  return out;
}

TEST_CASE("pairs of oblique items: every pair that meets, few that do not", "[boxes][random]") {
  std::size_t all = 0, visited = 0;
  for_each_seed(100, [&](unsigned seed) {
    Mersenne random(seed);
    const Oblique scene = random_oblique(random);
    std::vector<std::vector<Box>> corners;
    std::vector<Box> boxes;
    for (const auto& item : scene.items) {
      auto& list = corners.emplace_back();
      Box& box = boxes.emplace_back();
      for (const auto& p : item) {
        // Bounds of a coordinate that is known to a few digits less.
        Box around{p, p};
        if (seed % 3 == 0) {
          for (std::size_t k = 0; k < 3; ++k) {
            around.lo[k] -= std::fabs(p[k]) * 1e-15 * integer(random, 0, 2);
            around.hi[k] += std::fabs(p[k]) * 1e-15 * integer(random, 0, 2);
          }
        }
        list.push_back(around);
        box.extend(around);
      }
    }
    BoxPairs pairs(boxes);
    if (pairs.crowded()) {
      pairs.orient(boxes, [&](std::uint32_t i, BoxPairs::Outline& out) { out.corners = corners[i]; });
    }
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    for (std::size_t part = 0; part < pairs.part_count(); ++part) {
      pairs.find(part, [&](std::uint32_t x, std::uint32_t y) {
        CHECK(found.insert(std::minmax(pairs.item(x), pairs.item(y))).second);
      });
    }
    for (const auto& pair : scene.meeting) CHECK(found.count(pair) == 1);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      std::set<std::uint32_t> around;
      pairs.query(corners[i][0], [&](std::uint32_t j) { around.insert(j); });
      CHECK(around.count(i) == 1);
    }
    all += boxes.size();
    visited += found.size();
  });
  CHECK(visited < 40 * all);
}

TEST_CASE("items of one group are mostly no pairs, and nothing else is left out", "[boxes][random]") {
  std::size_t shared = 0, kept = 0;
  for_each_seed(100, [&](unsigned seed) {
    Mersenne random(seed);
    const int n = integer(random, 40, 300);
    std::vector<Box> boxes;
    std::vector<std::array<std::uint32_t, 3>> groups;
    for (int i = 0; i < n; ++i) {  // all through the origin
      const std::array<double, 3> p{real(random, 1, 2), real(random, 1, 2), real(random, 1, 2)};
      boxes.push_back({{0, 0, 0}, p});
      auto& own = groups.emplace_back();
      own.fill(BoxPairs::kNoGroup);
      for (std::uint32_t& group : own) {
        if (integer(random, 0, 1) != 0) group = static_cast<std::uint32_t>(integer(random, 0, i < n / 2 ? 1 : 3));
      }
    }
    BoxPairs pairs(boxes);
    REQUIRE(pairs.crowded());
    pairs.orient(boxes, [&](std::uint32_t i, BoxPairs::Outline& out) {
      out = {{Box{{0, 0, 0}, {0, 0, 0}}, Box{boxes[i].hi, boxes[i].hi}}, groups[i]};
    });
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    for (std::size_t part = 0; part < pairs.part_count(); ++part) {
      pairs.find(part, [&](std::uint32_t x, std::uint32_t y) {
        found.insert(std::minmax(pairs.item(x), pairs.item(y)));
      });
    }
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
        bool common = false;
        for (const std::uint32_t g : groups[i]) {
          common = common || (g != BoxPairs::kNoGroup && std::count(groups[j].begin(), groups[j].end(), g) != 0);
        }
        if (!common) CHECK(found.count({i, j}) == 1);
        shared += common;
        kept += common && found.count({i, j}) == 1;
      }
    }
  });
  CHECK(kept < shared / 2);
}

TEST_CASE("a plane as a filter: what it decides is right", "[filter][random]") {
  std::size_t decided = 0, all = 0;
  for_each_seed(2000, [&](unsigned seed) {
    Mersenne random(seed);
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
Soup fan(Mersenne& random, int n, int turns, double steep) {
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

TEST_CASE("a plane of points that are known up to a width: what the filter decides is right", "[filter][random]") {
  std::size_t decided = 0, all = 0;
  for_each_seed(2000, [&](unsigned seed) {
    Mersenne random(seed);
    PointTable table;
    std::vector<std::array<double, 3>> low;
    double width = 0;
    const Rational grain = fraction(1, std::int64_t{1} << integer(random, 1, 60));
    for (int i = 0; i < 4; ++i) {
      RationalPoint p;
      for (Rational& x : p) x = from_double(real(random, -1, 1)) + grain * integer(random, 0, 9) / 7;
      if (i == 3 && seed % 2 == 0) {  // near the plane
        const Rational s = from_double(real(random, -2, 2)), t = from_double(real(random, -2, 2));
        for (std::size_t k = 0; k < 3; ++k) {
          const Rational a = table.rational(VertexId(0))[k];
          p[k] = a + s * (table.rational(VertexId(1))[k] - a) + t * (table.rational(VertexId(2))[k] - a) +
                 grain * integer(random, -3, 3) / 1000;
        }
      }
      const VertexId v = table.add(p);
      low.push_back({table.lower(v)[0], table.lower(v)[1], table.lower(v)[2]});
      // Wider than need be at times.
      for (double& x : low.back()) {
        if (seed % 3 == 0) x -= std::ldexp(real(random, 0, 1), -integer(random, 10, 50));
      }
      for (int k = 0; k < 3; ++k) {
        width = std::max(width, (table.upper(v, k) - low.back()[static_cast<std::size_t>(k)]) * (1 + 1e-15));
      }
    }
    const PlaneFilter filter(low[0].data(), low[1].data(), low[2].data(), width);
    const int exact = orient3d(view_of(table.exact(VertexId(0))), view_of(table.exact(VertexId(1))),
                               view_of(table.exact(VertexId(2))), view_of(table.exact(VertexId(3))));
    ++all;
    if (const int side = filter.side(low[3].data(), width); side != kUndecided) {
      CHECK(side == exact);
      ++decided;
    }
    const ExactPlane plane = table.exact_plane(table.add_plane(VertexId(0), VertexId(1), VertexId(2)));
    const std::array<Rational, 3> normal{Rational(plane.a), Rational(plane.b), Rational(plane.c)};
    for (int k = 0; k < 3; ++k) {
      if (const int s = filter.normal_sign(k)) CHECK(s == sgn(normal[static_cast<std::size_t>(k)]));
    }
    const std::array<double, 3> d{real(random, -1, 1), real(random, -1, 1), real(random, -1, 1)};
    if (const int s = filter.side_of_normal(d)) {
      CHECK(s == sgn(Rational(normal[0] * from_double(d[0]) + normal[1] * from_double(d[1]) +
                              normal[2] * from_double(d[2]))));
    }
  });
  CHECK(4 * decided > all);
}

TEST_CASE("an embedded fan meets itself in nothing but what its triangles share", "[fans][random]") {
  std::size_t embedded = 0, crossing = 0, all = 0;
  for_each_seed(600, [&](unsigned seed) {
    Mersenne random(seed);
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

/// Do two triangles of a fan, refined alone, meet in nothing but corners and sides that they share?
bool share_only(const Soup& soup, std::uint32_t f, std::uint32_t g) {
  Soup pair;
  const LeafId leaf = pair.add_leaf(Fill::none);
  std::set<std::uint32_t> corners;
  for (const std::uint32_t face : {f, g}) {
    std::array<PointId, 3> c;
    for (std::size_t i = 0; i < 3; ++i) {
      const PointId p = soup.corners(SourceId(face))[i];
      corners.insert(p.value());
      const double* x = soup.xyz(p);
      c[i] = pair.add_point(x[0], x[1], x[2]);
    }
    pair.add_triangle(leaf, c[0], c[1], c[2], face, face);
  }
  RefineReport report;
  RefineOptions alone;
  alone.threads = 1;  // a pair is no work for several
  const auto built_complex = build_complex(pair, alone, &report);
  return built_complex->vertex_count() == corners.size() && built_complex->edge_count() == corners.size() + 1;
}

TEST_CASE("a large fan that looks anywhere meets itself in nothing but what its triangles share",
          "[fans][random]") {
  std::size_t embedded = 0, crossing = 0, all = 0;
  for_each_seed(24, [&](unsigned seed) {
    Mersenne random(seed);
    const int turns = seed % 4 == 0 ? 2 : 1, n = integer(random, 66 * turns, 70 * turns);
    const Soup upright = fan(random, n, turns, seed % 3 == 0 ? 0.2 : 0.01);
    // Turned so that no axis sees all triangles from one side: the rim sinks, and the fan is sheared.
    const double steep = real(random, 0.3, 1.5), a = real(random, -1, 1), b = real(random, -1, 1),
                 c = real(random, 1, 3);
    Soup soup;
    const LeafId leaf = soup.add_leaf(Fill::none);
    for (std::uint32_t i = 0; i < upright.point_count(); ++i) {
      const double* p = upright.xyz(PointId(i));
      const double z = p[2] + steep * std::hypot(p[0], p[1]);
      soup.add_point(p[0] + c * z, p[1] + a * p[0] + c * z, c * z + b * p[0]);
    }
    for (std::uint32_t f = 0; f < static_cast<std::uint32_t>(n); ++f) {
      const auto t = upright.corners(SourceId(f));
      soup.add_triangle(leaf, t[0], t[1], t[2], f, f);
    }
    RefineReport report;
    const RefineInput input = prepare_input(soup, report);
    std::vector<char> fans = embedded_fans(input);
    const LargeFans large(input, fans);
    bool apart = true;
    for (std::uint32_t f = 0; apart && f < static_cast<std::uint32_t>(n); ++f) {
      for (std::uint32_t g = 0; apart && g < f; ++g) apart = share_only(soup, f, g);
    }
    const VertexId middle = input.vertex_of[0];
    if (large.at(middle)) {
      CHECK(apart);
      CHECK(fans[middle.index()] == 1);
      CHECK(large.neighbours().size() == static_cast<std::size_t>(n));
    }
    embedded += large.at(middle);
    crossing += !apart;
    ++all;
  });
  CHECK(5 * embedded > all);
  CHECK(10 * crossing > all);
}

}  // namespace
}  // namespace cnrg::scenes
