// Constrained tetrahedra against what they are to be: positive, filling the box, face to face, with facets and
// segments as unions of their faces and edges.
#include "kernel/tetrahedra/constrained.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "kernel/base/error.h"
#include "kernel/exact/in_sphere.h"
#include "kernel/exact/predicates.h"
#include "kernel/tetrahedra/tetrahedra.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"
#include "tests/tetrahedra/random_triangles.h"

namespace cnrg {
namespace {

using Triangle = std::array<VertexId, 3>;

RationalPoint exact_cross(const RationalPoint& u, const RationalPoint& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

RationalPoint difference(const PointTable& t, VertexId a, VertexId b) {
  const RationalPoint p = t.rational(a), q = t.rational(b);
  return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
}

RationalPoint area(const PointTable& t, const std::vector<Triangle>& triangles) {
  RationalPoint sum{0, 0, 0};
  for (const Triangle& f : triangles) {
    const RationalPoint n = exact_cross(difference(t, f[0], f[1]), difference(t, f[0], f[2]));
    for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k];
  }
  return sum;
}

/// Are two sums of areas one, or in doubles as near as moving points by last digits leaves them?
bool same_area(const RationalPoint& a, const RationalPoint& b, NewPoints how) {
  if (how == NewPoints::exact) return a == b;
  double off = 0, size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    off = std::max(off, std::fabs(Rational(a[k] - b[k]).get_d()));
    size = std::max(size, std::fabs(b[k].get_d()));
  }
  return off <= 1e-9 * size;
}

/// Returns how many points were added.
std::size_t check(PointTable& t, const Constraints& constraints, NewPoints how = NewPoints::exact) {
  const std::size_t before = t.size();
  const ConstrainedTetrahedra made = constrained_tetrahedra(t, constraints, {}, how);
  std::map<Triangle, int> faces;
  std::set<std::array<VertexId, 2>> edges;
  Rational volume = 0;
  for (const auto& c : made.tetrahedra) {
    REQUIRE(orient3d(t, c[0], c[1], c[2], c[3]) > 0);
    const RationalPoint n = exact_cross(difference(t, c[0], c[1]), difference(t, c[0], c[2]));
    const RationalPoint d = difference(t, c[0], c[3]);
    volume += n[0] * d[0] + n[1] * d[1] + n[2] * d[2];
    for (std::size_t k = 0; k < 4; ++k) {
      Triangle f{c[(k + 1) % 4], c[(k + 2) % 4], c[(k + 3) % 4]};
      std::sort(f.begin(), f.end());
      ++faces[f];
      for (std::size_t l = 0; l < k; ++l) edges.insert({std::min(c[k], c[l]), std::max(c[k], c[l])});
    }
  }
  const RationalPoint size = difference(t, VertexId(before), VertexId(before + 7));
  CHECK(volume == 6 * size[0] * size[1] * size[2]);
  CHECK(std::all_of(faces.begin(), faces.end(), [](const auto& face) { return face.second <= 2; }));

  std::vector<std::vector<Triangle>> pieces(constraints.facets.size());
  for (const auto& [corners, of] : made.triangles) {
    pieces[of].push_back(corners);
    Triangle f = corners;
    std::sort(f.begin(), f.end());
    REQUIRE(faces.contains(f));
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    CHECK(same_area(area(t, pieces[i]), area(t, constraints.facets[i]), how));
    if (how == NewPoints::doubles) continue;
    const Triangle& f = constraints.facets[i][0];
    for (const Triangle& piece : pieces[i]) {
      for (const VertexId v : piece) CHECK(orient3d(t, f[0], f[1], f[2], v) == 0);
    }
  }
  std::vector<RationalPoint> way(constraints.segments.size(), RationalPoint{0, 0, 0});
  for (const auto& [ends, of] : made.segments) {
    CHECK(edges.contains({std::min(ends[0], ends[1]), std::max(ends[0], ends[1])}));
    const RationalPoint d = difference(t, ends[0], ends[1]);
    for (std::size_t k = 0; k < 3; ++k) way[of][k] += d[k];
  }
  for (std::size_t i = 0; i < way.size(); ++i)
    CHECK(way[i] == difference(t, constraints.segments[i][0], constraints.segments[i][1]));
  std::set<VertexId> added;
  for (const auto& corners : made.tetrahedra) {
    for (const VertexId v : corners) {
      if (v.index() >= before + 8) added.insert(v);
    }
  }
  const auto is_double = [&](VertexId v) { return t.is_double(v); };
  CHECK((how == NewPoints::exact || std::all_of(added.begin(), added.end(), is_double)));
  return added.size();
}

TEST_CASE("random triangles become faces of tetrahedra", "[tetrahedra]") {
  const auto [begin, end] = scenes::seeds(120);
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    INFO("seed " << seed);
    std::mt19937_64 random(seed);
    PointTable t;
    const Constraints constraints = random_triangles(random, t);
    check(t, constraints);
  }
}

/// Two sheets with a rim in common and some last digits of doubles between them elsewhere, far from the origin,
/// and wires that end on them at flat angles.
Constraints sheets_and_wires(std::mt19937_64& random, PointTable& t) {
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  constexpr int kSide = 6;
  const double slope_x = number(-1, 1), slope_y = number(-1, 1), gap = std::exp2(number(-29, -26));
  const auto height = [&](double x, double y) { return 1000 + slope_x * x + slope_y * y; };
  const auto place = [&](double x, double y, double above) {
    return t.add(400'000 + x, 3'700'000 + y, height(x, y) + above);
  };
  std::vector<std::array<double, 2>> at;
  std::vector<VertexId> low, high;
  for (int i = 0; i <= kSide; ++i) {
    for (int k = 0; k <= kSide; ++k) {
      const bool rim = i == 0 || k == 0 || i == kSide || k == kSide;
      const double x = 100 * (i + (rim ? 0 : number(-0.2, 0.2))), y = 30 * (k + (rim ? 0 : number(-0.2, 0.2)));
      at.push_back({x, y});
      low.push_back(place(x, y, 0));
      high.push_back(rim ? low.back() : place(x, y, gap));
    }
  }
  Constraints c;
  const auto sheet = [&](const std::vector<VertexId>& v, bool other) {
    for (std::size_t i = 0; i < kSide; ++i) {
      for (std::size_t k = 0; k < kSide; ++k) {
        const std::size_t a = i * (kSide + 1) + k, b = a + kSide + 1;
        const bool inside = i > 0 && k > 0 && i + 1 < kSide && k + 1 < kSide;
        if (other && inside) {
          c.facets.push_back({{v[a], v[b], v[b + 1]}});
          c.facets.push_back({{v[a], v[b + 1], v[a + 1]}});
        } else {
          c.facets.push_back({{v[a], v[b], v[a + 1]}});
          c.facets.push_back({{v[a + 1], v[b], v[b + 1]}});
        }
      }
    }
  };
  sheet(low, false);
  sheet(high, true);
  for (int i = 0; i < 40; ++i) {
    const auto inside = [&] { return std::uniform_int_distribution<std::size_t>(1, kSide - 1)(random); };
    const std::size_t v = inside() * (kSide + 1) + inside();
    const double x = at[v][0] + number(-300, 300), y = at[v][1] + number(-80, 80);
    c.segments.push_back({high[v], place(x, y, gap + number(0.5, 1) * std::exp2(number(-25, 6)))});
  }
  return c;
}

TEST_CASE("between sheets nearer than doubles tell points have doubles", "[tetrahedra]") {
  const auto [begin, end] = scenes::seeds(40);
  std::size_t added = 0;
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    INFO("seed " << seed);
    std::mt19937_64 random(seed);
    PointTable t;
    const Constraints constraints = sheets_and_wires(random, t);
    added += check(t, constraints, NewPoints::doubles);
  }
  CHECK(added > 0);
}

/// Triangles of faults that meet in a corner, one almost in the plane of the next.
Constraints corner_of_faults(PointTable& t, double scale_y, double scale_z) {
  constexpr double kPoints[][3] = {{-13486.71875, 340466.5625, 3752451},
                                   {-3911.8479000000002, 340815.125, 3750639.4375},
                                   {-13349.28125, 340862.25, 3751483.5},
                                   {-4045.4404300000001, 340989.35937999998, 3751034.84375},
                                   {-4023.9109509876225, 341068.31485308846, 3750979.6001691096},
                                   {-3935.7095066940647, 341168.11305304553, 3750735.5610396708},
                                   {-3915.9816917914404, 341190.43654984684, 3750680.977514402},
                                   {-3904.2191421106581, 341204.11540577176, 3750647.5311358985},
                                   {-13219.16504, 341236.84375, 3750567.5},
                                   {-13118.38184, 341625.5, 3749826.25},
                                   {-13078.712890000001, 341916.96875, 3749270.5},
                                   {-3000, 342492, 3748174}};
  std::vector<VertexId> v;
  for (const auto& [x, y, z] : kPoints) v.push_back(t.add(x, scale_y * y, scale_z * z));
  Constraints c;
  for (const auto& [i, j, k] : {std::array{0, 5, 2}, {2, 5, 6}, {1, 3, 4}, {1, 6, 7}, {2, 7, 8}, {9, 11, 10}}) {
    c.facets.push_back({{v[std::size_t(i)], v[std::size_t(j)], v[std::size_t(k)]}});
  }
  return c;
}

TEST_CASE("a point that no double can take goes into the next one", "[tetrahedra]") {
  PointTable t;
  const Constraints constraints = corner_of_faults(t, 1, 1);
  check(t, constraints, NewPoints::doubles);
}

TEST_CASE("other tetrahedra make room for a double", "[tetrahedra]") {
  PointTable t;
  const Constraints constraints = corner_of_faults(t, 0x1p-3, 0x1p-4);
  check(t, constraints, NewPoints::doubles);
}

TEST_CASE("points of a lattice, all of them on common spheres", "[tetrahedra]") {
  PointTable t;
  for (int i = 0; i < 125; ++i) t.add(i % 5, i / 5 % 5, i / 25);
  CHECK(check(t, {}) == 0);
}

TEST_CASE("points in one plane or on one line, one point, none", "[tetrahedra]") {
  for (const int count : {0, 1, 2, 5}) {
    PointTable line, plane;
    for (int i = 0; i < count; ++i) line.add(i, 2 * i, 1), plane.add(i % 2, i / 2, 7);
    CHECK(check(line, {}) == 0);
    CHECK(check(plane, {}) == 0);
  }
}

// Its sides leave no tetrahedron between six corners (Schönhardt, 1928), so none of it fills it without a new
// point.
TEST_CASE("a prism that is turned needs points", "[tetrahedra]") {
  PointTable t;
  for (int i = 0; i < 6; ++i) {
    const double angle = (i % 3) * 2 * M_PI / 3 + (i < 3 ? 0 : M_PI / 6);
    t.add(std::cos(angle), std::sin(angle), i / 3);
  }
  const auto v = [](int i) { return VertexId(static_cast<std::size_t>(i)); };
  Constraints c;
  c.facets = {{{v(0), v(2), v(1)}}, {{v(3), v(4), v(5)}}};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    c.facets.push_back({{v(i), v(j), v(i + 3)}});
    c.facets.push_back({{v(j), v(j + 3), v(i + 3)}});
  }
  check(t, c);
}

TEST_CASE("a facet with a hole, a wire and a point in it is one facet", "[tetrahedra]") {
  PointTable t;
  const auto v = [](int i) { return VertexId(static_cast<std::size_t>(i)); };
  for (const auto& [x, y] : {std::pair(0, 0), {6, 0}, {6, 6}, {0, 6}, {2, 2}, {4, 2}, {4, 4}, {2, 4}})
    t.add(x, y, 0);
  t.add(3, 3, 1), t.add(5, 1, -2), t.add(1, 5, 2);
  Constraints c;
  auto& facet = c.facets.emplace_back();
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    facet.push_back({v(i), v(j), v(4 + j)});
    facet.push_back({v(i), v(4 + j), v(4 + i)});
  }
  c.segments = {{v(1), v(5)}, {v(8), v(9)}, {v(8), v(10)}};
  check(t, c);
}

TEST_CASE("fans of thin triangles need no points", "[tetrahedra]") {
  PointTable t;
  constexpr int kSides = 60;
  const VertexId apex = t.add(0, 0, 100);
  for (int i = 0; i < kSides; ++i) t.add(std::cos(i * 2 * M_PI / kSides), std::sin(i * 2 * M_PI / kSides), 0);
  Constraints c;
  for (int i = 0; i < kSides; ++i) {
    c.facets.push_back({{VertexId(static_cast<std::size_t>(1 + i)),
                         VertexId(static_cast<std::size_t>(1 + (i + 1) % kSides)), apex}});
  }
  CHECK(check(t, c) == 0);
}

TEST_CASE("segments that nearly cross need no points", "[tetrahedra]") {
  for (const double distance : {1e-3, 1e-9, 1e-15}) {
    PointTable t;
    const VertexId a = t.add(-1, 0.125, 0), b = t.add(1, 0.25, 0);
    const VertexId p = t.add(0.3, -1, distance), q = t.add(0.1, 1, distance);
    Constraints c;
    c.segments = {{a, b}, {p, q}};
    CHECK(check(t, c) == 0);
  }
}

// A corner lies within a last digit of doubles of a line that others nearly cross; a Boolean of public meshes
// (MCUT) has it.
TEST_CASE("segments side by side, nearer than doubles tell, need no points", "[tetrahedra]") {
  PointTable t;
  const double low = -0.12500011920928961, high = 0.87499994039535522;
  const double z[] = {0.50000011920928955, 0.49999982118606567, 0.49999997019767761};
  const VertexId a = t.add(-2.5, 1.875, z[0]), far = t.add(1.5, low, z[1]), on = t.add(-0.5, high, z[2]);
  const VertexId p = t.add(-1.5, low, z[1]), q = t.add(0.5, high, z[2]), r = t.add(-0.5, low, z[1]);
  const VertexId s = t.add(-1.5, high, z[2]);
  Constraints c;
  c.segments = {{a, far}, {a, on}, {a, p}, {a, q}, {a, r}, {a, s}, {on, r}, {p, s}, {s, on}, {q, far}, {on, p}};
  CHECK(check(t, c) == 0);
}

// The corners of the box are on one sphere, too, and what fills it first must be Delaunay by the perturbation.
TEST_CASE("tetrahedra are Delaunay, those of the box, too", "[tetrahedra]") {
  for (const auto& [count, random_points] : {std::pair(0, false), {1, false}, {27, false}, {40, true}}) {
    PointTable t;
    std::mt19937_64 random(7);
    const auto any = [&] { return static_cast<double>(random() % 1000); };
    for (int i = 0; i < count; ++i) {
      if (random_points) t.add(any(), any(), any());
      else t.add(i % 3, i / 3 % 3, i / 9);
    }
    const Tetrahedra made(t);
    for (Tetrahedra::Index i = 0; i < made.size(); ++i) {
      if (!made.alive(i)) continue;
      const auto& c = made.corners(i);
      for (std::size_t k = 0; k < t.size(); ++k) {
        const VertexId v(k);
        if (std::find(c.begin(), c.end(), v) == c.end())
          REQUIRE(in_sphere_perturbed(t, c[0], c[1], c[2], c[3], v) < 0);
      }
    }
  }
}

TEST_CASE("triangles that cross are told, not believed", "[tetrahedra]") {
  PointTable t;
  t.add(-1, -1, 0), t.add(1, -1, 0), t.add(0, 2, 0), t.add(0, 0, -1), t.add(0.1, 0, 1), t.add(0, 9, 1);
  const auto v = [](int i) { return VertexId(static_cast<std::size_t>(i)); };
  Constraints c;
  c.facets = {{{v(0), v(1), v(2)}}, {{v(3), v(4), v(5)}}};
  CHECK_THROWS_AS(constrained_tetrahedra(t, c, {}), InvariantError);
}

}  // namespace
}  // namespace cnrg
