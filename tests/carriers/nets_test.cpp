// Sheets and wires of different leaves on one surface or curve: where they overlap they are one set of facets.
#include "csg/carriers/nets.h"

#include "kernel/complex/complex.h"
#include "tests/carriers/nets_scenes.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

LeafInstance sheet(const Net4& net, const Tessellation& fineness, const Transform& transform = {},
                   const Rational& factor = 1) {
  BezierShape shape;
  shape.patches.push_back(patch_net(net, transform.inverse(), factor));
  shape.tessellation = fineness;
  return placed(shape, transform);
}
LeafInstance wire(const Row4& row, const Tessellation& fineness, const Transform& transform = {}) {
  BezierShape shape;
  shape.curves.push_back(curve_net(row, transform.inverse()));
  shape.tessellation = fineness;
  return placed(shape, transform);
}

bool inside(const Rectangle& r, const Parameters& p) {
  return r[0][0] <= p[0] && p[0] <= r[0][1] && r[1][0] <= p[1] && p[1] <= r[1][1];
}

/// The facets of a leaf of one patch whose cells lie in the rectangle; each corner is S(u, v).
Facets facets_in(const LeafInstance& instance, const Net4& net, const Rectangle& r) {
  const Soup soup = make_soup({instance});
  const auto parameters = instance.leaf->parameters()();
  REQUIRE(parameters->facet_count() == soup.face_count());
  Facets result;
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    const auto cells = parameters->cells(f);
    REQUIRE(cells.size() == 1);
    bool all = true;
    for (const PatchCorner& corner : cells[0]) {
      REQUIRE(at(net, corner.at[0], corner.at[1]) == instance.transform->apply(corner.point));
      all = all && inside(r, corner.at);
    }
    if (!all) continue;
    std::vector<RationalPoint> corners = loops(soup, SourceId(f))[0];
    std::sort(corners.begin(), corners.end());
    result.insert(corners);
  }
  return result;
}

}  // namespace

TEST_CASE("a patch and its sub-patch have the same facets where they overlap, however both are written") {
  const auto [first, last] = scenes::seeds(120);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const bool graph = pick(random, 0, 2) > 0;
    const int m = pick(random, 1, 3), n = pick(random, m == 1 ? 2 : 1, 3);
    const Net4 net = graph ? random_graph(random, m, n) : random_rational(random, m, n);
    const Rectangle r{random_interval(random), random_interval(random)};
    const Net4 part =
        raised(written(piece_of(net, r), pick(random, 0, 7)), pick(random, 0, 1), pick(random, 0, 2));
    const LeafInstance a = sheet(net, random_fineness(random), random_transform(random));
    const LeafInstance b =
        sheet(part, random_fineness(random), random_transform(random), ratio(pick(random, 1, 4), 3));
    const std::vector<LeafInstance> both = with_common_nets({a, b});
    const Facets of_a = facets(both[0]), of_b = facets(both[1]);
    CHECK(contains(of_a, of_b));
    CHECK(facets_in(both[0], net, r) == of_b);
    facets_in(both[1], part, {});  // its own parameters are right, too
    if (graph) {
      CHECK(double_area(of_a) == 2);
      CHECK(double_area(of_b) == 2 * (r[0][1] - r[0][0]) * (r[1][1] - r[1][0]));
    }
    const std::vector<LeafInstance> back = with_common_nets({b, a});
    CHECK(facets(back[0]) == of_b);
    CHECK(facets(back[1]) == of_a);
    // The front stays where it was.
    for (std::size_t i = 0; i < 2 && graph; ++i) {
      const auto up = [](const LeafInstance& sheet) {
        const Soup soup = make_soup({sheet});
        const auto corners = loops(soup, SourceId(0))[0];
        return cross(corners[1] - corners[0], corners[2] - corners[0])[2] > 0;
      };
      CHECK(up(both[i]) == up(i == 0 ? a : b));
    }
    // Nothing is cut when they are refined: each facet of the larger one is one face.
    if (graph) CHECK(build_complex(make_soup(both))->face_count() == of_a.size());
  }
}

TEST_CASE("sub-patches of one patch have the same facets where they overlap") {
  const auto [first, last] = scenes::seeds(100);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(static_cast<unsigned>(seed + 10'000));
    const Net4 net = random_graph(random, pick(random, 1, 3), pick(random, 2, 3));
    std::vector<Rectangle> rectangles;
    std::vector<LeafInstance> sheets;
    for (int k = 0; k < 4; ++k) {  // some of them equal
      if (k > 0 && pick(random, 0, 2) == 0) rectangles.push_back(rectangles[static_cast<std::size_t>(k - 1)]);
      else rectangles.push_back({random_interval(random), random_interval(random)});
      sheets.push_back(sheet(written(piece_of(net, rectangles.back()), pick(random, 0, 7)),
                             random_fineness(random), random_transform(random)));
    }
    const std::vector<LeafInstance> all = with_common_nets(sheets);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        Rational area = 2;
        for (std::size_t d = 0; d < 2; ++d) {
          const auto &a = rectangles[i][d], &b = rectangles[j][d];
          const Rational low = std::max(a[0], b[0]), high = std::min(a[1], b[1]);
          area *= std::max(Rational(high - low), Rational(0));
        }
        const Facets of_i = facets(all[i]), of_j = facets(all[j]);
        Facets common;
        std::set_intersection(of_i.begin(), of_i.end(), of_j.begin(), of_j.end(),
                              std::inserter(common, common.end()));
        CHECK(double_area(common) == area);
      }
    }
  }
}

TEST_CASE("a spline agrees with a patch of one of its spans and with its other ways to be written") {
  std::mt19937 random(7);
  for (int round = 0; round < 20; ++round) {
    CAPTURE(round);
    BezierShape spline;
    spline.is_spline = true;
    PatchNet net;
    net.degree = {2, 3};
    for (long j = 0; j < 5; ++j) {
      net.points.emplace_back();
      for (long i = 0; i < 5; ++i) net.points.back().push_back({i, j, ratio(pick(random, -4, 4), 3)});
    }
    net.knots = {std::vector<Rational>{0, 0, 0, 1, 3, 4, 4, 4}, std::vector<Rational>{0, 0, 0, 0, 2, 5, 5, 5, 5}};
    spline.patches.push_back(net);
    spline.tessellation.segments = pick(random, 1, 5);
    const LeafInstance whole = placed(spline);
    // The span from 1 to 3 and from 0 to 2, by the spline's blossom: control point i is f(1 or 3, ...).
    const auto spline_blossom = [](const std::vector<RationalPoint>& row, const std::vector<Rational>& knots,
                                   std::size_t span, const std::vector<Rational>& at) {
      const std::size_t d = at.size();
      std::vector<RationalPoint> p(row.begin() + static_cast<long>(span - d),
                                   row.begin() + static_cast<long>(span + 1));
      for (std::size_t r = 1; r <= d; ++r) {
        for (std::size_t k = d; k >= r; --k) {
          const Rational &low = knots[span - d + k], &high = knots[span + k - r + 1];
          const Rational t = (at[r - 1] - low) / (high - low);
          p[k] = (1 - t) * p[k - 1] + t * p[k];
        }
      }
      return p[d];
    };
    PatchNet span;
    std::vector<std::vector<RationalPoint>> in_u;
    for (const auto& row : net.points) {
      in_u.emplace_back();
      for (const std::vector<Rational>& at : {std::vector<Rational>{1, 1}, {1, 3}, {3, 3}})
        in_u.back().push_back(spline_blossom(row, net.knots[0], 3, at));
    }
    for (std::size_t j = 0; j <= 3; ++j) {
      std::vector<Rational> at(3, 0);
      std::fill(at.begin(), at.begin() + static_cast<long>(j), 2);
      span.points.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        std::vector<RationalPoint> column;
        for (const auto& row : in_u) column.push_back(row[i]);
        span.points.back().push_back(spline_blossom(column, net.knots[1], 3, at));
      }
    }
    BezierShape one;
    one.patches.push_back(span);
    one.tessellation = random_fineness(random);
    const LeafInstance single = placed(one);
    const std::vector<LeafInstance> both = with_common_nets({whole, single});
    CHECK(contains(facets(both[0]), facets(both[1])));
    CHECK(facets(both[1]).size() < facets(both[0]).size());
    CHECK(build_complex(make_soup(both))->face_count() == facets(both[0]).size());
  }
}

TEST_CASE("leaves that share no more than points with others stay as they are") {
  std::mt19937 random(5);
  const Net4 net = random_graph(random, 3, 2);
  const LeafInstance a = sheet(net, {std::nullopt, 4});
  const LeafInstance moved{a.leaf, Transform::translation({ratio(1, 3), 0, ratio(1, 7)})};  // boxes overlap
  const LeafInstance box{prepare(BoxShape{{0, 0, 0}, {1, 1, 1}}), {}};
  const std::vector<LeafInstance> given{a, moved, box, a};
  const std::vector<LeafInstance> same = with_common_nets(given);
  for (std::size_t i = 0; i < given.size(); ++i) {
    CHECK(same[i].leaf == given[i].leaf);
    CHECK(*same[i].transform == *given[i].transform);
  }
  // A fourth one that has a part of the first: both copies of that change, to one leaf.
  const LeafInstance part = sheet(piece_of(net, {{{0, ratio(1, 2)}, {ratio(1, 3), 1}}}), {std::nullopt, 4});
  const std::vector<LeafInstance> changed = with_common_nets({a, moved, box, a, part});
  CHECK(changed[0].leaf != a.leaf);
  CHECK(changed[0].leaf == changed[3].leaf);
  CHECK(changed[1].leaf == a.leaf);
  CHECK(changed[2].leaf == box.leaf);
  CHECK(changed[4].leaf != part.leaf);
  CHECK(changed[0].transform->identity());
}

TEST_CASE("leaves that were tessellated alike already have the facets that they had") {
  std::mt19937 random(9);
  const Net4 net = random_graph(random, 3, 3);
  for (const Tessellation& fineness : {Tessellation{std::nullopt, 5}, Tessellation{ratio(1, 20), std::nullopt}}) {
    const LeafInstance a = sheet(net, fineness), b = sheet(written(net, 6), fineness);
    const std::vector<LeafInstance> both = with_common_nets({a, b});
    CHECK(facets(both[0]) == facets(a));
    CHECK(facets(both[1]) == facets(a));
  }
}

TEST_CASE("patches of different leaves that meet in a curve have its finest steps, also far from any overlap") {
  std::mt19937 random(11);
  for (int round = 0; round < 30; ++round) {
    CAPTURE(round);
    // A row of patches along x; neighbours share a side, and the first is overlapped by a part of itself.
    const int count = 4;
    std::vector<Net4> row{random_graph(random, 2, 3)};
    for (int k = 1; k < count; ++k) {
      Net4 next = random_graph(random, 2, 3);
      for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t i = 0; i < 3; ++i) next[j][i][0] += k;
        next[j][0] = row.back()[j][2];
      }
      row.push_back(next);
    }
    std::vector<LeafInstance> given;
    for (const Net4& net : row)
      given.push_back(sheet(written(net, pick(random, 0, 7)), random_fineness(random), random_transform(random)));
    given.push_back(
        sheet(piece_of(row[0], {{{0, ratio(1, 2)}, {ratio(1, 3), ratio(3, 4)}}}), random_fineness(random)));
    const std::vector<LeafInstance> all = with_common_nets(given);
    for (int k = 1; k < count; ++k) {
      const auto on_side = [&](const LeafInstance& sheet) {
        Segments result;
        for (const auto& edge : border(sheet)) {
          if (edge[0][0] == k && edge[1][0] == k) result.insert(edge);
        }
        return result;
      };
      const Segments left = on_side(all[static_cast<std::size_t>(k - 1)]);
      CHECK(left == on_side(all[static_cast<std::size_t>(k)]));
      // The cuts at 1/3 and 3/4 go through all of them.
      for (const Rational& y : {ratio(1, 3), ratio(3, 4)}) {
        CHECK(std::any_of(left.begin(), left.end(), [&](const auto& e) { return e[0][1] == y || e[1][1] == y; }));
      }
    }
    CHECK(contains(facets(all[0]), facets(all.back())));
  }
}

TEST_CASE("wires have the points of sides and of wires that they run on") {
  std::mt19937 random(13);
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    const Net4 net = round % 2 == 0 ? random_graph(random, 3, 2) : random_rational(random, 3, 2);
    const std::array<Rational, 2> on = random_interval(random);
    Row4 row = piece_of(net[0], on[0], on[1]);
    if (round % 3 == 0) row = raised(row);
    if (round % 5 == 0) std::reverse(row.begin(), row.end());
    const std::vector<LeafInstance> all = with_common_nets(
        {sheet(net, random_fineness(random), random_transform(random)),
         wire(row, random_fineness(random), random_transform(random)), wire(net[0], random_fineness(random))});
    const Segments side = border(all[0]), part = wires(all[1]), whole = wires(all[2]);
    CHECK(std::includes(side.begin(), side.end(), whole.begin(), whole.end()));
    CHECK(std::includes(whole.begin(), whole.end(), part.begin(), part.end()));
    CHECK(!part.empty());
    // Parameters of a wire are those of its own curve.
    const auto parameters = all[1].leaf->parameters()();
    for (std::size_t i = 0; i < parameters->wire_count(); ++i) {
      const LeafParameters::Wire piece = parameters->wire(i);
      for (std::size_t e = 0; e < 2; ++e)
        CHECK(point_of(blossom(row, std::vector<Rational>(row.size() - 1, piece.at[e]))) == piece.ends[e]);
    }
  }
}

TEST_CASE("the finest of segments and chord is taken on both") {
  std::mt19937 random(17);
  const Net4 net = random_graph(random, 2, 2);
  const auto count = [&](const Tessellation& a, const Tessellation& b) {
    const std::vector<LeafInstance> both = with_common_nets({sheet(net, a), sheet(net, b)});
    CHECK(facets(both[0]) == facets(both[1]));
    return facets(both[0]).size();
  };
  const Tessellation six{std::nullopt, 6}, ten{std::nullopt, 10}, coarse{2, std::nullopt};
  CHECK(count(six, six) == 72);
  CHECK(count(six, ten) == 200);
  CHECK(count(ten, six) == 200);
  CHECK(count(coarse, six) == 128);  // with a chord steps are powers of two: 8
  const Tessellation fine{ratio(1, 100), std::nullopt};
  CHECK(count(fine, six) >= facets(sheet(net, fine)).size());
}

TEST_CASE("curves that would cut each other for ever are refused") {
  // v = 1 runs on the first half of the side v = 0.
  const Row4 whole{{0, 0, 0, 1}, {1, 2, 0, 1}, {2, 0, 0, 1}};
  const Net4 net{whole, piece_of(whole, 0, ratio(1, 2))};
  const LeafInstance a = sheet(net, {std::nullopt, 2}), b = wire(whole, {std::nullopt, 2});
  CHECK_THROWS_WITH(with_common_nets({b, a}), Catch::Contains("leaf ") &&
                                                  Catch::Contains(": curves that it shares") &&
                                                  Catch::Contains("cut that patch there"));
}

TEST_CASE("a patch with a pole agrees with its parts, those at the pole and those away from it") {
  // An eighth of a sphere: v = 1 is one point.
  const Net4 net{{{1, 0, 0, 1}, {1, 1, 0, 1}, {0, 2, 0, 2}},
                 {{1, 0, 1, 1}, {1, 1, 1, 1}, {0, 2, 2, 2}},
                 {{0, 0, 2, 2}, {0, 0, 2, 2}, {0, 0, 4, 4}}};
  std::mt19937 random(23);
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    Rectangle r{random_interval(random), random_interval(random)};
    if (round % 2 == 0) r[1][1] = 1;
    const LeafInstance whole = sheet(net, random_fineness(random), random_transform(random)),
                       part = sheet(written(piece_of(net, r), pick(random, 0, 7)), random_fineness(random),
                                    random_transform(random));
    const std::vector<LeafInstance> both = with_common_nets({whole, part});
    const Facets of_whole = facets(both[0]), of_part = facets(both[1]);
    CHECK(contains(of_whole, of_part));
    // The border has no gaps: each of its points has two edges.
    for (const LeafInstance& leaf : both) {
      std::map<RationalPoint, int> ends;
      for (const auto& edge : border(leaf)) {
        ++ends[edge[0]];
        ++ends[edge[1]];
      }
      for (const auto& [point, count] : ends) CHECK(count == 2);
    }
    for (const auto& facet : of_whole) {
      for (const RationalPoint& p : facet) CHECK(dot(p, p) == 1);
    }
  }
}

TEST_CASE("patches that have nothing but a pole in common share nothing") {
  const auto fan = [](long side) {
    // From a point to a curve on one side of it.
    const Row4 pole(3, Point4{0, 0, 0, 1});
    return Net4{pole,
                {{side, 0, 1, 1}, {side, 2, 2, 1}, {side, 3, 0, 1}},
                {{2 * side, 0, 0, 1}, {side, 1, 1, 1}, {3 * side, 3, 0, 1}}};
  };
  const LeafInstance a = sheet(fan(1), {std::nullopt, 3}), b = sheet(fan(-1), {std::nullopt, 5});
  const std::vector<LeafInstance> both = with_common_nets({a, b});
  CHECK(both[0].leaf == a.leaf);
  CHECK(both[1].leaf == b.leaf);
}

TEST_CASE("a Coons patch is the Bézier patch that it is") {
  // Of curves that move along each other it is their sum: control points p_i + q_j - corner.
  std::mt19937 random(29);
  for (int round = 0; round < 20; ++round) {
    CAPTURE(round);
    const auto curve = [&](std::size_t axis) {
      Row4 row;
      for (long i = 0; i < 4; ++i) {
        Point4 p{0, 0, i % 3 == 0 ? Rational(0) : ratio(pick(random, -3, 3), 2), 1};
        p[axis] = i;
        row.push_back(p);
      }
      return row;
    };
    const Row4 p = curve(0), q = curve(1);
    Net4 net;
    for (const Point4& b : q) {
      net.emplace_back();
      for (const Point4& a : p) net.back().push_back({a[0] + b[0], a[1] + b[1], a[2] + b[2], 1});
    }
    CoonsShape coons;
    auto& round_curves = coons.patches.emplace_back();
    Row4 right, back, top = net[3];
    for (std::size_t j = 0; j < 4; ++j) {
      right.push_back(net[j][3]);
      back.push_back(net[3 - j][0]);
    }
    std::reverse(top.begin(), top.end());
    const std::array<Row4, 4> rows{net[0], right, top, back};
    for (std::size_t k = 0; k < 4; ++k) round_curves[k] = curve_net(rows[k]);
    coons.tessellation = random_fineness(random);
    const Rectangle r{random_interval(random), random_interval(random)};
    const std::vector<LeafInstance> both = with_common_nets(
        {placed(coons), sheet(piece_of(net, r), random_fineness(random), random_transform(random))});
    CHECK(contains(facets(both[0]), facets(both[1])));
  }
}

TEST_CASE("numbers of segments that go into no common grid are refused") {
  const Net4 net{{{0, 0, 0, 1}, {1, 0, 1, 1}, {2, 0, 0, 1}},
                 {{0, 1, 1, 1}, {1, 1, 2, 1}, {2, 1, 1, 1}},
                 {{0, 2, 0, 1}, {1, 2, 3, 1}, {2, 2, 0, 1}}};
  const Net4 across = turned(net);
  const std::vector<LeafInstance> unlike{
      sheet(net, {std::nullopt, 11}), wire(net[0], {std::nullopt, 20'011}), wire(net[2], {std::nullopt, 20'021}),
      wire(across[0], {std::nullopt, 211}), wire(across[2], {std::nullopt, 199})};
  CHECK_THROWS_WITH(with_common_nets(unlike),
                    Catch::Contains("leaf 0: bezier: leaves that share its curves ask for numbers of segments"));
  const std::vector<LeafInstance> powers = with_common_nets(
      {sheet(net, {std::nullopt, 64}), wire(net[0], {std::nullopt, 96}), wire(net[2], {std::nullopt, 80})});
  const Segments side = border(powers[0]), lower = wires(powers[1]), upper = wires(powers[2]);
  CHECK(lower.size() == 96);
  CHECK(upper.size() == 80);
  CHECK(std::includes(side.begin(), side.end(), lower.begin(), lower.end()));
  CHECK(std::includes(side.begin(), side.end(), upper.begin(), upper.end()));
}
