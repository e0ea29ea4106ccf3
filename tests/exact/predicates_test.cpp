// Each predicate against rational arithmetic, and the stage that decided it: filters must decide the easy cases,
// exact integers the ones built to defeat everything before.
#include "kernel/exact/predicates.h"

#include <cmath>
#include <random>

#include "tests/catch.h"

using namespace cnrg;

namespace {

Rational determinant(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
                     const RationalPoint& d) {
  Rational m[3][3];
  const RationalPoint* rows[3] = {&b, &c, &d};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) m[i][k] = (*rows[i])[static_cast<std::size_t>(k)] - a[static_cast<std::size_t>(k)];
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

struct Stages {
  StageCounts before = stage_counts();
  StageCounts since() const {
    const StageCounts now = stage_counts();
    return {now.filter - before.filter, now.interval - before.interval, now.exact - before.exact};
  }
};

}  // namespace

TEST_CASE("orient3d agrees with rational determinants") {
  std::mt19937_64 random(7);
  for (int round = 0; round < 3000; ++round) {
    PointTable t;
    std::uniform_int_distribution<int> small(-3, 3), power(-40, 40);
    const auto coordinate = [&]() -> double {
      switch (round % 3) {
        case 0: return small(random);
        case 1: return std::ldexp(static_cast<double>(random() >> 11), -53);
        default: return std::ldexp(small(random), power(random) * 20);
      }
    };
    for (int i = 0; i < 4; ++i) t.add(coordinate(), coordinate(), coordinate());
    const VertexId a(0), b(1), c(2), d(3);
    const int expected = sgn(determinant(t.rational(a), t.rational(b), t.rational(c), t.rational(d)));
    INFO("round " << round);
    REQUIRE(orient3d(t, a, b, c, d) == expected);
    REQUIRE(orient3d(t, b, c, a, d) == expected);
    REQUIRE(orient3d(t, b, a, c, d) == -expected);
    REQUIRE(orient3d(t, d, b, c, a) == -expected);
  }
}

TEST_CASE("orient3d: the sign and the stage that decided it") {
  PointTable t;
  const VertexId o = t.add(0, 0, 0), x = t.add(1, 0, 0), y = t.add(0, 1, 0), z = t.add(0, 0, 1);
  {
    const Stages stages;
    REQUIRE(orient3d(t, o, x, y, z) == 1);
    REQUIRE(stages.since().filter == 1);
  }
  {
    const VertexId p = t.add(3, 5, 0), q = t.add(0.5, 0.25, 8);
    const Stages stages;
    REQUIRE(orient3d(t, o, x, y, p) == 0);  // a coordinate that never differs: the filter knows
    REQUIRE(orient3d(t, o, x, y, q) == 1);
    REQUIRE(stages.since().filter == 2);
  }
  {
    // Nearly coplanar: the determinant is one unit in the last place of its terms.
    const double e = std::ldexp(1.0, -52);
    const VertexId a = t.add(0.1, 0.1, 0.1), b = t.add(0.7, 0.3, 0.2), c = t.add(0.3, 0.9, 0.5);
    const VertexId d = t.add(0.5, 0.6, 0.35 * (1 + e));
    const Stages stages;
    const int s = orient3d(t, a, b, c, d);
    REQUIRE(s == sgn(determinant(t.rational(a), t.rational(b), t.rational(c), t.rational(d))));
    REQUIRE(stages.since().filter == 0);
  }
  {
    // Coplanar beyond the range of products: intervals overflow, integers do not.
    const VertexId a = t.add(1e200, 0, 1e200), b = t.add(0, 1e200, 1e200), c = t.add(1e200, 1e200, 2e200);
    const Stages stages;
    REQUIRE(orient3d(t, o, a, b, c) == 0);
    REQUIRE(stages.since().exact == 1);
  }
}

TEST_CASE("constructed points: enclosure, definition and exact value agree") {
  std::mt19937_64 random(11);
  std::uniform_int_distribution<int> any(-20, 20);
  int made = 0;
  for (int round = 0; round < 2000; ++round) {
    PointTable t;
    for (int i = 0; i < 9; ++i) t.add(any(random), any(random), any(random));
    bool flat = false;
    for (std::size_t i = 0; i < 3; ++i)
      flat = flat || collinear(t, VertexId(3 * i), VertexId(3 * i + 1), VertexId(3 * i + 2));
    if (flat) continue;
    PlaneId p[3];
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = t.add_plane(VertexId(3 * i), VertexId(3 * i + 1), VertexId(3 * i + 2));
    if (side_of_plane(t, p[1], VertexId(0)) * side_of_plane(t, p[1], VertexId(1)) < 0) {
      Definition d;
      d.kind = Definition::Kind::line_plane;
      d.points = {VertexId(0), VertexId(1), VertexId(), VertexId()};
      d.planes[0] = p[1];
      const VertexId v = t.add(d);
      ++made;
      REQUIRE(side_of_plane(t, p[1], v) == 0);
      REQUIRE(side_of_plane(t, p[0], v) == 0);
      REQUIRE(collinear(t, VertexId(0), VertexId(1), v));
      const PointView view = t.view(v);
      const RationalPoint r = t.rational(v);
      for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(from_double(view.lo[k]) <= r[k]);
        REQUIRE(r[k] <= from_double(view.hi[k]));
        REQUIRE(view.hi[k] - view.lo[k] <= 1e-9);
      }
    }
    const ExactPlane &e0 = t.exact_plane(p[0]), &e1 = t.exact_plane(p[1]), &e2 = t.exact_plane(p[2]);
    const Integer det = e0.a * (e1.b * e2.c - e1.c * e2.b) - e0.b * (e1.a * e2.c - e1.c * e2.a) +
                        e0.c * (e1.a * e2.b - e1.b * e2.a);
    if (sgn(det) == 0) continue;
    Definition d;
    d.kind = Definition::Kind::three_planes;
    d.planes = {p[0], p[1], p[2]};
    const VertexId v = t.add(d);
    ++made;
    for (const PlaneId q : p) REQUIRE(side_of_plane(t, q, v) == 0);
    const ExactPoint& exact = t.exact(v);
    REQUIRE(sgn(exact.w) > 0);
    REQUIRE(gcd(gcd(exact.x, exact.y), gcd(exact.z, exact.w)) == 1);
  }
  REQUIRE(made > 2000);
}

TEST_CASE("points on a grid come out of their enclosures exactly") {
  PointTable t;
  const VertexId a = t.add(0, 0, 0), b = t.add(6, 3, 9);
  const PlaneId p = t.add_plane(t.add(2, 0, 0), t.add(2, 1, 0), t.add(2, 0, 1));
  Definition d;
  d.points = {a, b, VertexId(), VertexId()};
  d.planes[0] = p;
  const PointView v = t.view(t.add(d));
  REQUIRE(v.lo == v.hi);
  REQUIRE(v.lo == std::array<double, 3>{2, 1, 3});
}

TEST_CASE("two lines in a plane cross where the definition says, whatever the plane") {
  for (int axis = 0; axis < 3; ++axis) {
    PointTable t;
    const auto add = [&](double u, double v) {
      std::array<double, 3> c{};
      c[static_cast<std::size_t>(axis)] = u;
      c[static_cast<std::size_t>((axis + 1) % 3)] = v;
      return t.add(c[0], c[1], c[2]);
    };
    Definition d;
    d.kind = Definition::Kind::line_line;
    d.points = {add(0, 0), add(3, 3), add(0, 1), add(1, 0)};
    const VertexId v = t.add(d);
    REQUIRE(t.rational(v)[static_cast<std::size_t>(axis)] == Rational(1, 2));
    REQUIRE(t.rational(v)[static_cast<std::size_t>((axis + 1) % 3)] == Rational(1, 2));
    REQUIRE(t.rational(v)[static_cast<std::size_t>((axis + 2) % 3)] == 0);
  }
}

TEST_CASE("orient2d and its form for vectors agree with rationals") {
  std::mt19937_64 random(3);
  std::uniform_int_distribution<int> any(-4, 4);
  for (int round = 0; round < 3000; ++round) {
    PointTable t;
    RationalPoint p[4];
    for (auto& q : p) {
      for (auto& c : q) {
        c = Rational(any(random), round % 2 == 0 ? 1 : 3);
        c.canonicalize();
      }
      t.add(q);
    }
    const auto cross = [&](int i, int j, int k, int l) {
      return sgn(Rational((p[j][0] - p[i][0]) * (p[l][1] - p[k][1]) - (p[j][1] - p[i][1]) * (p[l][0] - p[k][0])));
    };
    REQUIRE(orient2d(t, {0, 1}, VertexId(0), VertexId(1), VertexId(2)) == cross(0, 1, 0, 2));
    REQUIRE(orient2d(t, {1, 0}, VertexId(0), VertexId(1), VertexId(2)) == -cross(0, 1, 0, 2));
    REQUIRE(orient2d_vectors(t, {0, 1}, VertexId(0), VertexId(1), VertexId(2), VertexId(3)) == cross(0, 1, 2, 3));
  }
}
