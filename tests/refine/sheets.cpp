// The degenerate corpus in one plane and across planes: faces that overlap, touch, repeat or vanish.
//
// Counts are derived by hand: V - E + (sum of chi_c of the faces) is the Euler characteristic of the union.

#include "kernel/base/error.h"
#include "tests/catch.h"
#include "tests/refine/expectation.h"
#include "tests/scenes/fixture.h"

namespace cnrg::scenes {

TEST_CASE("One triangle", "[sheets]") { expect("leaf none\nface 0 0 0, 1 0 0, 0 1 0", {3, 3, 1, 1}); }

TEST_CASE("Duplicate triangles are one face with two covers", "[sheets]") {
  const char* same = "leaf none\nface 0 0 0, 1 0 0, 0 1 0\nleaf none\nface 1 0 0, 0 1 0, 0 0 0";
  const char* opposite = "leaf none\nface 0 0 0, 1 0 0, 0 1 0\nleaf none\nface 0 0 0, 0 1 0, 1 0 0";
  const char* within = "leaf none\nface 0 0 0, 1 0 0, 0 1 0\nface 1 0 0, 0 1 0, 0 0 0";
  for (const char* fixture : {same, opposite, within}) {
    expect(fixture, {3, 3, 1, 1});
    const auto built_c = valid_complex(fixture);
    const Complex& c = *built_c;
    REQUIRE(c.cover(FaceId(0)).size() == 2);
    CHECK((c.cover(FaceId(0))[0].same == c.cover(FaceId(0))[1].same) == (fixture != opposite));
  }
}

TEST_CASE("T-junction within a plane", "[sheets]") {
  // The long edge from 0 to 2 is cut at 1 by the two small triangles below it.
  expect("leaf none\nface 0 0 0, 2 0 0, 1 2 0\nface 0 0 0, 1 -1 0, 1 0 0\nface 1 0 0, 1 -1 0, 2 0 0",
         {5, 7, 3, 1});
}

TEST_CASE("T-junction across planes", "[sheets]") {
  expect("leaf none\nface 0 0 0, 2 0 0, 1 2 0\nleaf none\nface 1 0 0, 1 -1 1, 1 -1 -1", {6, 7, 2, 1});
}

TEST_CASE("Coplanar squares overlap in part", "[sheets]") {
  expect("leaf none\nface 0 0 0, 2 0 0, 2 2 0, 0 2 0\nleaf none\nface 1 1 0, 3 1 0, 3 3 0, 1 3 0", {10, 12, 3, 1});
}

TEST_CASE("A coplanar square inside another", "[sheets]") {
  expect("leaf none\nface 0 0 0, 3 0 0, 3 3 0, 0 3 0\nleaf none\nface 1 1 0, 1 2 0, 2 2 0, 2 1 0", {8, 8, 2, 1});
}

TEST_CASE("A coplanar square inside another, sharing part of an edge", "[sheets]") {
  expect("leaf none\nface 0 0 0, 3 0 0, 3 3 0, 0 3 0\nleaf none\nface 1 0 0, 2 0 0, 2 1 0, 1 1 0", {8, 9, 2, 1});
}

TEST_CASE("A hole that another face plugs", "[sheets]") {
  const char* frame = "leaf none\nface 0 0 0, 3 0 0, 3 3 0, 0 3 0 | 1 1 0, 2 1 0, 2 2 0, 1 2 0\n";
  expect(frame, {8, 8, 1, 1});
  expect(std::string(frame) + "leaf none\nface 1 1 0, 2 1 0, 2 2 0, 1 2 0", {8, 8, 2, 1});
  expect(std::string(frame) + "leaf none\nface 0 0 0, 3 0 0, 3 3 0, 0 3 0", {8, 8, 2, 1});
  // Half of the hole.
  expect(std::string(frame) + "leaf none\nface 1 1 0, 2 1 0, 2 2 0", {8, 9, 2, 1});
}

TEST_CASE("A hole that touches the outer loop in a vertex", "[sheets]") {
  expect("leaf none\nface 0 0 0, 4 0 0, 4 4 0, 0 4 0 | 2 0 0, 3 1 0, 1 1 0", {7, 8, 1, 1});
}

TEST_CASE("Two holes that touch each other and the outer loop part the face", "[sheets]") {
  // From the left border to the right one: the face falls into two.
  expect("leaf none\nface 0 0 0, 4 0 0, 4 4 0, 0 4 0 | 0 2 0, 1 1 0, 2 2 0, 1 3 0 | 2 2 0, 3 1 0, 4 2 0, 3 3 0",
         {4 + 7, 6 + 8, 2, 1});
}

TEST_CASE("Overlapping frames", "[sheets]") {
  // Two square frames shifted along x by 2: outer squares [0,6] and [2,8], holes [1,5] and [3,7].
  // Vertical lines x = 0 1 2 3 5 6 7 8; rows y = 0 1 5 6 hold edges of both frames where they overlap.
  expect(
      "leaf none\nface 0 0 0, 6 0 0, 6 6 0, 0 6 0 | 1 1 0, 5 1 0, 5 5 0, 1 5 0\n"
      "leaf none\nface 2 0 0, 8 0 0, 8 6 0, 2 6 0 | 3 1 0, 7 1 0, 7 5 0, 3 5 0",
      // Faces: two C shapes, the strips on top and bottom, two bars.
      // y = 0 and 6: x = 0 2 6 8; y = 1 and 5: x = 1 2 3 5 6 7. The verticals x = 2 and x = 6 pass through y = 1
      // and 5 from border to border. Edges: 2 * 3 on the outer rows, 2 * 5 on the inner ones, x = 0 and 8: one
      // each, x = 1, 3, 5, 7: one each, x = 2 and 6: three each.
      {8 + 12, 6 + 10 + 2 + 4 + 6, 6, 1});
}

TEST_CASE("A sliver crossed by a triangle", "[sheets]") {
  expect("leaf none\nface 0 0 0, 1 0 0, 1/2 0x1p-60 0\nleaf none\nface 1/2 -1 -1, 1/2 1 -1, 1/2 0 1",
         {7, 8, 3, 1});
}

TEST_CASE("A stack of slivers that share an edge", "[sheets]") {
  expect(
      "leaf none\n"
      "face 0 0 0, 1 0 0, 1/2 0x1p-100 0\n"
      "face 0 0 0, 1 0 0, 1/2 0x1p-100 0x1p-200\n"
      "face 0 0 0, 1 0 0, 1/2 0x1p-100 0x1p-300\n"
      "face 0 0 0, 1 0 0, 1/2 0x1p-101 0x1p-201",  // in the plane of the second, inside of it
      {6, 9, 4, 1});
}

TEST_CASE("Faces without area are dropped and reported", "[sheets]") {
  const auto leaves = parse_fixture(
      "leaf none\nface 0 0 0, 1 0 0, 0 1 0\nface 0 0 1, 1 0 1, 2 0 1\nface 0 0 0, 1/3 1/3 1/3, 0 0 0\n"
      "face 5 5 5, 5 5 5, 5 5 5");
  expect(leaves, {3, 3, 1, 1});
  RefineReport report;
  valid_complex(leaves, {}, &report);
  CHECK(report.zero_area.size() == 3);
}

TEST_CASE("A face that is not planar is bad input", "[sheets]") {
  const auto leaves = parse_fixture("leaf none\nface 0 0 0, 1 0 0, 1 1 0x1p-900, 0 1 0");
  CHECK_THROWS_AS(build_complex(make_soup(leaves)), InputError);
}

TEST_CASE("Three planes through one point", "[sheets]") {
  const std::string three =
      "leaf none\nface -1 -1 0, 1 -1 0, 1 1 0, -1 1 0\nface 0 -1 -1, 0 1 -1, 0 1 1, 0 -1 1\n"
      "face -1 0 -1, -1 0 1, 1 0 1, 1 0 -1\n";
  expect(three, {19, 30, 12, 1});
  // A fourth one through the z axis; it halves two quadrants of the first.
  expect(three + "leaf none\nface -1 -1 -1, 1 1 -1, 1 1 1, -1 -1 1", {23, 40, 18, 1});
}

TEST_CASE("A fan of many faces about one edge keeps its radial order", "[sheets]") {
  // Twelve half-planes about the z axis as triangles; opposite ones are coplanar.
  std::string fan = "leaf none\n";
  for (const char* p :
       {"3 0", "3 1", "1 3", "0 3", "-1 3", "-3 1", "-3 0", "-3 -1", "-1 -3", "0 -3", "1 -3", "3 -1"})
    fan += "face 0 0 -1, 0 0 1, " + std::string(p) + " 0\n";
  expect(fan, {14, 25, 12, 1});
  const auto built_c = valid_complex(fan);
  const Complex& c = *built_c;
  for (const EdgeId e : IdRange<EdgeId>(c.edge_count()))
    CHECK((c.edge_uses[e].size() == 1 || c.edge_uses[e].size() == 12));
}

TEST_CASE("Two faces cross along a segment that ends inside both", "[sheets]") {
  // A horizontal square and a vertical triangle with an edge through it.
  expect("leaf none\nface 0 0 0, 4 0 0, 4 4 0, 0 4 0\nleaf none\nface 1 2 1, 3 2 1, 2 2 -1",
         {4 + 3 + 2, 4 + 3 + 2 + 1, 3, 1});
}

TEST_CASE("Rational coordinates", "[sheets]") {
  expect(
      "leaf none\nface 1/3 1/7 0, 22/7 1/7 0, 22/7 355/113 0, 1/3 355/113 0\n"
      "leaf none\nface 1 1/7 -1/9, 1 1/7 1/11, 1 355/113 1/11, 1 355/113 -1/9",
      // They cross along x = 1 from border to border: the corners of the second lie off, its sides are cut.
      {4 + 4 + 2, 6 + 6 + 1, 4, 1});
}

}  // namespace cnrg::scenes
