// The six kinds of pairs in contact (Gursoz et al. 1991), wires and points among faces.
#include <set>

#include "kernel/base/error.h"
#include "tests/catch.h"
#include "tests/refine/expectation.h"
#include "tests/scenes/fixture.h"
#include "tests/scenes/measure.h"
#include "tests/scenes/seeds.h"

namespace cnrg::scenes {
namespace {

/// Kinds in the order of RefineReport::contacts.
enum Kind : std::size_t { face_face, face_edge, face_vertex, edge_edge, edge_vertex, vertex_vertex };

std::uint64_t contacts(const std::string& fixture, Kind kind) {
  RefineReport report;
  valid_complex(parse_fixture(fixture), {}, &report);
  return report.contacts[kind];
}

}  // namespace

TEST_CASE("Face and face cross", "[contacts]") {
  const char* f = "leaf none\nface 0 0 0, 4 0 0, 0 4 0\nleaf none\nface 1 1 -1, 1 1 3, 1 -5 1";
  // The segment from (1, 1, 0) - on the edge of the second - to the border (1, 0, 0) of the first; the second goes
  // on.
  expect(f, {3 + 3 + 2, 4 + 4 + 1 + 0, 2, 1});
  CHECK(contacts(f, face_face) + contacts(f, face_edge) + contacts(f, edge_edge) > 0);
}

TEST_CASE("Face and face overlap", "[contacts]") {
  const char* f = "leaf none\nface 0 0 0, 4 0 0, 0 4 0\nleaf none\nface 1 1 0, 5 1 0, 1 5 0";
  expect(f, {3 + 3 + 2, 5 + 5, 3, 1});
}

TEST_CASE("Face and edge", "[contacts]") {
  const char* pierced = "leaf none\nface 0 0 0, 4 0 0, 0 4 0\nleaf none\nwire 1 1 -1, 1 1 1";
  expect(pierced, {3 + 2 + 1, 3 + 2, 1, 1});
  CHECK(contacts(pierced, face_edge) == 1);
  const char* touched = "leaf none\nface 0 0 0, 4 0 0, 0 4 0\nleaf none\nwire 1 1 0, 1 1 1";
  expect(touched, {3 + 2, 3 + 1, 1, 1});
  // In the plane: from outside into the face, and from side to side.
  expect("leaf none\nface 0 0 0, 4 0 0, 0 4 0\nleaf none\nwire 1 1 0, 1 -1 0", {3 + 2 + 1, 3 + 1 + 2, 1, 1});
  expect("leaf none\nface 0 0 0, 4 0 0, 0 4 0\nleaf none\nwire -1 1 0, 5 1 0", {3 + 2 + 2, 3 + 2 + 3, 2, 1});
}

TEST_CASE("Face and vertex", "[contacts]") {
  const char* f = "leaf none\nface 0 0 0, 4 0 0, 0 4 0\nleaf none\npoint 1 1 0";
  expect(f, {4, 3, 1, 1});
  CHECK(contacts(f, face_vertex) == 1);
  const auto built_c = valid_complex(f);
  const Complex& c = *built_c;
  REQUIRE(c.face_vertices[FaceId(0)].size() == 1);
}

TEST_CASE("Edge and edge", "[contacts]") {
  const char* f = "leaf none\nwire -1 0 0, 1 0 0\nleaf none\nwire 0 -1 0, 0 1 0";
  expect(f, {5, 4, 0, 1});
  CHECK(contacts(f, edge_edge) == 1);
  // On one line, overlapping in part; contained; equal.
  expect("leaf none\nwire 0 0 0, 2 0 0\nleaf none\nwire 1 0 0, 3 0 0", {4, 3, 0, 1});
  expect("leaf none\nwire 0 0 0, 3 0 0\nleaf none\nwire 1 0 0, 2 0 0", {4, 3, 0, 1});
  expect("leaf none\nwire 0 0 0, 3 3 3\nleaf none\nwire 3 3 3, 0 0 0", {2, 1, 0, 1});
  // Skew: no contact.
  expect("leaf none\nwire -1 0 0, 1 0 0\nleaf none\nwire 0 -1 0x1p-1000, 0 1 0x1p-1000", {4, 2, 0, 1});
}

TEST_CASE("Edge and vertex", "[contacts]") {
  const char* f = "leaf none\nwire -1 -1 -1, 1 1 1\nleaf none\npoint 1/3 1/3 1/3";
  expect(f, {3, 2, 0, 1});
  CHECK(contacts(f, edge_vertex) == 1);
  expect("leaf none\nwire 0 0 0, 3 0 0\nwire 1 0 0, 1 2 0", {4, 3, 0, 1});
}

TEST_CASE("Vertex and vertex", "[contacts]") {
  const char* f = "leaf none\npoint 1/3 2 3\nleaf none\npoint 1/3 2 3\nleaf none\npoint 1/3 2 0x1p-1";
  expect(f, {2, 0, 0, 1});
  const auto built_c = valid_complex(f);
  const Complex& c = *built_c;
  CHECK(c.region_vertices[RegionId(0)].size() == 2);
  CHECK(contacts(f, vertex_vertex) == 1);
}

TEST_CASE("Vertices in one place are counted for every pair of leaves", "[contacts]") {
  // Corners, ends of wires and points alike; three leaves in one place are three pairs.
  const std::string face = "leaf none\nface 0 0 0, 4 0 0, 0 4 0\n";
  CHECK(contacts(face + "leaf none\nwire 4 0 0, 4 0 4\nleaf none\npoint 0 4 0", vertex_vertex) == 2);
  CHECK(contacts(face + "leaf none\nwire 4 0 0, 4 0 4\nleaf none\npoint 4 0 0", vertex_vertex) == 3);
  CHECK(contacts(face + face, vertex_vertex) == 3);
  CHECK(contacts(face + face + face, vertex_vertex) == 9);
  // Within a leaf equal points are one vertex, whatever is on them.
  CHECK(contacts(face + "face 0 0 0, 4 0 0, 0 0 4\nwire 0 0 0, 0 0 -4\npoint 0 0 0", vertex_vertex) == 0);
  // A face that reaches no corner of the other, though it shares a part of its border.
  CHECK(contacts(face + "leaf none\nface 1 0 0, 3 0 0, 2 1 0", vertex_vertex) == 0);
  // Boxes that share a wall, an edge, a corner.
  const std::string box = "leaf sides\nbox 0 0 0, 1 1 1\n";
  CHECK(contacts(box + "leaf sides\nbox 1 0 0, 2 1 1", vertex_vertex) == 4);
  CHECK(contacts(box + "leaf sides\nbox 1 1 0, 2 2 1", vertex_vertex) == 2);
  CHECK(contacts(box + "leaf sides\nbox 1 1 1, 2 2 2", vertex_vertex) == 1);
}

TEST_CASE("Vertices in one place are as many as equal coordinates say", "[contacts]") {
  const auto [first, last] = seeds(60);
  std::uint64_t total = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const std::vector<Leaf> leaves = random_leaves(seed, 4, Position::degenerate);
    std::vector<std::set<RationalPoint>> corners;
    for (const Leaf& leaf : leaves) {
      std::set<RationalPoint>& all = corners.emplace_back(leaf.points.begin(), leaf.points.end());
      for (const auto& wire : leaf.wires) all.insert(wire.begin(), wire.end());
      for (const Face& face : leaf.faces) {
        for (const Polygon& loop : face.loops) all.insert(loop.begin(), loop.end());
      }
    }
    std::uint64_t expected = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (const RationalPoint& p : corners[i]) expected += corners[j].count(p);
      }
    }
    RefineReport report;
    build_complex(make_soup(leaves), {}, &report);
    INFO("seed " << seed);
    CHECK(report.contacts[vertex_vertex] == expected);
    total += expected;
  }
  CHECK(total > 0);
}

TEST_CASE("A wire through a corner of a face", "[contacts]") {
  expect("leaf none\nface 0 0 0, 2 -1 0, 2 0 -1\nleaf none\nwire -1 -1 -1, 1 1 1", {5, 5, 1, 1});
}

TEST_CASE("A wire through a corner that many faces share", "[contacts]") {
  // The tip of a pyramid without base.
  expect(
      "leaf none\nface 0 0 0, 1 0 1, 0 1 1\nface 0 0 0, 0 1 1, -1 0 1\nface 0 0 0, -1 0 1, 0 -1 1\n"
      "face 0 0 0, 0 -1 1, 1 0 1\nleaf none\nwire 0 0 -1, 0 0 1",
      {5 + 2, 8 + 2, 4, 1});
}

TEST_CASE("Wires cross in a face", "[contacts]") {
  expect("leaf none\nface 0 0 0, 4 0 0, 4 4 0, 0 4 0\nleaf none\nwire 1 1 0, 3 3 0\nleaf none\nwire 1 3 0, 3 1 0",
         {9, 8, 1, 1});
  expect("leaf none\nface 0 0 0, 4 0 0, 4 4 0, 0 4 0\nleaf none\nwire 2 2 -1, 2 2 1\nleaf none\nwire 1 2 0, 3 2 0",
         {9, 8, 1, 1});
}

TEST_CASE("Wires of which one ends before it reaches the other do not meet", "[contacts]") {
  // In one plane; the line of the second crosses the first at 3 3 0, beyond its end, and the other way round.
  expect("leaf none\nwire 0 0 0, 4 4 0\nleaf none\nwire 3 0 0, 3 2 0", {4, 2, 0, 1});
  expect("leaf none\nwire 3 0 0, 3 2 0\nleaf none\nwire 0 0 0, 4 4 0", {4, 2, 0, 1});
}

TEST_CASE("Along a line that doubles take for upright points are in order", "[contacts]") {
  // In the plane z = 0 a face leaves the trace from y = 1 down to y = -1; x grows by one in 10^30. A triangle ends
  // on its middle, and a wire runs from there beyond its lower end.
  const char* flat = "leaf none\nface -3 -3 0, 3 -3 0, 3 3 0, -3 3 0\n";
  for (const Rational& growth : {Rational("1"), Rational("1/1000000000000000000000000000000")}) {
    const auto at = [&](int y, int z) {
      const Rational x = Rational(1, 3) + growth * (1 - y) / 2;
      return x.get_str() + ' ' + std::to_string(y) + ' ' + std::to_string(z);
    };
    expect(flat + ("leaf none\nface " + at(1, -1) + ", " + at(-1, -1) + ", " + at(-1, 1) + ", " + at(1, 1)) +
               "\nleaf none\nface " + at(0, 0) + ", 2 0 0, 2 0 1\nleaf none\nwire " + at(0, 0) + ", " + at(-2, 0),
           {4 + 6 + 3 + 1, 4 + 6 + 2 + 3 + 1, 1 + 2 + 1, 1});
  }
}

TEST_CASE("Triangles around a tip that go around more than once meet each other", "[contacts]") {
  // Nine eighths of a turn, all facing up: the first and the last cross each other along a line from the tip.
  const char* rim[] = {"1 0 1",   "1 1 0",  "0 1 0",  "-1 1 0", "-1 0 0",
                       "-1 -1 0", "0 -1 0", "1 -1 0", "1 0 0",  "1 1 1"};
  std::string fan = "leaf none\n";
  for (std::size_t i = 0; i + 1 < std::size(rim); ++i) {
    fan += std::string("face 0 0 0, ") + rim[i] + ", " + rim[i + 1] + "\n";
  }
  expect(fan, {11 + 1, 19 + 2 + 1, 9 + 2, 1});
}

TEST_CASE("A closed wire in a face parts it", "[contacts]") {
  expect("leaf none\nface 0 0 0, 4 0 0, 4 4 0, 0 4 0\nleaf none\nwire 1 1 0, 3 1 0, 2 3 0, 1 1 0", {7, 7, 2, 1});
}

TEST_CASE("Points on edges, vertices and in faces", "[contacts]") {
  expect("leaf none\nface 0 0 0, 4 0 0, 0 4 0\nleaf none\npoint 2 0 0\npoint 4 0 0\npoint 1 1 0\npoint 2 2 0",
         {3 + 3, 5, 1, 1});
}

TEST_CASE("A slit from the border into a face", "[contacts]") {
  const char* f = "leaf none\nface 0 0 0, 2 0 0, 2 2 0, 0 2 0\nleaf none\nwire 0 0 0, 1 1 0";
  expect(f, {5, 5, 1, 1});
  const auto built_c = valid_complex(f);
  const Complex& c = *built_c;
  std::size_t twice = 0;
  for (const EdgeId e : IdRange<EdgeId>(c.edge_count())) twice += c.edge_uses[e].size() == 2;
  CHECK(twice == 1);
}

TEST_CASE("An edge of one face inside another face, which goes on beyond", "[contacts]") {
  expect("leaf none\nface 0 0 0, 4 0 0, 4 4 0, 0 4 0\nleaf none\nface 1 1 0, 3 1 0, 2 1 2", {7, 7, 2, 1});
}

TEST_CASE("A vertex of one face on an edge, in the inside and on a vertex of another", "[contacts]") {
  const std::string square = "leaf none\nface 0 0 0, 4 0 0, 4 4 0, 0 4 0\nleaf none\n";
  expect(square + "face 2 0 0, 2 -1 1, 3 -1 1", {7, 8, 2, 1});
  expect(square + "face 2 2 0, 2 1 1, 3 1 1", {7, 7, 2, 1});
  expect(square + "face 0 0 0, -1 0 1, -1 1 1", {6, 7, 2, 1});
}

TEST_CASE("Coordinates from 1e-300 to 1e300", "[contacts]") {
  const std::string decimal =
      "leaf sides\nbox 1e-300 1e-300 1e-300, 1e300 1e300 1e300\nleaf none\nwire -1e300 0.5 0.5, 2e300 0.5 0.5";
  const std::string binary =
      "leaf sides\nbox 0x1p-996 0x1p-996 0x1p-996, 0x1p996 0x1p996 0x1p996\n"
      "leaf none\nwire -0x1p996 0.5 0.5, 0x1p997 0.5 0.5";
  for (const std::string& f : {decimal, binary}) {
    for (const bool share : {true, false}) {
      SoupOptions options;
      options.share_points = share;
      const auto built_c = valid_complex(parse_fixture(f), options);
      const Complex& c = *built_c;
      CHECK(c.vertex_count() == 8 + 2 + 2);
      CHECK(c.edge_count() == 12 + 3);
      CHECK(c.face_count() == 6);
      CHECK(c.region_count == 2);
    }
  }
  const Rational edge = from_double(0x1p996) - from_double(0x1p-996);
  CHECK((volumes(*valid_complex(binary)) == std::vector<Rational>{edge * edge * edge}));
  CHECK_NOTHROW(valid_complex("leaf none\nwire 0 0 0, 1.797e308 0 0"));
  CHECK_THROWS_AS(valid_complex("leaf none\nwire 0 0 0, 1e309 0 0"), InputError);
}

}  // namespace cnrg::scenes
