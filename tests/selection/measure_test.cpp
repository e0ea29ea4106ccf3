// Exact measures against numbers known by hand, Euler-Poincare against known topology.
#include "kernel/selection/measure.h"

#include <cmath>

#include "tests/catch.h"
#include "tests/operators/pieces.h"

namespace cnrg {
namespace {

using namespace pieces;

CellSet closed(const Complex& complex, std::vector<RegionId> regions) {
  CellSet set;
  set.regions = std::move(regions);
  return closure(complex, set);
}

std::vector<RegionId> bounded_regions(const Complex& complex) {
  std::vector<RegionId> out;
  for (std::size_t r = 1; r < complex.region_count; ++r) out.push_back(RegionId(r));
  return out;
}

TEST_CASE("volumes of cells with constructed corners add up exactly", "[measure]") {
  // A tetrahedron and its image under a shear cut each other in constructed points.
  Soup soup;
  const double corners[2][4][3] = {{{0, 0, 0}, {0.1, 0, 0}, {0, 0.7, 0}, {0, 0, 1e-3}},
                                   {{0.01, 0.1, -1e-3}, {0.09, 0.03, 2e-4}, {0.02, 0.5, 1e-4}, {0.05, 0.2, 2e-3}}};
  for (const auto& tetrahedron : corners) {
    const LeafId leaf = soup.add_leaf(Fill::winding);
    PointId p[4];
    for (int i = 0; i < 4; ++i) p[i] = soup.add_point(tetrahedron[i][0], tetrahedron[i][1], tetrahedron[i][2]);
    const int facets[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    for (int f = 0; f < 4; ++f) {
      soup.add_triangle(leaf, p[facets[f][0]], p[facets[f][1]], p[facets[f][2]], static_cast<std::uint32_t>(f),
                        static_cast<std::uint32_t>(f));
    }
  }
  const auto built_complex = build_complex(soup);
  const Complex& complex = *built_complex;
  REQUIRE(complex.region_count >= 4);
  const auto six_volume = [&](int i) {
    std::array<RationalPoint, 3> d;
    for (int k = 0; k < 3; ++k) {
      for (int j = 0; j < 3; ++j) d[k][j] = from_double(corners[i][k + 1][j]) - from_double(corners[i][0][j]);
    }
    Rational det = 0;
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      det += d[0][k] * (d[1][i] * d[2][j] - d[1][j] * d[2][i]);
    }
    return Rational(abs(det));
  };
  for (std::uint32_t leaf : {0u, 1u}) {
    std::vector<RegionId> cells;
    Rational total = 0;
    for (RegionId r : bounded_regions(complex)) {
      for (const Label& label : complex.labels(r)) {
        if (label.leaf == LeafId(leaf)) cells.push_back(r), total += *volume(complex, r);
      }
    }
    CHECK(total * 6 == six_volume(static_cast<int>(leaf)));
    CHECK(*volume(complex, cells) == total);
  }
  CHECK(!volume(complex, RegionId(0)));
}

TEST_CASE("the volume of a cell with thousands of faces is exact", "[measure]") {
  const auto complex = complex_of({box({0, 0, 0}, {40, 40, 40}, 1, 0, 40)});
  REQUIRE(complex->face_count() == 2 * 40 * 40 + 4);
  CHECK(*volume(*complex, RegionId(1)) == 40 * 40 * 40);
}

TEST_CASE("lengths and areas", "[measure]") {
  const auto built_complex = complex_of({sheet({0, 0, 5}, {3, 4, 5}), wire({1, 1, 5}, {2, 1, 5})});
  const Complex& complex = *built_complex;
  REQUIRE(complex.face_count() == 1);
  CHECK(squared_area(complex, FaceId(0)) == 144);
  const RationalPoint n = area_vector(complex, FaceId(0));
  CHECK(n[0] == 0);
  CHECK(abs(n[2]) == 12);
  Rational sum = 0;
  for (EdgeId e : IdRange<EdgeId>(complex.edge_count())) sum += squared_length(complex, e);
  CHECK(sum == 2 * 9 + 2 * 16 + 1);
}

TEST_CASE("square roots have the digits that were asked for", "[measure]") {
  CHECK(square_root(0) == 0);
  CHECK(square_root(144) == 12);
  CHECK(square_root(Rational(4, 9)) == Rational(2, 3));
  CHECK(to_decimal(square_root(2), 19) == "1.414213562373095049");
  const Rational tiny("1/1000000000000000000000000000000000000000000000000000000000002");
  const Rational root = square_root(tiny, 25);
  CHECK(abs(root * root / tiny - 1) < Rational("1/1000000000000000000000000"));
}

TEST_CASE("terms of Euler and Poincare", "[euler]") {
  SECTION("a frame of boxes around a hole, with a cavity in one of them") {
    const auto built_complex =
        complex_of({box({0, 0, 0}, {9, 9, 3}), box({3, 3, 0}, {6, 6, 3}), box({1, 1, 1}, {2, 2, 2})});
    const Complex& complex = *built_complex;
    std::vector<RegionId> ring;
    for (RegionId r : bounded_regions(complex)) {
      if (complex.labels(r).size() == 1) ring.push_back(r);
    }
    REQUIRE(ring.size() == 1);
    const CellSet set = closed(complex, ring);
    const auto t = euler_terms(complex, set);
    CHECK(t.r == 2);
    CHECK(t.volumes == 1);
    CHECK(t.volume_holes == 1);
    CHECK(t.volume_cavities == 1);
    CHECK(t.pieces == 1);
    CHECK(t.holes == 1);
    CHECK(t.cavities == 1);
    CHECK(t.left() == t.right());
    CHECK(check_euler(complex, set) == "");
    CellSet broken = set;
    broken.faces.pop_back();
    CHECK(check_euler(complex, broken) != "");
  }
  SECTION("two boxes that meet in a vertex, and loops of wire in and outside") {
    const Piece loop = wire({1, 1, 1}, {2, 1, 1}) + wire({2, 1, 1}, {2, 2, 1}) + wire({2, 2, 1}, {1, 1, 1});
    const auto built_complex = complex_of({box({0, 0, 0}, {4, 4, 4}) + box({4, 4, 4}, {6, 6, 6}), loop,
                                           wire({4, 0, 0}, {9, 0, 0}) + point({8, 8, 8})});
    const Complex& complex = *built_complex;
    const CellSet set = all_cells(complex);
    CellSet bounded = set;
    bounded.regions = bounded_regions(complex);
    const auto t = euler_terms(complex, bounded);
    CHECK(t.pieces == 2);
    CHECK(t.volume_cavities == 1);
    CHECK(t.volume_holes == 1);  // around the loop
    CHECK(t.holes == 0);         // the loop is filled by its region
    CHECK(t.cavities == 0);
    CHECK(check_euler(complex, bounded) == "");
    CellSet walls = bounded;
    walls.regions.clear();
    const auto flat = euler_terms(complex, walls);
    CHECK(flat.holes == 1);
    CHECK(flat.cavities == 2);
  }
}

}  // namespace
}  // namespace cnrg
