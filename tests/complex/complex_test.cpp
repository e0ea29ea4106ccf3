// The complex of small scenes: cells counted by hand, radial order, labels, location, the frame, threads.
#include "kernel/complex/complex.h"

#include <cmath>
#include <random>
#include <set>
#include <type_traits>
#include <utility>

#include "kernel/base/error.h"
#include "kernel/complex/draft.h"
#include "tests/catch.h"
#include "tests/scenes/same_arrays.h"

using namespace cnrg;

namespace {

LeafId add_box(Soup& s, double x0, double y0, double z0, double x1, double y1, double z1,
               Fill fill = Fill::winding) {
  const LeafId leaf = s.add_leaf(fill);
  std::vector<PointId> p;
  for (int i = 0; i < 8; ++i) p.push_back(s.add_point(i & 1 ? x1 : x0, i & 2 ? y1 : y0, i & 4 ? z1 : z0));
  const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (std::uint32_t f = 0; f < 6; ++f) {
    std::vector<std::vector<PointId>> loops(1);
    for (const int i : quads[f]) loops[0].push_back(p[static_cast<std::size_t>(i)]);
    s.add_face(leaf, loops, f, f, 0, 1);
  }
  return leaf;
}

/// Adds the box from `low` to `high` to a leaf of solids: `back` behind its faces, `front` before them, at its end
/// in x (face 5) `beyond`. The face `without` is left out (face 4 is the one at its start in x).
void put_solid(Soup& s, LeafId leaf, std::array<double, 3> low, std::array<double, 3> high, std::uint32_t back,
               std::uint32_t front = 0, std::uint32_t beyond = 0, std::uint32_t without = 6) {
  Soup box;
  add_box(box, low[0], low[1], low[2], high[0], high[1], high[2]);
  for (std::uint32_t f = 0; f < 6; ++f) {
    if (f == without) continue;
    std::vector<std::vector<PointId>> loops(1);
    for (const PointId p : box.corners(SourceId(f))) {
      loops[0].push_back(s.add_point(box.xyz(p)[0], box.xyz(p)[1], box.xyz(p)[2]));
    }
    s.add_face(leaf, loops, f, f, f == 5 && beyond != 0 ? beyond : front, back);
  }
}

// Nobody but the builder can write to a complex.
static_assert(std::is_same_v<decltype(build_complex(std::declval<Soup>())), std::shared_ptr<const Complex>>);
static_assert(!std::is_default_constructible_v<Complex>);
static_assert(!std::is_copy_constructible_v<Complex> && !std::is_move_constructible_v<Complex>);
static_assert(!std::is_copy_assignable_v<Complex> && !std::is_move_assignable_v<Complex>);
static_assert(std::is_same_v<decltype(*std::declval<ComplexDraft&>()), const Complex&>);

std::shared_ptr<const Complex> build(const Soup& s) {
  const auto c = build_complex(s);
  REQUIRE(validate(*c) == "");
  return c;
}

std::array<std::size_t, 4> counts(const Complex& c) {
  return {c.vertex_count(), c.edge_count(), c.face_count(), c.region_count};
}

Soup random_soup(unsigned seed) {
  std::mt19937 g(seed);
  const auto r = [&](unsigned n) { return static_cast<double>(g() % n); };
  Soup s;
  for (unsigned i = 0, n = 2 + g() % 4; i < n; ++i) {
    const double x = r(5), y = r(5), z = r(5);
    const double dx = 1 + r(4), dy = 1 + r(4), dz = 1 + r(4);
    add_box(s, x, y, z, x + dx, y + dy, z + dz);
  }
  const LeafId leaf = s.add_leaf(Fill::none);
  const auto point = [&] {
    const double x = r(8), y = r(8), z = r(8);
    return s.add_point(x, y, z);
  };
  for (std::uint32_t i = 0; i < 4; ++i) {
    const PointId a = point(), b = point(), c = point();
    s.add_triangle(leaf, a, b, c, i, i);
    const PointId d = point(), e = point();
    s.add_wire(leaf, d, e, i);
    s.add_isolated(leaf, point());
  }
  return s;
}

/// A torus about the z axis through (x, 0, 0), of 2 * around * across triangles.
void add_torus(Soup& s, double x, unsigned around, unsigned across) {
  const LeafId leaf = s.add_leaf(Fill::winding);
  std::vector<PointId> p;
  for (unsigned i = 0; i < around * across; ++i) {
    const double a = 6.283185307179586 * (i / across) / around, b = 6.283185307179586 * (i % across) / across;
    const double radius = 3 + std::cos(b);
    p.push_back(s.add_point(x + radius * std::cos(a), radius * std::sin(a), std::sin(b)));
  }
  const auto at = [&](unsigned i, unsigned j) { return p[i % around * across + j % across]; };
  for (unsigned i = 0; i < around * across; ++i) {
    const unsigned a = i / across, b = i % across;
    s.add_triangle(leaf, at(a, b), at(a + 1, b), at(a + 1, b + 1), 2 * i, 0, 0, 1);
    s.add_triangle(leaf, at(a, b), at(a + 1, b + 1), at(a, b + 1), 2 * i + 1, 0, 0, 1);
  }
}

/// A band of 2n triangles in n steps, turned by `half_turns`.
void add_band(Soup& s, unsigned n, unsigned half_turns) {
  const LeafId leaf = s.add_leaf(Fill::none);
  std::vector<PointId> p;
  for (unsigned i = 0; i < 2 * n; ++i) {
    const double a = 6.283185307179586 * (i / 2) / n, b = a / 2 * half_turns, side = i % 2 == 0 ? 1 : -1;
    const double radius = 3 + side * std::cos(b);
    p.push_back(s.add_point(radius * std::cos(a), radius * std::sin(a), side * std::sin(b)));
  }
  for (unsigned i = 0; i < n; ++i) {
    const bool swap = i + 1 == n && half_turns % 2 == 1;
    const unsigned next = (i + 1) % n * 2;
    const PointId c = p[next + (swap ? 1 : 0)], d = p[next + (swap ? 0 : 1)];
    s.add_triangle(leaf, p[2 * i], p[2 * i + 1], d, 2 * i, 0);
    s.add_triangle(leaf, p[2 * i], d, c, 2 * i + 1, 0);
  }
}

}  // namespace

TEST_CASE("a soup numbers points and faces as they come, and takes finite coordinates only") {
  Soup s;
  const LeafId leaf = s.add_leaf(Fill::none);
  const PointId a = s.add_point(0, 0, 0), b = s.add_point(1, 0, 0), c = s.add_point(0, 1, 0);
  CHECK(c == PointId(2));
  CHECK(s.add_triangle(leaf, a, b, c, 0, 0) == SourceId(0));
  CHECK(s.add_triangle(leaf, a, c, b, 1, 1) == SourceId(1));
  const std::vector<std::vector<PointId>> loops{{a, b, c}};
  CHECK(s.add_face(leaf, loops, 2, 2) == SourceId(2));
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    CHECK_THROWS_AS(s.add_point(bad, 0, 0), InputError);
    CHECK_THROWS_AS(s.add_point(0, bad, 0), InputError);
    CHECK_THROWS_AS(s.add_point(0, 0, bad), InputError);
  }
}

TEST_CASE("cells of boxes in contact") {
  SECTION("one box") {
    Soup s;
    add_box(s, 0, 0, 0, 1, 1, 1);
    REQUIRE(counts(*build(s)) == std::array<std::size_t, 4>{8, 12, 6, 2});
  }
  SECTION("overlapping corners: 6 constructed vertices, 12 edges of each box, of which 3 are cut") {
    Soup s;
    add_box(s, 0, 0, 0, 2, 2, 2);
    add_box(s, 1, 1, 1, 3, 3, 3);
    REQUIRE(counts(*build(s)) == std::array<std::size_t, 4>{22, 36, 18, 4});
  }
  SECTION("a common face, edge, vertex") {
    Soup face, edge, vertex;
    for (Soup* s : {&face, &edge, &vertex}) add_box(*s, 0, 0, 0, 2, 2, 2);
    add_box(face, 2, 0, 0, 3, 2, 2);
    add_box(edge, 2, 2, 0, 3, 3, 2);
    add_box(vertex, 2, 2, 2, 3, 3, 3);
    REQUIRE(counts(*build(face)) == std::array<std::size_t, 4>{12, 20, 11, 3});
    REQUIRE(counts(*build(edge)) == std::array<std::size_t, 4>{14, 23, 12, 3});
    REQUIRE(counts(*build(vertex)) == std::array<std::size_t, 4>{15, 24, 12, 3});
  }
  SECTION("nested three deep: shells joined by rays") {
    Soup s;
    for (int i = 0; i < 3; ++i) add_box(s, i, i, i, 9 - i, 9 - i, 9 - i);
    const auto built_c = build(s);
    const Complex& c = *built_c;
    REQUIRE(c.region_count == 4);
    std::multiset<std::size_t> labels;
    for (const RegionId r : IdRange<RegionId>(c.region_count)) labels.insert(c.labels(r).size());
    REQUIRE(labels == std::multiset<std::size_t>{0, 1, 2, 3});
  }
}

TEST_CASE("radial order about an edge of many half-planes") {
  Soup s;
  const LeafId leaf = s.add_leaf(Fill::none);
  const PointId a = s.add_point(0, 0, 0), b = s.add_point(0, 0, 1);
  // In no order, with two coplanar pairs.
  const double around[7][2] = {{1, 0}, {-1, 1}, {-1, 0}, {2, 1}, {-2, -1}, {1, -3}, {1, 5}};
  for (std::uint32_t i = 0; i < 7; ++i) {
    const PointId p = s.add_point(around[i][0], around[i][1], 0.5);
    if (i % 2 == 0) s.add_triangle(leaf, a, b, p, i, i);
    else s.add_triangle(leaf, b, a, p, i, i);
  }
  const auto built_c = build(s);
  const Complex& c = *built_c;
  const auto counted = std::find_if(c.edge_ends.begin(), c.edge_ends.end(), [&](const auto& ends) {
    return c.points.approx(ends[0])[0] == 0 && c.points.approx(ends[1])[0] == 0 &&
           c.points.approx(ends[0])[1] == 0 && c.points.approx(ends[1])[1] == 0;
  });
  REQUIRE(counted != c.edge_ends.end());
  const EdgeId e(static_cast<std::size_t>(counted - c.edge_ends.begin()));
  const auto uses = c.edge_uses[e];
  REQUIRE(uses.size() == 7);
  // Seen with the edge (it runs along +z) towards the viewer, angles about z must ascend, but for one wrap.
  std::vector<double> angles;
  for (const FaceUse& u : uses) {
    for (const HalfEdge h : c.loop[c.face_loops[u.face][0]]) {
      const auto p = c.points.approx(c.origin(h));
      if (p[0] != 0 || p[1] != 0) angles.push_back(std::atan2(p[1], p[0]));
    }
  }
  REQUIRE(angles.size() == 7);
  int wraps = 0;
  for (std::size_t i = 0; i < 7; ++i) wraps += angles[(i + 1) % 7] < angles[i] ? 1 : 0;
  REQUIRE(wraps == 1);
}

TEST_CASE("labels by fill") {
  SECTION("winding and parity where a leaf overlaps itself") {
    for (const Fill fill : {Fill::winding, Fill::parity}) {
      Soup s;
      const LeafId leaf = s.add_leaf(fill);
      for (const double x : {0.0, 1.0}) {
        Soup box;
        add_box(box, x, 0, 0, x + 2, 2, 2);
        std::vector<PointId> p;
        for (std::size_t i = 0; i < box.point_count(); ++i) {
          const double* at = box.xyz(PointId(i));
          p.push_back(s.add_point(at[0], at[1], at[2]));
        }
        for (std::size_t f = 0; f < box.face_count(); ++f) {
          std::vector<std::vector<PointId>> loops(1);
          for (const PointId i : box.corners(SourceId(f))) loops[0].push_back(p[i.index()]);
          s.add_face(leaf, loops, static_cast<std::uint32_t>(f), 0);
        }
      }
      const auto built_c = build(s);
      const Complex& c = *built_c;
      REQUIRE(c.region_count == 4);
      std::size_t filled = 0;
      for (const RegionId r : IdRange<RegionId>(c.region_count)) filled += c.labels(r).size();
      REQUIRE(filled == (fill == Fill::winding ? 3 : 2));
    }
  }
  SECTION("cells: every cavity is a region") {
    Soup s;
    const LeafId leaf = add_box(s, 0, 0, 0, 2, 2, 2, Fill::cells);
    const std::vector<std::vector<PointId>> wall{
        {s.add_point(1, 0, 0), s.add_point(1, 2, 0), s.add_point(1, 2, 2), s.add_point(1, 0, 2)}};
    s.add_face(leaf, wall, 6, 6);
    const auto built_c = build(s);
    const Complex& c = *built_c;
    REQUIRE(c.leaf_regions[leaf] == 2);
  }
  SECTION("solids: each is a region, whether or not they share the face between them") {
    for (const bool shared : {true, false}) {
      Soup s;
      const LeafId leaf = s.add_leaf(Fill::solids);
      put_solid(s, leaf, {0, 0, 0}, {1, 1, 1}, 1, 0, shared ? 2 : 0);
      put_solid(s, leaf, {1, 0, 0}, {2, 1, shared ? 1.0 : 2.0}, 2, 0, 0, shared ? 4 : 6);
      const auto built_c = build(s);
      const Complex& c = *built_c;
      REQUIRE(c.region_count == 3);
      REQUIRE(c.leaf_regions[leaf] == 2);
      std::set<std::uint32_t> labels;
      for (const RegionId r : IdRange<RegionId>(c.region_count)) {
        REQUIRE(c.labels(r).size() <= 1);
        for (const Label& label : c.labels(r)) labels.insert(label.region);
      }
      REQUIRE(labels == std::set<std::uint32_t>{1, 2});
    }
  }
  SECTION("solids: one in the cavity of another, its own faces turned inside out") {
    Soup s;
    const LeafId leaf = s.add_leaf(Fill::solids);
    put_solid(s, leaf, {0, 0, 0}, {9, 9, 9}, 1);
    put_solid(s, leaf, {1, 1, 1}, {8, 8, 8}, 0, 1);
    put_solid(s, leaf, {2, 2, 2}, {3, 3, 3}, 0, 2);
    const auto built_c = build(s);
    const Complex& c = *built_c;
    REQUIRE(c.region_count == 4);
    std::multiset<std::size_t> labelled;
    for (const RegionId r : IdRange<RegionId>(c.region_count)) labelled.insert(c.labels(r).size());
    REQUIRE(labelled == std::multiset<std::size_t>{0, 0, 1, 1});
  }
  SECTION("solids that overlap are named") {
    Soup s;
    const LeafId leaf = s.add_leaf(Fill::solids);
    put_solid(s, leaf, {0, 0, 0}, {2, 2, 2}, 1);
    put_solid(s, leaf, {1, 1, 1}, {3, 3, 3}, 3);
    REQUIRE_THROWS_AS(build_complex(s), InputError);
    REQUIRE_THROWS_WITH(build_complex(s), Catch::StartsWith("leaf 0, solid 1, solid 3: these solids overlap"));
  }
  SECTION("solids must close, each by itself") {
    Soup s;
    const LeafId leaf = s.add_leaf(Fill::solids);
    put_solid(s, leaf, {0, 0, 0}, {1, 1, 1}, 1, 0, 0, 5);
    put_solid(s, leaf, {1, 0, 0}, {2, 1, 1}, 2);
    REQUIRE_THROWS_WITH(build_complex(s), Catch::Contains("leaf 0") && Catch::Contains("do not close"));
  }
  SECTION("sides that contradict each other name both faces") {
    Soup s;
    const LeafId leaf = s.add_leaf(Fill::sides);
    const PointId p[4] = {s.add_point(0, 0, 0), s.add_point(1, 0, 0), s.add_point(0, 1, 0), s.add_point(0, 0, 1)};
    s.add_triangle(leaf, p[0], p[2], p[1], 0, 0, 0, 1);
    s.add_triangle(leaf, p[0], p[1], p[3], 1, 1, 0, 1);
    s.add_triangle(leaf, p[0], p[3], p[2], 2, 2, 0, 1);
    s.add_triangle(leaf, p[1], p[2], p[3], 3, 3, 0, 2);
    REQUIRE_THROWS_AS(build_complex(s), InputError);
    REQUIRE_THROWS_WITH(build_complex(s), Catch::Contains("leaf 0, face 3") && Catch::Contains("region 2"));
  }
  SECTION("an open leaf has no inside") {
    Soup s;
    const LeafId leaf = s.add_leaf(Fill::winding);
    s.add_triangle(leaf, s.add_point(0, 0, 0), s.add_point(1, 0, 0), s.add_point(0, 1, 0), 0, 0);
    REQUIRE_THROWS_WITH(build_complex(s), Catch::Contains("leaf 0") && Catch::Contains("fill: none"));
  }
  SECTION("a face that is not planar is named") {
    Soup s;
    const LeafId leaf = s.add_leaf(Fill::none);
    const std::vector<std::vector<PointId>> loops{
        {s.add_point(0, 0, 0), s.add_point(1, 0, 0), s.add_point(1, 1, 1e-300), s.add_point(0, 1, 0)}};
    s.add_face(leaf, loops, 4, 4);
    REQUIRE_THROWS_WITH(build_complex(s), Catch::Contains("leaf 0, face 4") && Catch::Contains("not planar"));
  }
}

TEST_CASE("location: every cell of random scenes holds its own interior point") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    const auto built_c = build(random_soup(seed));
    const Complex& c = *built_c;
    const Locator locator(c);
    for (const VertexId v : c.vertices) {
      const Location at = locator.locate(c.points.rational(v));
      REQUIRE(at.dimension == 0);
      REQUIRE(at.vertex == v);
    }
    for (const EdgeId e : IdRange<EdgeId>(c.edge_count())) {
      const Location at = locator.locate(interior_point(c, e).rational());
      REQUIRE(at.dimension == 1);
      REQUIRE(at.edge == e);
    }
    for (const FaceId f : IdRange<FaceId>(c.face_count())) {
      const RationalPoint p = interior_point(c, f).rational();
      const Location at = locator.locate(p);
      REQUIRE(at.dimension == 2);
      REQUIRE(at.face == f);
      // A little along the normal to both sides: the regions of the face (the step shrinks until it is in one).
      const ExactPlane& plane = c.points.exact_plane(c.plane(f));
      for (int side = 0; side < 2; ++side) {
        Location beside;
        Rational step(side == 0 ? 1 : -1, 1000000);
        RationalPoint q{p[0] + step * Rational(plane.a), p[1] + step * Rational(plane.b),
                        p[2] + step * Rational(plane.c)};
        step /= 1000000000;
        const RationalPoint nearer{p[0] + step * Rational(plane.a), p[1] + step * Rational(plane.b),
                                   p[2] + step * Rational(plane.c)};
        beside = locator.locate(nearer);
        REQUIRE(beside.dimension == 3);
        REQUIRE(beside.region == c.face_regions[f][static_cast<std::size_t>(side)]);
      }
    }
  }
}

TEST_CASE("the same bytes for one thread and for two") {
  for (unsigned seed = 100; seed < 130; ++seed) {
    INFO("seed " << seed);
    const Soup s = random_soup(seed);
    const auto built_one = build_complex(s, {.threads = 1}), built_two = build_complex(s, {.threads = 2});
    const Complex &one = *built_one, &two = *built_two;
    REQUIRE(one.vertices == two.vertices);
    REQUIRE(one.edge_ends.raw() == two.edge_ends.raw());
    REQUIRE(one.edge_uses.values() == two.edge_uses.values());
    REQUIRE(one.loop.values() == two.loop.values());
    REQUIRE(one.face_regions.raw() == two.face_regions.raw());
    REQUIRE(one.region_labels.raw() == two.region_labels.raw());
    REQUIRE(one.region_faces.values() == two.region_faces.values());
    for (const VertexId v : one.vertices) REQUIRE(one.points.exact(v) == two.points.exact(v));
  }
}

TEST_CASE("the same arrays for one thread and for two where loops are long enough for both") {
  Soup s;
  add_torus(s, 0, 64, 32);
  add_torus(s, 2.5, 64, 32);
  add_band(s, 400, 1);
  const auto built_one = build_complex(s, {.threads = 1}), built_two = build_complex(s, {.threads = 2});
  const Complex &one = *built_one, &two = *built_two;
  REQUIRE(scenes::same_arrays(one, two));
  REQUIRE(validate(one) == "");
}

TEST_CASE("a band of one side and a band of two") {
  for (const unsigned half_turns : {0u, 1u, 2u, 3u}) {
    INFO("half turns " << half_turns);
    Soup s;
    add_band(s, 24, half_turns);
    const auto built_c = build(s);
    const Complex& c = *built_c;
    REQUIRE(counts(c) == std::array<std::size_t, 4>{48, 96, 48, 1});
    REQUIRE(c.region_faces[RegionId(0)].size() == 96);
  }
}

TEST_CASE("a half-space in its frame") {
  // z <= 0 as half-space, a box around the origin; the frame is [-8, 8]^3 with the seed at its lowest corner.
  Soup s;
  add_box(s, -1, -1, -1, 1, 1, 1);
  const LeafId below = s.add_leaf(Fill::sides);
  const std::vector<std::vector<PointId>> square{
      {s.add_point(-8, -8, 0), s.add_point(8, -8, 0), s.add_point(8, 8, 0), s.add_point(-8, 8, 0)}};
  s.add_face(below, square, 0, 0, 0, 1);
  const LeafId frame = add_box(s, -8, -8, -8, 8, 8, 8, Fill::none);
  s.set_frame(frame, s.add_point(-8, -8, -8), {{below, 1u}});
  const auto built_c = build(s);
  const Complex& c = *built_c;
  const Locator locator(c);
  const auto labels = [&](int x, int y, int z) {
    const Location at = locator.locate({Rational(x, 2), Rational(y, 2), Rational(z, 2)});
    REQUIRE(at.dimension == 3);
    std::vector<std::uint32_t> list;
    for (const Label& l : c.labels(at.region)) list.push_back(l.leaf.value());
    return list;
  };
  REQUIRE(labels(5, 5, 5).empty());
  REQUIRE(labels(5, 5, -5) == std::vector<std::uint32_t>{1});
  REQUIRE(labels(1, 1, 1) == std::vector<std::uint32_t>{0});
  REQUIRE(labels(1, 1, -1) == std::vector<std::uint32_t>{0, 1});
  REQUIRE(c.unbounded(locator.locate({5, 5, 5}).region));
  REQUIRE(c.unbounded(locator.locate({5, 5, -5}).region));
  REQUIRE_FALSE(c.unbounded(locator.locate({Rational(1, 2), Rational(1, 2), Rational(1, 2)}).region));
}
