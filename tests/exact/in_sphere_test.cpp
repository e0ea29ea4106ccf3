// Points in spheres against the determinant in fractions, and perturbed ones against each other.
#include "kernel/exact/in_sphere.h"

#include <array>
#include <random>
#include <vector>

#include "kernel/exact/predicates.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

namespace cnrg {
namespace {

/// By the circumcentre: where is e, beside the sphere around the corners of a tetrahedron that is not flat?
int by_centre(const PointTable& t, const std::array<VertexId, 5>& v) {
  const auto at = [&](std::size_t i) { return t.rational(v[i]); };
  const RationalPoint o = at(0);
  std::array<std::array<Rational, 4>, 3> rows;  // 2 (p - o) x = |p|^2 - |o|^2, about o
  for (std::size_t i = 0; i < 3; ++i) {
    rows[i][3] = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational d = at(i + 1)[k] - o[k];
      rows[i][k] = 2 * d;
      rows[i][3] += d * d;
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    std::size_t pivot = c;
    while (rows[pivot][c] == 0) ++pivot;
    std::swap(rows[c], rows[pivot]);
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == c) continue;
      const Rational factor = rows[i][c] / rows[c][c];
      for (std::size_t k = c; k < 4; ++k) rows[i][k] -= factor * rows[c][k];
    }
  }
  Rational radius = 0, distance = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational x = rows[k][3] / rows[k][k], d = at(4)[k] - o[k] - x;
    radius += x * x;
    distance += d * d;
  }
  return cmp(radius, distance) > 0 ? 1 : cmp(radius, distance) < 0 ? -1 : 0;
}

PointTable points(std::mt19937_64& random, int kind) {
  PointTable t;
  for (int i = 0; i < 5; ++i) {
    std::array<Rational, 3> p;
    for (Rational& x : p) {
      const auto n = static_cast<long>(random() % (kind == 0 ? 4 : 1000));
      x = kind == 2 ? Rational(n, 7) : kind == 3 ? Rational(1) + from_double(double(n) * 1e-16) : Rational(n);
    }
    if (kind == 2) t.add(p);
    else t.add(to_double(p[0]), to_double(p[1]), to_double(p[2]));
  }
  return t;
}

TEST_CASE("a point is inside of a sphere as the centre tells", "[in_sphere]") {
  const auto [begin, end] = scenes::seeds(400);
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    std::mt19937_64 random(seed);
    const PointTable t = points(random, static_cast<int>(seed % 4));
    std::array<VertexId, 5> v;
    for (std::size_t i = 0; i < 5; ++i) v[i] = VertexId(i);
    const int turn = orient3d(t, v[0], v[1], v[2], v[3]);
    if (turn == 0) continue;
    INFO("seed " << seed);
    CHECK(in_sphere(t, v[0], v[1], v[2], v[3], v[4]) == turn * by_centre(t, v));
  }
}

TEST_CASE("perturbed, exchanging points turns the sign, and only points of one plane have none", "[in_sphere]") {
  const auto [begin, end] = scenes::seeds(400);
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    std::mt19937_64 random(seed);
    const PointTable t = points(random, 0);
    const std::array<VertexId, 5> v{VertexId(0), VertexId(1), VertexId(2), VertexId(3), VertexId(4)};
    const auto sign = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d, std::size_t e) {
      return in_sphere_perturbed(t, v[a], v[b], v[c], v[d], v[e]);
    };
    INFO("seed " << seed);
    const int s = sign(0, 1, 2, 3, 4);
    CHECK(sign(1, 0, 2, 3, 4) == -s);
    CHECK(sign(4, 1, 2, 3, 0) == -s);
    CHECK(sign(1, 2, 0, 3, 4) == s);
    if (const int exact = in_sphere(t, v[0], v[1], v[2], v[3], v[4])) CHECK(s == exact);
    bool flat = true;
    for (std::size_t i = 0; i < 5; ++i) {
      std::vector<VertexId> four;
      for (std::size_t k = 0; k < 5; ++k) {
        if (k != i) four.push_back(v[k]);
      }
      flat = flat && orient3d(t, four[0], four[1], four[2], four[3]) == 0;
    }
    CHECK((s == 0) == flat);
  }
}

}  // namespace
}  // namespace cnrg
