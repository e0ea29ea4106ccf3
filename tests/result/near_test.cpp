// What is near, against all pairs: squared distances of points by CGAL, of segments by their normal equations.
#include "csg/result/near.h"

#include "csg/result/part_text.h"
#include "kernel/base/error.h"
#include "kernel/exact/distance.h"
#include "kernel/exact/exact_vectors.h"
#include "tests/catch.h"
#include "tests/result/near_scenes.h"
#include "tests/scenes/seeds.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

using Index = Parts::Index;

Rational to_segment(const RationalPoint& p, const RationalPoint& a, const RationalPoint& b) {
  const std::array<RationalPoint, 2> ends{a, b};
  const std::array<std::array<std::uint32_t, 2>, 1> segment{{{0, 1}}};
  return DistanceTo(ends, {}, segment, {}).squared(p);
}

/// By Cramer's rule for the places along both that minimize the square of their distance; else the nearest end.
Rational of_segments(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
                     const RationalPoint& d) {
  Rational least = std::min({to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b)});
  const RationalPoint u = b - a, v = d - c, w = a - c;
  const Rational uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const Rational determinant = uu * vv - uv * uv;
  if (determinant == 0) return least;
  const Rational s = (uv * vw - vv * uw) / determinant, t = (uu * vw - uv * uw) / determinant;
  if (s < 0 || s > 1 || t < 0 || t > 1) return least;
  const RationalPoint apart = w + s * u - t * v;
  return std::min<Rational>(least, dot(apart, apart));
}

bool is_end(const std::array<Index, 2>& ends, Index p) { return ends[0] == p || ends[1] == p; }

/// The least squared distance that pairs have with a part, by kind and number.
std::map<std::array<Index, 3>, Rational> told_by(const std::vector<NearPair>& pairs) {
  std::map<std::array<Index, 3>, Rational> out;
  for (const NearPair& pair : pairs) {
    const RationalPoint d = pair.at_b - pair.at_a;
    CHECK(dot(d, d) == pair.squared);
    CHECK(out.try_emplace({Index(pair.kind), pair.a, pair.b}, pair.squared).second);
  }
  return out;
}

}  // namespace

TEST_CASE("near: pairs of parts against all pairs", "[near][random]") {
  const auto [first, last] = scenes::seeds(12);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    INFO("CNRG_FIRST_SEED=" << seed << " CNRG_SEEDS=1");
    Dice dice(seed + 5'000'000);
    const auto scene = lattice_scene(dice, 3, true);
    const Case c = lattice_case(scene, dice, Rational(1, 10));
    const FlatComplex flat = flatten(c.view());
    const Parts parts(c.view(), flat);
    const auto& x = parts.points();
    const auto& segments = parts.segments();
    const Rational d(1, 3), square = d * d;
    std::vector<NearPair> all;
    for (const Near kind : kNears) {
      const auto pairs = near_pairs(parts, kind, d);
      CHECK(std::is_sorted(pairs.begin(), pairs.end(),
                           [](const NearPair& a, const NearPair& b) { return a.squared < b.squared; }));
      all.insert(all.end(), pairs.begin(), pairs.end());
    }
    const auto told = told_by(all);
    const auto is_told = [&](Near kind, Index a, Index b, const Rational& distance) {
      const auto found = told.find({Index(kind), a, b});
      return found != told.end() && found->second == distance;
    };
    std::size_t near = 0;
    for (Index p = 0; p < x.size(); ++p) {
      for (Index q = p + 1; q < x.size(); ++q) {
        const RationalPoint apart = x[q] - x[p];
        const Rational distance = dot(apart, apart);
        CHECK(told.contains({Index(Near::points), p, q}) == (distance < square));
        if (distance < square) CHECK(is_told(Near::points, p, q, distance));
      }
      for (Index s = 0; s < segments.size(); ++s) {
        const auto& ends = segments[s].ends;
        if (is_end(ends, p)) continue;
        const Rational distance = to_segment(x[p], x[ends[0]], x[ends[1]]);
        if (distance >= square) {
          CHECK(!told.contains({Index(Near::point_segment), p, s}));
          continue;
        }
        ++near;
        const bool by_end = std::any_of(ends.begin(), ends.end(), [&](Index q) {
          return is_told(Near::points, std::min(p, q), std::max(p, q), distance);
        });
        CHECK(is_told(Near::point_segment, p, s, distance) != by_end);
      }
      for (Index f = 0; f < parts.facets().size(); ++f) {
        const auto& corners = parts.facets()[f].corners;
        if (std::binary_search(corners.begin(), corners.end(), p)) continue;
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (const auto& t : parts.triangles()) {
          if (t.facet == f) triangles.push_back(t.corners);
        }
        const Rational distance = DistanceTo(x, {}, {}, triangles).squared(x[p]);
        if (distance >= square) {
          CHECK(!told.contains({Index(Near::point_facet), p, f}));
          continue;
        }
        // If not in the interior, it is nearest to a side or a corner.
        bool by_boundary = false;
        for (const Index q : corners)
          by_boundary = by_boundary || is_told(Near::points, std::min(p, q), std::max(p, q), distance);
        for (Index s = 0; s < segments.size(); ++s)
          by_boundary = by_boundary || is_told(Near::point_segment, p, s, distance);
        CHECK((is_told(Near::point_facet, p, f, distance) || by_boundary));
      }
    }
    for (Index s = 0; s < segments.size(); ++s) {
      for (Index t = s + 1; t < segments.size(); ++t) {
        const auto &a = segments[s].ends, &b = segments[t].ends;
        if (is_end(a, b[0]) || is_end(a, b[1])) continue;
        const Rational distance = of_segments(x[a[0]], x[a[1]], x[b[0]], x[b[1]]);
        if (distance >= square) {
          CHECK(!told.contains({Index(Near::segments), s, t}));
          continue;
        }
        bool by_end = false;
        for (std::size_t k = 0; k < 2; ++k) {
          by_end = by_end || is_told(Near::point_segment, a[k], t, distance) ||
                   is_told(Near::point_segment, b[k], s, distance);
          for (const Index q : b)
            by_end = by_end || is_told(Near::points, std::min(a[k], q), std::max(a[k], q), distance);
        }
        CHECK((is_told(Near::segments, s, t, distance) || by_end));
      }
    }
    // The nearest are the first of all.
    for (const Near kind : kNears) {
      const auto few = nearest_pairs(parts, kind, 5), many = near_pairs(parts, kind, 100);
      REQUIRE(few.size() == std::min<std::size_t>(5, many.size()));
      for (std::size_t i = 0; i < few.size(); ++i) CHECK((few[i].a == many[i].a && few[i].b == many[i].b));
    }
    CHECK(near > 0);
  }
}

TEST_CASE("near: above the diagonal of a face, below its far side, beyond its border", "[near]") {
  Soup soup;
  add_sheet(soup, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  add_point(soup, {2, 2, Rational(1, 1000)});  // above both diagonals
  add_point(soup, {Rational(3, 2), Rational(5, 2), Rational(-1, 500)});
  add_point(soup, {5, 2, 0});
  Case c(soup);
  c.show(c.unite());
  const FlatComplex flat = flatten(c.view());
  const Parts parts(c.view(), flat);
  const auto faces = near_pairs(parts, Near::point_facet, Rational(1, 100));
  REQUIRE(faces.size() == 2);  // each once
  CHECK(faces[0].squared == Rational(1, 1000000));
  CHECK(faces[0].at_b == RationalPoint{2, 2, 0});
  CHECK(faces[1].squared == Rational(1, 250000));
  CHECK(near_pairs(parts, Near::point_segment, 1).empty());  // less, not at most
  const auto side = near_pairs(parts, Near::point_segment, Rational(1001, 1000));
  REQUIRE(side.size() == 1);
  CHECK(side[0].at_b == RationalPoint{4, 2, 0});
}

TEST_CASE("near: coordinates of any size", "[near]") {
  const Rational huge("1000000000000000000000000000000"), tiny(Rational(1) / huge / huge);
  Soup soup;
  add_wire(soup, {huge, 0, 0}, {huge + 1, 0, 0});
  add_wire(soup, {huge, 1, tiny}, {huge + 1, -1, tiny});
  Case c(soup);
  c.show(c.unite());
  const FlatComplex flat = flatten(c.view());
  const Parts parts(c.view(), flat);
  const auto pairs = near_pairs(parts, Near::segments, 2 * tiny);
  REQUIRE(pairs.size() == 1);
  CHECK(pairs[0].squared == tiny * tiny);
  CHECK(near_pairs(parts, Near::segments, tiny).empty());
}

TEST_CASE("near: coordinates as they are told", "[near]") {
  CHECK(coordinates({Rational(1, 2), Rational(1, 3), Rational("123456789/123456791000")}) ==
        "(0.5, 1/3, ~0.0009999999838)");
}
