// Extrusions on one surface: the same rulings, so what fits fits, at any fineness and any extent.
#include "csg/carriers/nets.h"
#include "csg/curves/extrude.h"
#include "csg/operators/boolean.h"
#include "kernel/complex/complex.h"
#include "kernel/selection/measure.h"
#include "tests/carriers/nets_scenes.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

/// A closed line of curves; each begins where the one before it ends.
using Loop = std::vector<Row4>;

/// A profile about the origin, star-shaped: `count` curves of degree 1 to 3.
Loop random_loop(std::mt19937& random, int count) {
  // Corners of a regular hexagon or square, nearly, so that lines between do not cross.
  const std::vector<RationalPoint> corners =
      count == 4
          ? std::vector<RationalPoint>{{4, 0, 0}, {0, 4, 0}, {-4, 0, 0}, {0, -4, 0}}
          : std::vector<RationalPoint>{{4, 0, 0}, {2, 3, 0}, {-2, 3, 0}, {-4, 0, 0}, {-2, -3, 0}, {2, -3, 0}};
  Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const RationalPoint &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const int degree = pick(random, 1, 3);
    Row4 row;
    for (int k = 0; k <= degree; ++k) {
      const Rational t = ratio(k, degree), w = k == 0 || k == degree ? Rational(1) : ratio(pick(random, 2, 5), 3);
      const Rational out = k == 0 || k == degree ? Rational(1) : 1 + ratio(pick(random, 0, 3), 8);
      Point4 p{0, 0, 0, w};
      for (std::size_t e = 0; e < 3; ++e) p[e] = w * out * ((1 - t) * a[e] + t * b[e]);
      row.push_back(p);
    }
    loop.push_back(row);
  }
  return loop;
}

/// Each curve moved along the vector by its own linear height, so that corners fit: a slanted profile.
Loop lifted(const Loop& loop, const RationalPoint& by) {
  Loop result = loop;
  for (Row4& row : result) {
    for (Point4& p : row) {
      for (std::size_t e = 0; e < 3; ++e) p[e] += p[3] * by[e];
    }
  }
  return result;
}

LeafInstance extrusion(const std::vector<Loop>& loops, bool closed, const RationalPoint& vector,
                       const Tessellation& fineness, const Transform& transform = {}) {
  const Transform back = transform.inverse();
  ExtrudeShape shape;
  shape.profile.closed = closed;
  for (const Loop& loop : loops) {
    ProfileLine& line = shape.profile.lines.emplace_back();
    for (const Row4& row : loop) line.segments.push_back(curve_net(row, back));
  }
  shape.vector = back.apply(vector) - back.apply({0, 0, 0});
  shape.tessellation = fineness;
  return placed(shape, transform);
}

const RationalPoint kUp{0, 0, 1};

}  // namespace

TEST_CASE("an extrusion fits into a hole of its own profile, at any fineness, place and extent") {
  const auto [first, last] = scenes::seeds(100);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const Loop loop = random_loop(random, pick(random, 0, 1) ? 4 : 6);
    Loop outer;
    const std::vector<RationalPoint> square{{9, 9, 0}, {-9, 9, 0}, {-9, -9, 0}, {9, -9, 0}};
    for (std::size_t i = 0; i < 4; ++i) {
      Row4 row;
      for (const RationalPoint& p : {square[i], square[(i + 1) % 4]}) row.push_back({p[0], p[1], p[2], 1});
      outer.push_back(row);
    }
    // The plug begins lower or higher than the plate and may run against the vector; its curves are written from
    // another corner, backward, of raised degree.
    Loop plug = lifted(loop, Rational(pick(random, -2, 1)) * kUp);
    std::rotate(plug.begin(), plug.begin() + pick(random, 0, 3), plug.end());
    if (pick(random, 0, 1)) {
      std::reverse(plug.begin(), plug.end());
      for (Row4& row : plug) std::reverse(row.begin(), row.end());
    }
    for (Row4& row : plug) {
      if (pick(random, 0, 2) == 0) row = raised(row);
    }
    const LeafInstance plate =
        extrusion({outer, loop}, true, Rational(2) * kUp, random_fineness(random), random_transform(random));
    const LeafInstance pin = extrusion({plug}, true, Rational(pick(random, 0, 1) ? 3 : 4) * kUp,
                                       random_fineness(random), random_transform(random));
    const std::vector<LeafInstance> both = with_common_nets({plate, pin});
    const Soup soup = make_soup(both);
    const auto complex = build_complex(soup);
    const std::vector<Group> leaves = leaf_groups(*complex);
    CHECK(complex->region_count == 3);  // the plate, the pin and outside: nothing between
    CHECK(boolean_operation(*complex, BooleanOp::intersect, Dominance::equal, leaves[0], leaves[1])
              .group.regions.empty());
    CHECK(volume(soup, LeafId(0)) > 0);
    CHECK(volume(soup, LeafId(1)) > 0);
    // Of the block that is the plate without its hole, the hole has the pin's section.
    const Rational section = 18 * 18 - volume(soup, LeafId(0)) / 2;
    const Rational height = volume(soup, LeafId(1)) / section;
    CHECK((height == 3 || height == 4));
    const std::vector<LeafInstance> back = with_common_nets({pin, plate});
    CHECK(facets(back[0]) == facets(both[1]));
    CHECK(facets(back[1]) == facets(both[0]));
  }
}

TEST_CASE("walls over parts of one curve have common rulings where they overlap") {
  const auto [first, last] = scenes::seeds(150);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const RationalPoint vector{1, pick(random, -1, 1), 3};
    // x is the parameter itself (or a function of it alone), so that pieces of walls have projected lengths.
    Row4 row;
    const int degree = pick(random, 2, 3);
    for (int k = 0; k <= degree; ++k) row.push_back({ratio(k, degree), ratio(pick(random, -4, 4), 5), 0, 1});
    // A flat wall needs no rulings.
    if (row[1][1] - row[0][1] == row[2][1] - row[1][1]) row[1][1] += ratio(1, 5);
    std::vector<std::array<Rational, 2>> on;
    std::vector<LeafInstance> walls;
    for (int k = 0; k < 2; ++k) {
      on.push_back(random_interval(random));
      Row4 part = piece_of(row, on.back()[0], on.back()[1]);
      if (pick(random, 0, 1)) part = raised(part);
      // A curve on the same surface that is not the same curve: lifted by another quadratic along the vector.
      part = raised(part);
      for (std::size_t i = 0; i < part.size(); ++i) {
        const Rational h = ratio(pick(random, -2, 2), 9);
        for (std::size_t e = 0; e < 3; ++e) part[i][e] += part[i][3] * h * vector[e];
      }
      if (pick(random, 0, 1)) std::reverse(part.begin(), part.end());
      walls.push_back(extrusion({{part}}, false, pick(random, 0, 1) ? vector : Rational(2) * vector,
                                random_fineness(random), random_transform(random)));
    }
    const std::vector<LeafInstance> both = with_common_nets(walls);
    const Rational low = std::max(on[0][0], on[1][0]), high = std::min(on[0][1], on[1][1]);
    // Rulings of a wall: seen along the vector, its facets are chords.
    const auto chords = [&](const LeafInstance& wall) {
      std::set<std::array<std::array<Rational, 2>, 2>> result;
      const Soup soup = make_soup({wall});
      for (SourceId f : IdRange<SourceId>(soup.face_count())) {
        std::set<std::array<Rational, 2>> ends;
        const auto face = loops(soup, f);
        for (const RationalPoint& p : face[0]) {
          const Rational t = p[2] / vector[2];
          ends.insert({p[0] - t * vector[0], p[1] - t * vector[1]});
        }
        REQUIRE(ends.size() == 2);
        const std::array<std::array<Rational, 2>, 2> chord{*ends.begin(), *ends.rbegin()};
        if (low <= chord[0][0] && chord[1][0] <= high) result.insert(chord);
      }
      return result;
    };
    const auto a = chords(both[0]), b = chords(both[1]);
    CHECK(a == b);
    Rational length = 0;
    for (const auto& chord : a) length += chord[1][0] - chord[0][0];
    CHECK(length == std::max(Rational(high - low), Rational(0)));
    // The front stays where it was: along y all facets look one way.
    const auto looks_along_y = [](const LeafInstance& wall) {
      const Soup soup = make_soup({wall});
      const std::vector<RationalPoint> corners = loops(soup, SourceId(0))[0];
      return cross(corners[1] - corners[0], corners[2] - corners[0])[1] > 0;
    };
    for (std::size_t i = 0; i < 2; ++i) CHECK(looks_along_y(both[i]) == looks_along_y(walls[i]));
    // Parameters: S(u, v) = p(u) + v t.
    for (std::size_t i = 0; i < 2; ++i) {
      const auto form = std::dynamic_pointer_cast<const ExtrudeForm>(walls[i].leaf->form());
      REQUIRE(form);
      const CurveNet& net = form->shape.profile.lines[0].segments[0];
      Row4 given;
      for (std::size_t k = 0; k < net.points.size(); ++k)
        given.push_back({net.points[k][0] * net.weights[k], net.points[k][1] * net.weights[k],
                         net.points[k][2] * net.weights[k], net.weights[k]});
      const auto parameters = both[i].leaf->parameters()();
      for (std::size_t f = 0; f < parameters->facet_count(); ++f) {
        const auto cells = parameters->cells(f);
        for (const PatchCorner& corner : cells.at(0)) {
          const RationalPoint p = point_of(blossom(given, std::vector<Rational>(given.size() - 1, corner.at[0])));
          CHECK(walls[i].transform->apply(p + corner.at[1] * form->shape.vector) ==
                both[i].transform->apply(corner.point));
        }
      }
    }
  }
}

TEST_CASE("a wall of a patch and one of an extrusion are one, and a rim is the side of a patch") {
  std::mt19937 random(21);
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    Row4 row;
    const int degree = pick(random, 2, 3);
    for (int k = 0; k <= degree; ++k) row.push_back({ratio(k, degree), ratio(pick(random, -4, 4), 5), 0, 1});
    const std::array<Rational, 2> on = random_interval(random);
    // A patch over a part of the curve, from height 0 to 2, and one that leans away from the rim.
    const Row4 part = piece_of(row, on[0], on[1]);
    const Rational height = round % 2 == 0 ? 0 : 3;  // of the rim
    Row4 top = part, away = row, on_rim = row;
    for (Point4& p : on_rim) p[2] += height;
    for (Point4& p : top) p[2] += 2;
    for (std::size_t i = 0; i < away.size(); ++i) {
      away[i][2] = height + ratio(pick(random, 5, 7), 2);
      away[i][1] -= 3;
    }
    const auto sheet = [&](const Net4& net) {
      BezierShape shape;
      const Transform transform = random_transform(random);
      shape.patches.push_back(patch_net(written(net, pick(random, 0, 7)), transform.inverse()));
      shape.tessellation = random_fineness(random);
      return placed(shape, transform);
    };
    const LeafInstance wall = extrusion({{row}}, false, Rational(3) * kUp, random_fineness(random));
    const std::vector<LeafInstance> all = with_common_nets({wall, sheet({part, top}), sheet({on_rim, away})});
    const Segments rim = border(all[0]), side = border(all[2]);
    std::size_t common = 0;
    for (const auto& edge : side) {
      if (edge[0][2] != height || edge[1][2] != height) continue;
      CHECK(rim.contains(edge));
      ++common;
    }
    CHECK(common > 0);
    // All of the patch lies on the wall: refined, it parts the wall's facets and makes no others.
    const auto complex = build_complex(make_soup({all[0], all[1]}));
    const std::vector<Group> leaves = leaf_groups(*complex);
    CHECK(boolean_operation(*complex, BooleanOp::subtract, Dominance::equal, leaves[1], leaves[0])
              .group.faces.empty());
  }
}

TEST_CASE("walls that are apart, twisted or scaled stay as they are") {
  std::mt19937 random(2);
  const Loop loop = random_loop(random, 4);
  const LeafInstance low = extrusion({loop}, true, kUp, {std::nullopt, 3});
  const LeafInstance high = extrusion({lifted(loop, Rational(2) * kUp)}, true, kUp, {std::nullopt, 7});
  const LeafInstance on_low = extrusion({lifted(loop, kUp)}, true, kUp, {std::nullopt, 7});
  const std::vector<LeafInstance> apart = with_common_nets({low, high});
  CHECK(apart[0].leaf == low.leaf);
  CHECK(apart[1].leaf == high.leaf);
  const std::vector<LeafInstance> stacked = with_common_nets({low, on_low});
  CHECK(stacked[0].leaf != low.leaf);
  CHECK(stacked[1].leaf != on_low.leaf);
  CHECK(build_complex(make_soup(stacked))->region_count == 3);
  ExtrudeShape twisted = std::dynamic_pointer_cast<const ExtrudeForm>(low.leaf->form())->shape;
  twisted.twist = 30;
  CHECK(prepare(twisted)->form() == nullptr);
  twisted.twist = 0;
  twisted.scale = 2;
  CHECK(prepare(twisted)->form() == nullptr);
}
