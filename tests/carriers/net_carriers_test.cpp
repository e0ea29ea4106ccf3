// Which nets lie on one carrier, and where.
#include "csg/carriers/net_carriers.h"

#include "tests/carriers/nets_scenes.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

/// A net from the polynomial with the coefficients of u^i v^j, [i][j], homogeneous.
Net4 from_powers(const std::vector<std::vector<Point4>>& c) {
  const std::size_t m = c.size() - 1, n = c[0].size() - 1;
  // The blossom of u^i of degree m at m arguments of 0 and k of 1 is binomial(k, i) / binomial(m, i).
  const auto of = [](std::size_t m, std::size_t i, std::size_t k) {
    if (k < i) return Rational(0);
    Rational result = 1;
    for (std::size_t x = 0; x < i; ++x) result *= Rational(k - x) / Rational(m - x);
    return result;
  };
  Net4 net(n + 1, Row4(m + 1, Point4{0, 0, 0, 0}));
  for (std::size_t q = 0; q <= n; ++q) {
    for (std::size_t p = 0; p <= m; ++p) {
      for (std::size_t i = 0; i <= m; ++i) {
        for (std::size_t j = 0; j <= n; ++j) {
          for (std::size_t e = 0; e < 4; ++e) net[q][p][e] += of(m, i, p) * of(n, j, q) * c[i][j][e];
        }
      }
    }
  }
  return net;
}

BezierPatch patch(const Net4& net) {
  BezierPatch result;
  for (const Row4& row : net) result.net.emplace_back(row.begin(), row.end());
  return result;
}

constexpr int kNoAxis = 0, kX = 1, kY = 2, kZ = 3, kW = 4;
/// Coefficients that are one coordinate each.
std::vector<std::vector<Point4>> powers(const std::vector<std::vector<std::vector<int>>>& which) {
  std::vector<std::vector<Point4>> c;
  for (const auto& row : which) {
    c.emplace_back();
    for (const auto& coordinates : row) {
      Point4 h{0, 0, 0, 0};
      for (const int k : coordinates) {
        if (k != kNoAxis) h[static_cast<std::size_t>(k - 1)] += 1;
      }
      c.back().push_back(h);
    }
  }
  return c;
}

/// The place on the carrier, ascending along its two parameters.
Rectangle covered(const OnSurface& on) {
  Rectangle result;
  for (std::size_t d = 0; d < 2; ++d) {
    result[on.axis[d]] = on.at[d];
    if (result[on.axis[d]][1] < result[on.axis[d]][0]) std::swap(result[on.axis[d]][0], result[on.axis[d]][1]);
  }
  return result;
}

/// All pieces of the net lie on one carrier, in rectangles that are to each other as those of the pieces.
void check_pieces(const Net4& net, std::mt19937& random, bool own_mirror_image) {
  SurfaceCarriers carriers;
  const std::optional<OnSurface> whole = carriers.place(patch(net));
  REQUIRE(whole);
  for (int k = 0; k < 12; ++k) {
    const Rectangle r{random_interval(random), random_interval(random)};
    const int way = pick(random, 0, 7);
    const std::optional<OnSurface> part =
        carriers.place(patch(raised(written(piece_of(net, r), way), pick(random, 0, 1), pick(random, 0, 1))));
    REQUIRE(part);
    CHECK(part->carrier == whole->carrier);
    if (own_mirror_image) continue;  // it may lie in the other half
    const Rectangle on = covered(*part);
    for (std::size_t d = 0; d < 2; ++d) {
      const std::size_t axis = whole->axis[d];
      const Rational long_whole = whole->at[d][1] - whole->at[d][0];
      Rational low = (on[axis][0] - whole->at[d][0]) / long_whole,
               high = (on[axis][1] - whole->at[d][0]) / long_whole;
      if (high < low) std::swap(low, high);
      CHECK(low == r[d][0]);
      CHECK(high == r[d][1]);
    }
  }
}

}  // namespace

TEST_CASE("sub-patches of polynomial and rational patches lie on their carrier, where they were cut out") {
  std::mt19937 random(1);
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    const int m = pick(random, 1, 3), n = pick(random, 2, 4);
    check_pieces(round % 2 ? random_graph(random, m, n) : random_rational(random, m, n), random, false);
  }
}

TEST_CASE("carriers whose highest powers say little have one place for each piece, too") {
  std::mt19937 random(2);
  using P = std::vector<std::vector<std::vector<int>>>;
  const std::vector<std::pair<P, bool>> cases{
      // z = u^2 + v^2 + u, (x, y) = (u, v): moved within one plane of symmetry each
      {{{{kW}, {kY}, {kZ}}, {{kX}, {}, {}}, {{kZ}, {}, {}}}, false},
      {{{{kW}, {kY}, {}}, {{kX}, {}, {}}, {{kZ}, {}, {}}}, false},          // z = u^2, a cylinder
      {{{{kW}, {kY}, {kZ}}, {{kX}, {kZ, kZ}, {}}, {{kZ}, {}, {}}}, false},  // z = (u + v)^2
      {{{{kW}, {kY}, {}}, {{kX}, {kZ}, {}}}, false},                        // z = u v
      {{{{kW}, {kY}, {}, {kZ}}, {{kX}, {}, {}, {}}}, false},                // z = v^3
      {{{{kW}, {}, {kY}}, {{}, {}, {}}, {{kX}, {}, {kZ}}}, true},           // x = u^2, y = v^2: four times
      {{{{kW}, {kX}, {}}, {{kX}, {kZ}, {}}, {{}, {}, {}}}, true},           // u and v may be exchanged
  };
  for (const auto& [which, mirror] : cases) check_pieces(from_powers(powers(which)), random, mirror);
}

TEST_CASE("where a carrier covers itself, patches that are one surface have one place") {
  using P = std::vector<std::vector<std::vector<int>>>;
  const Net4 four = from_powers(powers(P{{{kW}, {}, {kY}}, {{}, {}, {}}, {{kX}, {}, {kZ}}}));
  SurfaceCarriers carriers;
  const Rational h = ratio(1, 2);
  const auto a = carriers.place(patch(piece_of(four, {{{h, 1}, {0, h}}})));
  const auto b = carriers.place(patch(piece_of(four, {{{-1, -h}, {0, h}}})));
  REQUIRE(a);
  REQUIRE(b);
  CHECK(a->carrier == b->carrier);
  CHECK(covered(*a) == covered(*b));
  const Net4 turned_over = from_powers(powers(P{{{kW}, {kX}, {}}, {{kX}, {kZ}, {}}, {{}, {}, {}}}));
  const auto c = carriers.place(patch(piece_of(turned_over, {{{0, h}, {h, 1}}})));
  const auto d = carriers.place(patch(piece_of(turned_over, {{{h, 1}, {0, h}}})));
  CHECK(c->carrier == d->carrier);
  CHECK(covered(*c) == covered(*d));
}

TEST_CASE("surfaces that differ have different carriers, however little") {
  std::mt19937 random(3);
  SurfaceCarriers carriers;
  const Net4 net = random_graph(random, 2, 2);
  std::set<std::size_t> numbers{carriers.place(patch(net))->carrier};
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t e = 0; e < 4; ++e) {
        Net4 other = net;
        other[j][i][e] += parse_rational("1e-40").value();
        numbers.insert(carriers.place(patch(other))->carrier);
      }
    }
  }
  CHECK(numbers.size() == 37);
  // Equal directions, scales that are no squares of rational numbers: 2 = a^2 has no solution.
  using P = std::vector<std::vector<std::vector<int>>>;
  const P which{{{kW}, {kY}, {}}, {{kX}, {}, {}}, {{kZ}, {}, {}}};
  auto c = powers(which);
  const std::size_t one = carriers.place(patch(from_powers(c)))->carrier;
  c[1][0][0] = 3;  // x = 3 u, z = u^2: another cylinder
  CHECK(carriers.place(patch(from_powers(c)))->carrier != one);
  c[2][0][2] = 9;  // z = 9 u^2: the same again
  CHECK(carriers.place(patch(from_powers(c)))->carrier == one);
}

TEST_CASE("parallelograms and what has no area have no carrier") {
  using P = std::vector<std::vector<std::vector<int>>>;
  SurfaceCarriers carriers;
  CHECK(!carriers.place(patch(from_powers(powers(P{{{kW}, {kY}}, {{kX}, {}}})))));
  CHECK(!carriers.place(patch(from_powers(powers(P{{{kW}}, {{kX}}, {{kY}}})))));      // a curve
  CHECK(!carriers.place(patch(from_powers(powers(P{{{kW}, {}}, {{}, {kX, kY}}})))));  // a line, u v
}

TEST_CASE("curves lie on one carrier when one is a part of the other") {
  std::mt19937 random(4);
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    const Net4 net = round % 2 ? random_graph(random, 3, 1) : random_rational(random, pick(random, 2, 4), 1);
    CurveCarriers carriers;
    const auto whole = carriers.place(ControlRow(net[0].begin(), net[0].end()));
    if (!whole) continue;  // straight
    const std::array<Rational, 2> on = random_interval(random);
    Row4 row = raised(piece_of(net[0], on[0], on[1]));
    if (round % 3 == 0) std::reverse(row.begin(), row.end());
    for (Point4& h : row) {
      for (Rational& x : h) x *= 7;
    }
    const auto part = carriers.place(ControlRow(row.begin(), row.end()));
    REQUIRE(part);
    CHECK(part->carrier == whole->carrier);
    const Rational length = whole->at[1] - whole->at[0];
    std::set<Rational> ends, expected{on[0], on[1]};
    for (const Rational& x : part->at) ends.insert((x - whole->at[0]) / length);
    CHECK(ends == expected);
    CHECK(carriers.place(ControlRow(net[1].begin(), net[1].end()), {0, 0, 1})->carrier != whole->carrier);
    CHECK(carriers.place(ControlRow(net[0].begin(), net[0].end()), {0, 0, 1})->carrier != whole->carrier);
  }
  CurveCarriers carriers;
  CHECK(!carriers.place({{0, 0, 0, 1}, {1, 1, 1, 1}}));
  CHECK(!carriers.place({{0, 0, 0, 1}, {1, 1, 1, 1}, {2, 2, 2, 1}}));
}
