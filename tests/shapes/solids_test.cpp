// Primitives: volumes, closedness, planarity, faces as people count them, and what is refused.
#include "kernel/exact/trigonometry.h"
#include "tests/exact/rational_text.h"
#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

/// A solid's faces are planar, closed and oriented outward.
void check_solid(const Soup& soup) {
  CHECK(soup.fill(LeafId(0)) == Fill::winding);
  CHECK(planar(soup));
  CHECK(closed(soup));
  CHECK(volume(soup) > 0);
}

}  // namespace

TEST_CASE("box") {
  const Soup soup = soup_of(BoxShape{{r("0.1"), 0, -1}, {2, r("1/3"), 4}});
  check_solid(soup);
  CHECK(volume(soup) == r("1.9") * r("1/3") * 5);
  CHECK(leaf_faces(soup) == 6);
  CHECK(soup.face_count() == 6);
  CHECK_THAT(error_of(BoxShape{{0, 0, 0}, {1, 0, 1}}), Catch::Contains("box: min is not less than max in y"));
}

TEST_CASE("prism with holes, in either direction") {
  const std::vector<RationalPoint> base{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  std::vector<RationalPoint> hole{{1, 1, 0}, {2, 1, 0}, {2, 3, 0}, {1, 3, 0}};
  for (int variant = 0; variant < 4; ++variant) {
    PrismShape shape{base, {hole}, {1, 0, 3}};
    if (variant & 1) std::reverse(shape.holes[0].begin(), shape.holes[0].end());
    if (variant & 2) shape.vector = {1, 0, -3};
    const Soup soup = soup_of(shape);
    check_solid(soup);
    CHECK(volume(soup) == (16 - 2) * 3);
    CHECK(leaf_faces(soup) == 10);
  }
  SECTION("sides over collinear edges are one face") {
    const Soup soup = soup_of(
        PrismShape{{{2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {4, 5, 0}, {0, 5, 0}, {0, 0, 0}, {1, 0, 0}}, {}, {0, 0, 1}});
    check_solid(soup);
    CHECK(soup.face_count() == 9);
    CHECK(leaf_faces(soup) == 6);
  }
  CHECK_THAT(error_of(PrismShape{base, {}, {1, 1, 0}}), Catch::Contains("lies in the plane of the base"));
  CHECK_THAT(error_of(PrismShape{base, {}, {0, 0, 0}}), Catch::Contains("is zero"));
}

TEST_CASE("pyramid and tetrahedron") {
  const std::vector<RationalPoint> base{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
  for (const char* z : {"1/7", "-2"}) {
    const Soup soup = soup_of(PyramidShape{base, {1, 1, r(z)}});
    check_solid(soup);
    CHECK(volume(soup) == abs(Rational(r("9/2") * r(z) / 3)));
    CHECK(leaf_faces(soup) == 4);
  }
  CHECK_THAT(error_of(PyramidShape{base, {5, 5, 0}}), Catch::Contains("the pyramid is flat"));
  for (int order = 0; order < 2; ++order) {
    TetrahedronShape shape{{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}}};
    if (order) std::swap(shape.points[1], shape.points[2]);
    const Soup soup = soup_of(shape);
    check_solid(soup);
    CHECK(volume(soup) == 1);
  }
  CHECK_THAT(error_of(TetrahedronShape{{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {1, 1, 0}}}}),
             Catch::Contains("one plane"));
}

TEST_CASE("hull and Minkowski sum") {
  std::vector<RationalPoint> cube;
  for (int i = 0; i < 8; ++i) cube.push_back({i & 1, i >> 1 & 1, i >> 2});
  std::vector<RationalPoint> points = cube;
  points.push_back({r("1/2"), r("1/3"), r("1/7")});  // inside
  points.push_back({r("1/2"), 0, 0});                // on an edge
  points.push_back({1, 1, 1});                       // twice
  const Soup hull = soup_of(HullShape{{points}});
  check_solid(hull);
  CHECK(volume(hull) == 1);
  CHECK(hull.face_count() == 6);
  CHECK(leaf_faces(hull) == 6);
  // A cube and a segment along its diagonal: three boxes' worth on top of the cube.
  const Soup swept = soup_of(HullShape{{cube, {{0, 0, 0}, {1, 2, 3}}}});
  check_solid(swept);
  CHECK(volume(swept) == 1 + 1 + 2 + 3);
  CHECK(leaf_faces(swept) == 12);
  // Three segments make a box, and one moved point moves it.
  const Soup box =
      soup_of(HullShape{{{{0, 0, 0}, {2, 0, 0}}, {{0, 0, 0}, {0, 3, 0}}, {{5, 5, 5}, {5, 5, r("11/2")}}}});
  check_solid(box);
  CHECK(volume(box) == 3);
  CHECK_THAT(error_of(HullShape{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {3, 2, 0}}}}),
             Catch::Contains("hull: the points lie in one plane"));
  CHECK_THAT(error_of(HullShape{{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}}}), Catch::Contains("in one plane"));
  CHECK_THAT(error_of(HullShape{{cube, {}}}), Catch::Contains("minkowski: the points lie in one plane"));
}

TEST_CASE("cylinder") {
  for (int n : {3, 4, 5, 12, 48}) {
    const Soup soup = soup_of(CylinderShape{{0, 0, 0}, {0, 0, 2}, 6, n});
    check_solid(soup);
    CHECK(leaf_faces(soup) == 3);
    CHECK(soup.face_count() == static_cast<std::size_t>(n) + 2);
    CHECK(all_doubles(soup));
    // n/2 r^2 sin(360/n) h
    const Rational expected = Rational(n) / 2 * 36 * from_double(sine_degrees(Rational(360) / n)) * 2;
    CHECK(abs(Rational(volume(soup) - expected)) < expected * r("1e-14"));
  }
  SECTION("a square one is exact") { CHECK(volume(soup_of(CylinderShape{{0, 0, 0}, {0, 0, 1}, 3, 4})) == 18); }
  SECTION("any axis, rational ends") {
    const RationalPoint from{r("0.1"), r("-1/3"), 5}, to{2, r("0.7"), r("-0.3")};
    const Soup soup = soup_of(CylinderShape{from, to, r("0.25"), 17});
    check_solid(soup);
    const RationalPoint axis = to - from;
    const Rational radius2 = r("0.0625");
    for (PointId p : IdRange<PointId>(17)) {  // the lower ring
      const RationalPoint offset = value(soup, p) - from;
      CHECK(dot(offset, axis) == 0);
      CHECK(abs(Rational(dot(offset, offset) - radius2)) < radius2 * r("2e-15"));
    }
  }
  SECTION("about each axis of coordinates the first point is on the next axis") {
    const Soup along_y = soup_of(CylinderShape{{0, -5, 0}, {0, 5, 0}, 2, 8});
    check_solid(along_y);
    CHECK(all_doubles(along_y));
    CHECK(value(along_y, PointId(0)) == RationalPoint{0, -5, 2});
    const Soup down = soup_of(CylinderShape{{0, 0, 5}, {0, 0, -5}, 2, 8});
    check_solid(down);
    CHECK(value(down, PointId(0)) == RationalPoint{2, 0, 5});
  }
  SECTION("small and far from the origin it keeps its form") {
    const Soup soup = soup_of(CylinderShape{{1000000000, 0, 0}, {1000000000, 0, 1}, r("1e-9"), 64});
    check_solid(soup);
    CHECK(volume(soup) > r("3.13e-18"));
  }
  CHECK_THAT(error_of(CylinderShape{{0, 0, 0}, {0, 0, 1}, 0, 8}), Catch::Contains("radius is 0"));
  CHECK_THAT(error_of(CylinderShape{{0, 0, 0}, {0, 0, 1}, 1, 2}), Catch::Contains("segments is 2"));
  CHECK_THAT(error_of(CylinderShape{{0, 0, 1}, {0, 0, 1}, 1, 8}), Catch::Contains("from and to"));
}

TEST_CASE("cone") {
  const Soup pointed = soup_of(ConeShape{{0, 0, 0}, {0, 0, 3}, 2, 0, 16});
  check_solid(pointed);
  CHECK(leaf_faces(pointed) == 2);
  CHECK(pointed.face_count() == 17);
  const Soup reversed = soup_of(ConeShape{{0, 0, 0}, {0, 0, 3}, 0, 2, 16});
  check_solid(reversed);
  CHECK(volume(reversed) == volume(pointed));
  const Soup half = soup_of(ConeShape{{0, 0, 0}, {0, 0, 3}, 2, 1, 16});
  check_solid(half);
  CHECK(leaf_faces(half) == 3);
  CHECK(half.face_count() == 18);  // half the radius is exact: the sides stay quadrilaterals
  CHECK(volume(half) == volume(pointed) * r("7/4"));
  const Soup third = soup_of(ConeShape{{1, 2, 3}, {4, 4, 4}, 3, 1, 11});
  check_solid(third);
  CHECK(leaf_faces(third) == 3);
  CHECK(leaf_faces(soup_of(ConeShape{{0, 0, 0}, {0, 0, 3}, 2, 2, 16})) == 3);
  CHECK_THAT(error_of(ConeShape{{0, 0, 0}, {0, 0, 3}, 0, 0, 16}), Catch::Contains("one must be positive"));
  CHECK_THAT(error_of(ConeShape{{0, 0, 0}, {0, 0, 3}, 1, -1, 16}), Catch::Contains("negative"));
}

TEST_CASE("sphere and torus") {
  const Soup ball = soup_of(SphereShape{{1, 2, r("1/3")}, 5, 24, 0});
  check_solid(ball);
  CHECK(leaf_faces(ball) == 1);
  CHECK(to_double(volume(ball)) == Approx(4.0 / 3 * 3.14159265358979 * 125).epsilon(0.05));
  const Soup octahedron = soup_of(SphereShape{{0, 0, 0}, 1, 4, 2});
  check_solid(octahedron);
  CHECK(octahedron.face_count() == 8);
  CHECK(volume(octahedron) == r("4/3"));
  CHECK(all_doubles(octahedron));
  const Soup ring = soup_of(TorusShape{{0, 0, 0}, {1, 2, 2}, 4, 1, 24, 12});
  check_solid(ring);
  CHECK(leaf_faces(ring) == 1);
  CHECK(all_doubles(ring));
  CHECK(to_double(volume(ring)) == Approx(2 * 3.14159265358979 * 3.14159265358979 * 4).epsilon(0.08));
  CHECK_THAT(error_of(SphereShape{{0, 0, 0}, -1, 8, 0}), Catch::Contains("sphere: radius is -1"));
  CHECK_THAT(error_of(SphereShape{{0, 0, 0}, 1, 8, 1}), Catch::Contains("rings is 1"));
  CHECK_THAT(error_of(TorusShape{{0, 0, 0}, {0, 0, 1}, 1, 1, 8, 8}), Catch::Contains("smaller tube"));
  CHECK_THAT(error_of(TorusShape{{0, 0, 0}, {0, 0, 0}, 2, 1, 8, 8}), Catch::Contains("axis"));
  CHECK_THAT(error_of(TorusShape{{0, 0, 0}, {0, 0, 1}, 2, 1, 8, 2}), Catch::Contains("rings"));
  CHECK_THAT(error_of(SphereShape{{0, 0, 0}, 1, 500000, 0}), Catch::Contains("125000000000 facets"));
  CHECK_THAT(error_of(TorusShape{{0, 0, 0}, {0, 0, 1}, 2, 1, 500000, 21}), Catch::Contains("facets"));
}

TEST_CASE("height field") {
  HeightfieldShape shape;
  shape.spacing_x = r("1/2");
  shape.heights = {{1, 2, 1}, {2, 3, 2}};
  const Soup surface = soup_of(shape);
  CHECK(surface.fill(LeafId(0)) == Fill::none);
  CHECK(surface.face_count() == 4);
  CHECK(leaf_faces(surface) == 1);
  shape.base = 0;
  const Soup solid = soup_of(shape);
  check_solid(solid);
  CHECK(leaf_faces(solid) == 6);
  // Two prisms over triangles of area 1/4 in each cell: the mean of the three heights.
  CHECK(volume(solid) == r("1/4") * (r("6/3") + r("6/3") + r("6/3") + r("6/3")));
  shape.base = 1;
  CHECK_THAT(error_of(shape), Catch::Contains("base is 1"));
  shape.base.reset();
  shape.heights[1].pop_back();
  CHECK_THAT(error_of(shape), Catch::Contains("row 2 has 2 heights"));
  shape.heights = {{1, 2}};
  CHECK_THAT(error_of(shape), Catch::Contains("at least 2 rows"));
}

TEST_CASE("height field from a file") {
  const Files files;
  const std::string good =
      "ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20.5\ncellsize 2\nNODATA_value -9999\n1 2 3\n4 5 6.5\n";
  HeightfieldShape shape;
  shape.file = files.write("a.asc", good);
  shape.base = 0;
  const Soup soup = soup_of(shape);
  check_solid(soup);
  CHECK(value(soup, PointId(0)) == RationalPoint{11, r("21.5"), 4});  // the last row is the southern one
  CHECK(value(soup, PointId(5)) == RationalPoint{15, r("23.5"), 3});
  shape.file = files.write(
      "gap.asc", "ncols 3\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 1\nnodata_value -1\n1 2 -1\n4 5 6\n");
  CHECK_THAT(error_of(shape), Catch::Contains("no data at 1 points"));
  shape.base.reset();
  CHECK(soup_of(shape).face_count() == 2);
  CHECK(prepare(shape)->notices().size() == 1);
  shape.file = files.write("short.asc", "ncols 3\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 1\n1 2 3\n4 5\n");
  CHECK_THAT(error_of(shape), Catch::Contains("short.asc:7: error: the file ends within row 2 of 2"));
  shape.file = files.write("long.asc", "ncols 2\nnrows 2\ncellsize 1\n1 2\n3 4\n5 6\n");
  CHECK_THAT(error_of(shape), Catch::Contains("long.asc:6: error: more heights"));
  shape.file = files.write("word.asc", "ncols 2\nnrows 2\ncellsize 1\n1 2\n3 x\n");
  CHECK_THAT(error_of(shape), Catch::Contains("word.asc:5: error: 'x' is no number"));
  shape.file = files.write("head.asc", "ncols 2\ncellsize 1\n1 2\n3 4\n");
  CHECK_THAT(error_of(shape), Catch::Contains("no nrows"));
  for (const std::string columns : {"99999999999999999999", "1", "2.5", "1e300"}) {
    shape.file = files.write("wide.asc", "nrows 2\nncols " + columns + "\ncellsize 1\n1 2\n3 4\n");
    CHECK_THAT(error_of(shape),
               Catch::Contains("wide.asc:2: error: ncols is " + columns + ": it must be a whole"));
  }
  shape.file = files.write("empty.asc", "\xef\xbb\xbf\n");
  CHECK_THAT(error_of(shape), Catch::Contains("empty.asc:1:1: error: the file is empty: give an ESRI ASCII grid"));
  shape.file = files.path("none.asc");
  CHECK_THROWS_WITH(prepare(shape), Catch::Contains("there is no file"));
}
