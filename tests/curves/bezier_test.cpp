// Nets against independent formulas: Bernstein sums, Cox and de Boor's basis, the Coons formula.
#include "csg/curves/bezier.h"

#include <algorithm>
#include <functional>

#include "csg/curves/control_nets.h"
#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

Rational power(const Rational& x, std::size_t n) { return n == 0 ? Rational(1) : Rational(x * power(x, n - 1)); }

Rational bernstein(std::size_t n, std::size_t i, const Rational& t) {
  Rational c = 1;
  for (std::size_t k = 0; k < i; ++k) c = c * Rational(n - k) / Rational(k + 1);
  return c * power(t, i) * power(1 - t, n - i);
}

RationalPoint by_bernstein(const PatchNet& net, const Rational& u, const Rational& v) {
  RationalPoint sum{0, 0, 0};
  Rational weight = 0;
  const std::size_t q = net.points.size() - 1, p = net.points[0].size() - 1;
  for (std::size_t j = 0; j <= q; ++j) {
    for (std::size_t i = 0; i <= p; ++i) {
      const Rational b =
          bernstein(p, i, u) * bernstein(q, j, v) * (net.weights.empty() ? Rational(1) : net.weights[j][i]);
      sum = sum + b * net.points[j][i];
      weight += b;
    }
  }
  return (1 / weight) * sum;
}

/// The basis function i by its recursion; at the end of the domain the last span counts.
Rational basis(const std::vector<Rational>& knots, std::size_t i, std::size_t degree, const Rational& t,
               const Rational& end) {
  if (degree == 0) {
    const bool last = t == end && knots[i] < end && knots[i + 1] == end;
    return (knots[i] <= t && t < knots[i + 1]) || last ? 1 : 0;
  }
  Rational sum = 0;
  const Rational left = knots[i + degree] - knots[i], right = knots[i + degree + 1] - knots[i + 1];
  if (left != 0) sum += (t - knots[i]) / left * basis(knots, i, degree - 1, t, end);
  if (right != 0) sum += (knots[i + degree + 1] - t) / right * basis(knots, i + 1, degree - 1, t, end);
  return sum;
}

std::mt19937 random_numbers(7);
Rational random_number(int low, int high) {
  Rational r(std::uniform_int_distribution<int>(low * 6, high * 6)(random_numbers), 6);
  r.canonicalize();
  return r;
}
RationalPoint random_point() { return {random_number(-5, 5), random_number(-5, 5), random_number(-5, 5)}; }

PatchNet random_net(std::size_t columns, std::size_t rows, bool weights) {
  PatchNet net;
  for (std::size_t j = 0; j < rows; ++j) {
    net.points.emplace_back();
    if (weights) net.weights.emplace_back();
    for (std::size_t i = 0; i < columns; ++i) {
      net.points[j].push_back(random_point());
      if (weights) net.weights[j].push_back(random_number(1, 4));
    }
  }
  return net;
}

const std::vector<Rational> kParameters{0, Rational(1, 7), Rational(1, 2), Rational(5, 8), 1};

}  // namespace

TEST_CASE("patches are their Bernstein sums") {
  for (const bool weights : {false, true}) {
    for (const auto& [p, q] : {std::pair{2, 2}, std::pair{4, 3}, std::pair{3, 5}}) {
      const PatchNet net = random_net(static_cast<std::size_t>(p), static_cast<std::size_t>(q), weights);
      const std::vector<BezierPatch> pieces = patch_pieces(net, "test");
      REQUIRE(pieces.size() == 1);
      for (const Rational& u : kParameters) {
        for (const Rational& v : kParameters) CHECK(pieces[0].at(u, v) == by_bernstein(net, u, v));
        CHECK(pieces[0].side(0).at(u) == pieces[0].at(u, 0));
        CHECK(pieces[0].side(1).at(u) == pieces[0].at(1, u));
        CHECK(pieces[0].side(2).at(u) == pieces[0].at(1 - u, 1));
        CHECK(pieces[0].side(3).at(u) == pieces[0].at(0, 1 - u));
      }
    }
  }
}

TEST_CASE("B-splines are their basis sums, clamped or not") {
  const std::vector<std::vector<Rational>> all_knots{{0, 0, 0, 0, 1, 1, 3, 4, 4, 4, 4},
                                                     {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10},
                                                     {0, 0, 1, 2, 2, 2, Rational(7, 3), 3, 4, 4, 5}};
  for (const auto& knots : all_knots) {
    CurveNet net{{}, {}, 3, knots};
    for (int i = 0; i < 7; ++i) {
      net.points.push_back(random_point());
      net.weights.push_back(random_number(1, 3));
    }
    const std::vector<BezierCurve> pieces = curve_pieces(net, "test");
    std::size_t piece = 0;
    for (std::size_t span = 3; span < 7; ++span) {
      if (knots[span] == knots[span + 1]) continue;
      for (const Rational& x : kParameters) {
        if (x == 1) continue;  // the next span begins there, where a basis may jump
        const Rational t = knots[span] + x * (knots[span + 1] - knots[span]);
        RationalPoint sum{0, 0, 0};
        Rational weight = 0;
        for (std::size_t i = 0; i < 7; ++i) {
          const Rational b = basis(knots, i, 3, t, knots[7]) * net.weights[i];
          sum = sum + b * net.points[i];
          weight += b;
        }
        CHECK(pieces.at(piece).at(x) == (1 / weight) * sum);
      }
      if (piece > 0) CHECK(pieces[piece - 1].at(1) == pieces[piece].at(0));
      ++piece;
    }
    CHECK(piece == pieces.size());
  }
  SECTION("a patch is cut along u and along v") {
    PatchNet net = random_net(5, 4, true);
    net.degree = {2, 3};
    const std::vector<BezierPatch> pieces = patch_pieces(net, "test");
    REQUIRE(pieces.size() == 3);
    const std::vector<Rational> knots = clamped_knots(5, 2);
    const Rational t = Rational(1, 3) + Rational(1, 3) * Rational(1, 7), v = Rational(2, 5);
    RationalPoint sum{0, 0, 0};
    Rational weight = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t i = 0; i < 5; ++i) {
        const Rational b = basis(knots, i, 2, t, 1) * bernstein(3, j, v) * net.weights[j][i];
        sum = sum + b * net.points[j][i];
        weight += b;
      }
    }
    CHECK(pieces[1].at(Rational(1, 7), v) == (1 / weight) * sum);
  }
}

TEST_CASE("a quarter of a circle with the weights 1, 1, 2 is exact") {
  const BezierCurve arc = curve_pieces({{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {1, 1, 2}, 0, {}}, "test")[0];
  for (const Rational& t : kParameters) CHECK(dot(arc.at(t), arc.at(t)) == 1);
}

TEST_CASE("canonical nets see through direction, degree and proportion") {
  for (int round = 0; round < 20; ++round) {
    ControlRow row;
    for (int i = 0; i < 4; ++i) row.push_back(homogeneous(random_point(), random_number(1, 3)));
    const CanonicalCurve plain = canonical(BezierCurve{row});
    ControlRow other = elevated(row, 6);
    std::reverse(other.begin(), other.end());
    for (Homogeneous& h : other) {
      for (Rational& x : h) x *= Rational(5, 3);
    }
    const CanonicalCurve same = canonical(BezierCurve{other});
    CHECK(same.curve.net == plain.curve.net);
    CHECK(same.reversed != plain.reversed);
    for (const Rational& t : kParameters) CHECK(same.curve.at(t) == plain.curve.at(t));
    CHECK(reduced(elevated(row, 9)) == reduced(row));
  }
}

TEST_CASE("Coons patches are the formula, of rational curves too") {
  for (const bool weights : {false, true}) {
    std::vector<RationalPoint> corner;
    for (int i = 0; i < 4; ++i) corner.push_back(random_point());
    std::array<BezierCurve, 4> round;
    for (std::size_t k = 0; k < 4; ++k) {
      CurveNet net;
      net.points = {corner[k], random_point(), corner[(k + 1) % 4]};
      if (k == 2) net.points.insert(net.points.begin() + 1, random_point());
      if (weights) {
        for (std::size_t i = 0; i < net.points.size(); ++i) net.weights.push_back(random_number(1, 3));
      }
      round[k] = curve_pieces(net, "test")[0];
    }
    const BezierPatch patch = coons_patch(round);
    if (!weights) {
      CHECK(patch.degree_u() == 3);
      CHECK(patch.degree_v() == 2);
    }
    for (const Rational& u : kParameters) {
      for (const Rational& v : kParameters) {
        const Rational s = 1 - u, t = 1 - v;
        const RationalPoint expected = t * round[0].at(u) + v * round[2].at(s) + s * round[3].at(t) +
                                       u * round[1].at(v) -
                                       (Rational(s * t) * corner[0] + Rational(u * t) * corner[1] +
                                        Rational(u * v) * corner[2] + Rational(s * v) * corner[3]);
        CHECK(patch.at(u, v) == expected);
      }
    }
  }
}

TEST_CASE("nets that are no nets are refused") {
  const auto curve = [](CurveNet net) { return error_of([&] { curve_pieces(net, "bspline: the curve"); }); };
  const std::vector<RationalPoint> four{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}};
  CHECK_THAT(curve({{{0, 0, 0}}, {}, 0, {}}), Catch::Contains("1 control points are too few"));
  CHECK_THAT(curve({four, {1, 1, 0, 1}, 0, {}}), Catch::Contains("a weight is 0: give positive"));
  CHECK_THAT(curve({four, {1, 1}, 0, {}}), Catch::Contains("4 control points have 2 weights"));
  CHECK_THAT(curve({four, {}, 4, {}}), Catch::Contains("degree 4 takes at least 5"));
  CHECK_THAT(curve({four, {}, 2, {0, 0, 0, 1, 1, 1}}), Catch::Contains("take 7 knots, there are 6"));
  CHECK_THAT(curve({four, {}, 2, {0, 0, 0, 1, Rational(1, 2), 1, 1}}),
             Catch::Contains("knot 5 is 0.5, less than"));
  CHECK_THAT(curve({four, {}, 2, {0, 0, 1, 1, 1, 1, 1}}), Catch::Contains("all spans"));
  CHECK_THAT(curve({four, {}, 1, {0, 0, 1, 1, 2, 2}}), Catch::Contains("would tear the spline"));
  CHECK_THAT(curve({four, {}, 3, {1, 1, 1, 1, 1, 1, 1, 1}}), Catch::Contains("all spans"));
  CHECK_THAT(curve({std::vector<RationalPoint>(40, {0, 0, 0}), {}, 0, {}}), Catch::Contains("its degree is 39"));
  PatchNet ragged{{four, {four[0]}}, {}, {0, 0}, {}};
  CHECK_THAT(error_of([&] { patch_pieces(ragged, "bezier: the patch"); }),
             Catch::Contains("row 2 has 1 control points"));
}
