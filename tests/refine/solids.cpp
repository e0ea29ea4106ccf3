// The degenerate corpus of solids. Counts are derived by hand; with cells that are all balls V - E + F - R = 0.
#include <map>
#include <set>

#include "kernel/base/error.h"
#include "tests/catch.h"
#include "tests/refine/expectation.h"
#include "tests/scenes/fixture.h"
#include "tests/scenes/measure.h"

namespace cnrg::scenes {
namespace {

/// Bounded regions that carry exactly the labels of these leaves (region 1 each), with their volumes summed.
Rational labelled(const Complex& c, const std::set<std::size_t>& leaves) {
  Rational sum = 0;
  for (const RegionId r : IdRange<RegionId>(c.region_count)) {
    std::set<std::size_t> found;
    for (const Label& label : c.labels(r)) found.insert(label.leaf.index());
    if (found == leaves && !c.unbounded(r)) sum += volume(c, r);
  }
  return sum;
}

const std::string kUnit = "box 0 0 0, 1 1 1\n";

/// Cells of a set of unit cubes, counted on doubled coordinates without any geometry.
struct GridCounts {
  std::set<std::array<int, 3>> cells[4];
  std::map<std::array<int, 3>, int> face_cubes;
  explicit GridCounts(const std::set<std::array<int, 3>>& cubes) {
    for (const auto& [x, y, z] : cubes)
      for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
          for (int k = -1; k <= 1; ++k) {
            const std::array<int, 3> cell{2 * x + 1 + i, 2 * y + 1 + j, 2 * z + 1 + k};
            const int dimension = 3 - (i != 0) - (j != 0) - (k != 0);
            cells[dimension].insert(cell);
            if (dimension == 2) ++face_cubes[cell];
          }
  }
};

/// Cubes of the Menger sponge; a cube stays unless two of its digits in one place are 1.
std::set<std::array<int, 3>> sponge(int level) {
  int size = 1;
  for (int i = 0; i < level; ++i) size *= 3;
  std::set<std::array<int, 3>> cubes;
  for (int x = 0; x < size; ++x)
    for (int y = 0; y < size; ++y)
      for (int z = 0; z < size; ++z) {
        bool stays = true;
        for (int a = x, b = y, c = z; a + b + c > 0; a /= 3, b /= 3, c /= 3)
          stays = stays && (a % 3 == 1) + (b % 3 == 1) + (c % 3 == 1) < 2;
        if (stays) cubes.insert({x, y, z});
      }
  return cubes;
}

Leaf cube_leaf(const std::set<std::array<int, 3>>& cubes, Fill fill) {
  Leaf leaf;
  leaf.fill = fill;
  for (const auto& [x, y, z] : cubes) add_solid(leaf, box_solid({x, y, z}, {x + 1, y + 1, z + 1}), 0);
  return leaf;
}

}  // namespace

TEST_CASE("A box", "[solids]") { expect("leaf winding\n" + kUnit, {8, 12, 6, 2, {1}}); }

TEST_CASE("Which way round a base is that doubles cannot tell", "[solids]") {
  // The corners are nearly on one line: products of doubles say that the area is zero, it is 1.
  for (const char* base : {"0 0 0, 2147483649 2147483647 0, 2147483650 2147483648 0, 1073741825 1073741824 0",
                           "0 0 0, 1073741825 1073741824 0, 2147483650 2147483648 0, 2147483649 2147483647 0"}) {
    expect(std::string("leaf winding\nprism 0 0 1 | ") + base, {8, 12, 6, 2, {1}});
  }
  // A dart whose products are below the smallest double: their sum has the other sign, 3/32 2^-1074 is right.
  const std::string unit = "p-537 ";
  const auto corner = [&](const char* x, const char* y) { return x + unit + y + unit + "0"; };
  const std::string dart = corner("0x0", "0x0") + ", " + corner("0x0.7", "0x0") + ", " + corner("0x1", "0x1") +
                           ", " + corner("0x0.88", "0x0.78");
  const auto built = valid_complex("leaf winding\nprism 0 0 1 | " + dart);
  REQUIRE(built->region_count == 2);
  CHECK(volume(*built, RegionId(1)) == Rational(3, 16) / Rational(Integer(1) << 1074));
}

TEST_CASE("Equal boxes are one region with the labels of all", "[solids]") {
  const std::string three = "leaf winding\n" + kUnit + "leaf parity\n" + kUnit + "leaf sides\n" + kUnit;
  expect(three, {8, 12, 6, 2, {1}});
  CHECK(labelled(*valid_complex(three), {0, 1, 2}) == 1);
  // Twice in one leaf: winding number 2 is inside, parity 0 is not.
  CHECK(labelled(*valid_complex("leaf winding\n" + kUnit + kUnit), {0}) == 1);
  CHECK(labelled(*valid_complex("leaf parity\n" + kUnit + kUnit), {}) == 1);
}

TEST_CASE("Boxes overlap at a corner", "[solids]") {
  const std::string two = "leaf sides\nbox 0 0 0, 2 2 2\nleaf winding\nbox 1 1 1, 3 3 3";
  expect(two, {22, 36, 18, 4, {1, 7, 7}});
  const auto built_c = valid_complex(two);
  const Complex& c = *built_c;
  CHECK(labelled(c, {0, 1}) == 1);
  CHECK(labelled(c, {0}) == 7);
  CHECK(labelled(c, {1}) == 7);
}

TEST_CASE("A leaf that intersects itself", "[solids]") {
  const std::string boxes = "box 0 0 0, 2 2 2\nbox 1 1 1, 3 3 3\n";
  expect("leaf winding\n" + boxes, {22, 36, 18, 4, {1, 7, 7}});
  CHECK(labelled(*valid_complex("leaf winding\n" + boxes), {0}) == 15);
  CHECK(labelled(*valid_complex("leaf parity\n" + boxes), {0}) == 14);
  CHECK(labelled(*valid_complex("leaf cells\n" + boxes), {0}) == 15);
  CHECK(labelled(*valid_complex("leaf none\n" + boxes), {0}) == 0);
  CHECK(valid_complex("leaf cells\n" + boxes)->leaf_regions[LeafId(0)] == 3);
  // The sides contradict each other.
  CHECK_THROWS_AS(valid_complex("leaf sides\n" + boxes), InputError);
}

TEST_CASE("Boxes share a face", "[solids]") {
  expect("leaf sides\n" + kUnit + "leaf sides\nbox 1 0 0, 2 1 1", {12, 20, 11, 3, {1, 1}});
}

TEST_CASE("Boxes share part of a face", "[solids]") {
  expect("leaf sides\nbox 0 0 0, 2 2 2\nleaf sides\nbox 2 1/2 1/2, 3 3/2 3/2", {16, 24, 12, 3, {1, 8}});
  // Overlapping in part: walls [0,2]^2 and [1,3]^2 in the plane x = 2.
  expect("leaf sides\nbox 0 0 0, 2 2 2\nleaf sides\nbox 2 1 1, 4 3 3", {16 + 2, 24 + 4, 12 + 1, 3, {8, 8}});
}

TEST_CASE("Boxes share an edge", "[solids]") {
  expect("leaf sides\n" + kUnit + "leaf sides\nbox 1 1 0, 2 2 1", {14, 23, 12, 3, {1, 1}});
  expect("leaf winding\n" + kUnit + "box 1 1 0, 2 2 1", {14, 23, 12, 3, {1, 1}});
}

TEST_CASE("Boxes share part of an edge", "[solids]") {
  expect("leaf sides\n" + kUnit + "leaf sides\nbox 1 1 1/2, 2 2 3/2", {16, 25, 12, 3, {1, 1}});
}

TEST_CASE("Boxes share a vertex", "[solids]") {
  expect("leaf sides\n" + kUnit + "leaf sides\nbox 1 1 1, 2 2 2", {15, 24, 12, 3, {1, 1}});
}

TEST_CASE("Edges touch in their inside", "[solids]") {
  // The second box turned by 90 degrees in spirit: its lowest edge runs along y over the first one's along x.
  expect("leaf sides\nprism 4 0 0 | 0 -1 -1, 0 1 -1, 0 0 0\nleaf sides\nprism 0 4 0 | 1 -2 1, 3 -2 1, 2 -2 0",
         {6 + 6 + 1, 9 + 9 + 2, 10, 3, {4, 4}});
}

TEST_CASE("A corner touches a face", "[solids]") {
  expect("leaf sides\nbox -2 -2 -1, 2 2 0\nleaf sides\ntetrahedron 0 0 0, 1 0 1, 0 1 1, -1 -1 1",
         {8 + 4, 12 + 6, 6 + 4, 3, {Rational(1, 2), 16}});
}

TEST_CASE("One inside the other, sharing a wall", "[solids]") {
  expect("leaf sides\nbox 0 0 0, 3 3 3\nleaf sides\nbox 0 1 1, 1 2 2", {16, 24, 12, 3, {1, 26}});
}

TEST_CASE("Shells nested three deep", "[solids]") {
  const std::string boxes = "box 0 0 0, 7 7 7\nbox 1 1 1, 6 6 6\nbox 2 2 2, 5 5 5\n";
  for (const char* fill : {"parity", "winding", "cells", "none"})
    expect(std::string("leaf ") + fill + "\n" + boxes, {24, 36, 18, 4, {27, 98, 218}});
  CHECK(labelled(*valid_complex("leaf parity\n" + boxes), {0}) == 27 + 218);
  CHECK(labelled(*valid_complex("leaf winding\n" + boxes), {0}) == 343);
  // Two nests beside each other in the outermost one.
  expect(
      "leaf parity\nbox 0 0 0, 20 10 10\nbox 1 1 1, 9 9 9\nbox 11 1 1, 19 9 9\nbox 2 2 2, 3 3 3\n"
      "box 12 2 2, 13 3 3",
      {40, 60, 30, 6, {1, 1, 511, 511, 2000 - 1024}});
}

TEST_CASE("Linked square tori", "[solids]") {
  const std::string one =
      "leaf winding\n"
      "face 0 0 1, 5 0 1, 5 5 1, 0 5 1 | 1 1 1, 4 1 1, 4 4 1, 1 4 1\n"
      "face 0 0 0, 0 5 0, 5 5 0, 5 0 0 | 1 1 0, 4 1 0, 4 4 0, 1 4 0\n"
      "face 0 0 0, 5 0 0, 5 0 1, 0 0 1\nface 5 0 0, 5 5 0, 5 5 1, 5 0 1\n"
      "face 5 5 0, 0 5 0, 0 5 1, 5 5 1\nface 0 5 0, 0 0 0, 0 0 1, 0 5 1\n"
      "face 1 1 0, 1 1 1, 4 1 1, 4 1 0\nface 4 1 0, 4 1 1, 4 4 1, 4 4 0\n"
      "face 4 4 0, 4 4 1, 1 4 1, 1 4 0\nface 1 4 0, 1 4 1, 1 1 1, 1 1 0\n";
  expect(one, {16, 24, 10, 2, {16}});
  std::vector<Leaf> two = parse_fixture(one + one);
  // The second one upright, its left bar through the hole of the first one.
  Motion upright;
  upright.matrix = {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}};
  upright.offset = {2, 3, -2};
  apply(upright, two[1]);
  expect(two, {32, 48, 20, 3, {16, 16}});
  // Moved until both bars touch face to face: the bar of the first one at x in [4, 5], hole of the second from 3.
  upright.offset = {1, 3, -2};
  two = parse_fixture(one + one);
  apply(upright, two[1]);
  const auto built_touching = valid_complex(two);
  const Complex& touching = *built_touching;
  CHECK(touching.region_count == 3);
  CHECK((volumes(touching) == std::vector<Rational>{16, 16}));
}

TEST_CASE("A tunnel", "[solids]") {
  expect("leaf sides\nbox 0 0 0, 3 3 3\nleaf sides\nbox 1 1 -1, 2 2 4", {24, 40, 22, 5, {1, 1, 3, 24}});
  // Ends flush with the faces.
  expect("leaf sides\nbox 0 0 0, 3 3 3\nleaf sides\nbox 1 1 0, 2 2 3", {16, 24, 12, 3, {3, 24}});
}

TEST_CASE("Two cones touch at the apex", "[solids]") {
  expect(
      "leaf winding\nface 0 0 0, 1 1 1, -1 1 1\nface 0 0 0, -1 1 1, -1 -1 1\nface 0 0 0, -1 -1 1, 1 -1 1\n"
      "face 0 0 0, 1 -1 1, 1 1 1\nface 1 1 1, 1 -1 1, -1 -1 1, -1 1 1\n"
      "face 0 0 0, -1 1 -1, 1 1 -1\nface 0 0 0, -1 -1 -1, -1 1 -1\nface 0 0 0, 1 -1 -1, -1 -1 -1\n"
      "face 0 0 0, 1 1 -1, 1 -1 -1\nface 1 1 -1, -1 1 -1, -1 -1 -1, 1 -1 -1\n",
      {9, 16, 10, 3, {Rational(4, 3), Rational(4, 3)}});
}

TEST_CASE("A sheet through a box", "[solids]") {
  expect("leaf sides\nbox 0 0 0, 1 1 1\nleaf none\nface 1/3 -1 -1, 1/3 2 -1, 1/3 2 2, 1/3 -1 2",
         {16, 24, 12, 3, {Rational(1, 3), Rational(2, 3)}});
  // One that ends inside parts nothing.
  expect("leaf sides\nbox 0 0 0, 1 1 1\nleaf none\nface 1/3 -1 1/4, 1/3 1/2 1/4, 1/3 1/2 3/4, 1/3 -1 3/4",
         {8 + 4 + 2, 12 + 4 + 2 + 1, 6 + 2, 2, {1}});
}

TEST_CASE("Wires and points hang in regions", "[solids]") {
  const std::string f =
      "leaf sides\nbox 0 0 0, 2 2 2\nleaf none\nwire 1/2 1 1, 3/2 1 1\npoint 1 1/2 1\npoint 5 5 5\n"
      "wire 2 2 2, 1 3/2 3/2\n";
  expect(f, {8 + 2 + 2 + 1, 12 + 2, 6, 2, {8}});
  const auto built_c = valid_complex(f);
  const Complex& c = *built_c;
  CHECK(c.region_wires[RegionId(1)].size() == 2);
  CHECK(c.region_vertices[RegionId(1)].size() == 1);
  CHECK(c.region_vertices[RegionId(0)].size() == 1);
}

TEST_CASE("A box of walls without some of them", "[solids]") {
  // Open: no region. With a lid whose border is short of the walls: none either.
  const std::string open =
      "leaf cells\nface 0 0 0, 0 3 0, 3 3 0, 3 0 0\nface 0 0 0, 3 0 0, 3 0 3, 0 0 3\n"
      "face 3 0 0, 3 3 0, 3 3 3, 3 0 3\nface 3 3 0, 0 3 0, 0 3 3, 3 3 3\nface 0 3 0, 0 0 0, 0 0 3, 0 3 3\n";
  expect(open, {8, 12, 5, 1});
  expect(open + "face 1 1 3, 2 1 3, 2 2 3, 1 2 3", {12, 16, 6, 1});
  expect(open + "face 0 0 3, 3 0 3, 3 3 3, 0 3 3 | 1 1 3, 2 1 3, 2 2 3, 1 2 3", {12, 16, 6, 1});
  expect(open + "face 0 0 3, 3 0 3, 3 3 3, 0 3 3 | 1 1 3, 2 1 3, 2 2 3, 1 2 3\nface 1 1 3, 2 1 3, 2 2 3, 1 2 3",
         {12, 16, 7, 2, {27}});
}

TEST_CASE("Menger sponge, cube by cube", "[solids]") {
  for (const int level : {1, 2}) {
    const auto cubes = sponge(level);
    const GridCounts counts(cubes);
    const auto built_c = valid_complex({cube_leaf(cubes, Fill::cells)});
    const Complex& c = *built_c;
    CHECK(c.vertex_count() == counts.cells[0].size());
    CHECK(c.edge_count() == counts.cells[1].size());
    CHECK(c.face_count() == counts.cells[2].size());
    CHECK(c.region_count == cubes.size() + 1);
    for (const Rational& v : volumes(c)) REQUIRE(v == 1);
  }
}

TEST_CASE("Menger sponge, from its surface", "[solids]") {
  for (const int level : {1, 2}) {
    const auto cubes = sponge(level);
    const GridCounts counts(cubes);
    Leaf surface;
    surface.fill = Fill::winding;
    std::set<std::array<int, 3>> edges, vertices;
    for (const auto& [x, y, z] : cubes)
      for (const Polygon& square : box_solid({x, y, z}, {x + 1, y + 1, z + 1})) {
        std::array<int, 3> middle{};
        for (const RationalPoint& p : square)
          for (int k = 0; k < 3; ++k) middle[k] += static_cast<int>(p[k].get_d());
        for (int& m : middle) m /= 2;
        if (counts.face_cubes.at(middle) != 1) continue;
        surface.faces.push_back({{square}, 0, 0, false});
        for (int k = 0; k < 3; ++k) {
          if (middle[k] % 2 == 0) continue;
          for (const int side : {-1, 1}) {
            auto e = middle;
            e[k] += side;
            edges.insert(e);
          }
        }
        for (const RationalPoint& p : square)
          vertices.insert({2 * static_cast<int>(p[0].get_d()), 2 * static_cast<int>(p[1].get_d()),
                           2 * static_cast<int>(p[2].get_d())});
      }
    const auto built_c = valid_complex({surface});
    const Complex& c = *built_c;
    CHECK(c.vertex_count() == vertices.size());
    CHECK(c.edge_count() == edges.size());
    CHECK(c.face_count() == surface.faces.size());
    CHECK(c.region_count == 2);
    CHECK((volumes(c) == std::vector<Rational>{cubes.size()}));
    CHECK(labelled(c, {0}) == cubes.size());
  }
}

TEST_CASE("Menger sponge of level 1 by tunnels", "[solids]") {
  // Three prisms through a box of side 3, crossing in the middle cube: every piece is a union of unit cubes.
  const std::string f =
      "leaf sides\nbox 0 0 0, 3 3 3\nleaf sides\nbox 1 1 0, 2 2 3\nleaf sides\nbox 1 0 1, 2 3 2\n"
      "leaf sides\nbox 0 1 1, 3 2 2";
  const auto built_c = valid_complex(f);
  const Complex& c = *built_c;
  CHECK(labelled(c, {0}) == 20);
  CHECK(labelled(c, {0, 1}) == 2);
  CHECK(labelled(c, {0, 1, 2, 3}) == 1);
  CHECK(c.region_count == 1 + 1 + 6 + 1);
}

}  // namespace cnrg::scenes
