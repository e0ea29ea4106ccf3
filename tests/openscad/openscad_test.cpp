// Trees of OpenSCAD: volumes by formulas, counts by hand, what passes through, what is refused and where.
#include <cmath>
#include <numbers>
#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/tree/tree_of_file.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using std::numbers::pi;

struct Outcome {
  std::size_t vertices = 0, edges = 0, faces = 0, regions = 0;
  double volume = 0;
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

Outcome outcome_of(const Tree& tree) {
  EvaluateOptions options;
  options.validate = true;
  options.rows = Rows::all;
  const Evaluation evaluation = evaluate(tree, options);
  const auto row = std::find_if(evaluation.rows.begin(), evaluation.rows.end(),
                                [&](const NodeRow& r) { return r.node == tree.result; });
  REQUIRE(row != evaluation.rows.end());
  return {row->cells[0], row->cells[1], row->cells[2], row->regions, to_double(row->volume().value())};
}

Outcome outcome_of(const std::string& text) { return outcome_of(parse_openscad(text, "t.csg")); }

/// A solid's volume to 1e-5, since OpenSCAD's corners are on a grid of a millionth.
auto is_near(double volume) { return Catch::WithinRel(volume, 1e-5); }
void check_volume(const std::string& text, double volume) {
  INFO(text);
  CHECK_THAT(outcome_of(text).volume, is_near(volume));
}

std::string moved(double x, double y, double z, const std::string& what) {
  return "multmatrix([[1, 0, 0, " + std::to_string(x) + "], [0, 1, 0, " + std::to_string(y) + "], [0, 0, 1, " +
         std::to_string(z) + "], [0, 0, 0, 1]]) {" + what + "}\n";
}

/// Of a regular polygon.
double polygon_area(int n, double radius) { return n * radius * radius * std::sin(2 * pi / n) / 2; }
/// Between two of them, parallel, of areas `a` and `b`.
double frustum(double height, double a, double b) { return height * (a + b + std::sqrt(a * b)) / 3; }

double sphere_volume(int n, double radius) {
  const int rings = (n + 1) / 2;
  double volume = 0;
  for (int i = 0; i + 1 < rings; ++i) {
    const double a = pi * (i + 0.5) / rings, b = pi * (i + 1.5) / rings;
    volume += frustum(radius * (std::cos(a) - std::cos(b)), polygon_area(n, radius * std::sin(a)),
                      polygon_area(n, radius * std::sin(b)));
  }
  return volume;
}

TEST_CASE("primitives have OpenSCAD's corners", "[openscad]") {
  CHECK(outcome_of("cube(size = [2, 3, 0.5], center = true);") == Outcome{8, 12, 6, 1, 3});
  CHECK(outcome_of("cube(size = 2);") == Outcome{8, 12, 6, 1, 8});
  CHECK(outcome_of("polyhedron(points = [[0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 3]], "
                   "faces = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]]);") == Outcome{4, 6, 4, 1, 4.5});
  for (const int n : {3, 4, 5, 8, 9, 24}) {
    const std::string fn = "$fn = " + std::to_string(n);
    check_volume("sphere(" + fn + ", r = 2.5);", sphere_volume(n, 2.5));
    check_volume("cylinder(" + fn + ", h = 3, r1 = 2, r2 = 2);", 3 * polygon_area(n, 2));
    check_volume("cylinder(" + fn + ", h = 3, r1 = 2, r2 = 0.5, center = true);",
                 frustum(3, polygon_area(n, 2), polygon_area(n, 0.5)));
    check_volume("cylinder(" + fn + ", h = 3, r1 = 0, r2 = 2);", polygon_area(n, 2));
    CHECK(outcome_of("cylinder(" + fn + ", h = 3, r1 = 2, r2 = 0);").vertices == std::size_t(n) + 1);
  }
}

TEST_CASE("a polygon lies on the grid of outlines before it is moved", "[openscad]") {
  // 1.7 steps of 1/65536 are one, which is stretched to a length of 1.
  const std::string stretch = "multmatrix([[65536, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) ";
  const std::string small = "polygon(points = [[0, 0], [0.000026, 0], [0, 1]], paths = undef);";
  CHECK(outcome_of("linear_extrude(height = 1) {" + stretch + "{" + small + "}}").volume == 0.5);
  CHECK(outcome_of("linear_extrude(height = 1) {" + stretch + "{hull() {" + small + "}}}").volume == 0.5);
}

TEST_CASE("sides and ends of a turned area have OpenSCAD's diagonals", "[openscad]") {
  // Counts of the Nef polyhedra of OpenSCAD 2021.01: on its grid four corners of a side are in no plane, and the
  // ends are not planar, whose corners lie on one circle.
  const auto counts = [](const std::string& op, const std::string& angle, const std::string& circle,
                         const std::string& other) {
    const Outcome o = outcome_of(op + "() { rotate_extrude(angle = " + angle + ", $fn = 9) { " +
                                 moved(20, 0, 0, "circle(" + circle + ");") + " } " + other + " }");
    return std::array{o.vertices, o.edges, o.faces};
  };
  using Counts = std::array<std::size_t, 3>;
  CHECK(counts("difference", "260.23", "$fn = 6, r = 3.919",
               "cylinder($fa = 30, $fs = 1, h = 2.1017, r1 = 2.08, r2 = 0, center = true);") ==
        Counts{42, 94, 54});
  CHECK(counts("group", "269.637", "$fa = 30, $fs = 1, r = 2.79", "sphere($fa = 30, $fs = 1, r = 2);") ==
        Counts{135, 334, 203});
}

TEST_CASE("fineness is OpenSCAD's", "[openscad]") {
  const auto sides = [](const std::string& fineness) {
    return outcome_of("cylinder(h = 1, " + fineness + ");").faces - 2;
  };
  CHECK(sides("r1 = 1, r2 = 1") == 5);                       // at least five
  CHECK(sides("r1 = 5, r2 = 5") == 16);                      // 2 pi 5 / 2 = 15.7
  CHECK(sides("r1 = 5, r2 = 0") == 15);                      // the cone's apex is no cap: 16 sides, one face less
  CHECK(sides("r1 = 100, r2 = 100") == 30);                  // 360 / 12
  CHECK(sides("r1 = 100, r2 = 100, $fa = 7") == 52);         // 360 / 7 = 51.4
  CHECK(sides("r1 = 5, r2 = 5, $fs = 0.5, $fa = 1") == 63);  // 62.8
  CHECK(sides("r1 = 5, r2 = 5, $fn = 7.9, $fa = 1") == 7);
  CHECK(sides("r1 = 5, r2 = 5, $fn = 1") == 3);
  // Children have what a parent says.
  CHECK(outcome_of("group($fn = 6) { cylinder(h = 1, $fs = 9); }").faces == 8);
  CHECK(outcome_of("group($fn = 6) { cylinder(h = 1, $fn = 0); }").faces == 7);
}

TEST_CASE("Booleans are those of solids, regularized", "[openscad]") {
  const std::string cube = "cube(size = [1, 1, 1]);\n";
  CHECK(outcome_of("difference() { cube(size = 2); cube(size = 1); }") == Outcome{14, 21, 9, 1, 7});
  CHECK(outcome_of("union() {" + cube + moved(1, 0, 0, cube) + "}") == Outcome{8, 12, 6, 1, 2});
  CHECK(outcome_of(cube + moved(0.5, 0, 0, cube)) == Outcome{8, 12, 6, 1, 1.5});  // the file is a union
  CHECK(outcome_of("group() {" + cube + moved(3, 0, 0, cube) + "}") == Outcome{16, 24, 12, 2, 2});
  CHECK(outcome_of("intersection() {" + cube + moved(0.5, 0.5, 0.5, cube) + "}") == Outcome{8, 12, 6, 1, 0.125});
  // What only touches is nothing, and leaves nothing in a union.
  const std::string touch = "intersection() {" + cube + moved(1, 0, 0, cube) + "}";
  CHECK(outcome_of(touch) == Outcome{});
  CHECK(outcome_of(touch + moved(5, 0, 0, cube)) == Outcome{8, 12, 6, 1, 1});
  CHECK(outcome_of("difference() {" + cube + cube + "}") == Outcome{});
}

TEST_CASE("what is empty, marked or alone", "[openscad]") {
  const std::string cube = "cube(size = [1, 1, 1]);\n", none = "cube(size = [0, 1, 1]);";
  CHECK(outcome_of("difference() {" + cube + "group(); " + none + "}").volume == 1);
  CHECK(outcome_of("union() { group(); " + cube + "sphere(r = 0); cylinder(h = 1, r1 = 0, r2 = 0); }").volume ==
        1);
  CHECK(outcome_of("%cube(size = 5); *cube(size = 6); #" + cube).volume == 1);
  CHECK(outcome_of("cube(size = 5); group() { !" + cube + "}").volume == 1);
  CHECK(outcome_of("color([1, 0, 0, 1]) { render(convexity = 2) {" + cube + "} }") == Outcome{8, 12, 6, 1, 1});
  for (const std::string text :
       {"", "group();", "difference() { group(); cube(); }", "intersection() { cube(); group(); }", "%cube();",
        "rotate_extrude() { circle(r = 0); }"}) {
    INFO(text);
    CHECK_THROWS_WITH(parse_openscad(text, "t.csg"), Catch::Contains("the model is empty"));
  }
  CHECK_THROWS_WITH(parse_openscad("square(size = 1);", "t.csg"), Catch::Contains("put it into `linear_extrude`"));
}

TEST_CASE("matrices move polygons and exact solids", "[openscad]") {
  const std::string shear = "multmatrix([[1, 0.5, 0, 7], [0, -2, 0, 1], [0, 0, 3, 0], [0, 0, 0, 1]])";
  CHECK(outcome_of(shear + " cube();") == Outcome{8, 12, 6, 1, 6});
  CHECK(outcome_of(shear + " difference() { cube(size = 2); cube(size = 1); }") == Outcome{14, 21, 9, 1, 42});
  CHECK(outcome_of("linear_extrude(height = 2) {" + shear + " square(size = 1); }") == Outcome{8, 12, 6, 1, 4});
  const Tree flat = parse_openscad(
      "cube();\nmultmatrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0], [0, 0, 0, 1]]) cube();", "t.csg");
  REQUIRE(flat.warnings.size() == 1);
  CHECK_THAT(flat.warnings[0].text(),
             Catch::StartsWith("t.csg:2:1: warning: `multmatrix` has a matrix that makes"));
  const Tree mixed = parse_openscad("cube();\nsquare(size = 9);", "t.csg");
  REQUIRE(mixed.warnings.size() == 1);
  CHECK_THAT(mixed.warnings[0].text(), Catch::Contains("only the solids count"));
  CHECK(outcome_of(mixed).volume == 1);
}

TEST_CASE("areas are united, cut and have holes", "[openscad]") {
  const auto area = [](const std::string& areas) {
    return outcome_of("linear_extrude(height = 1) {" + areas + "}").volume;
  };
  const std::string plus = "square(size = [3, 1], center = true); square(size = [1, 3], center = true);";
  CHECK(area(plus) == 5);
  CHECK(outcome_of("linear_extrude(height = 1) {" + plus + "}") == Outcome{24, 36, 14, 1, 5});
  CHECK(area("intersection() {" + plus + "}") == 1);
  CHECK(area("difference() {" + plus + "}") == 2);
  CHECK(area("difference() { square(size = 4); difference() {" + moved(1, 1, 0, "square(size = 2);") +
             moved(1.5, 1.5, 0, "square(size = 1);") + "} }") == 13);
  // Paths count odd and even; the two triangles of a bow tie are inside.
  CHECK(area("polygon(points = [[0, 0], [4, 0], [4, 4], [0, 4], [1, 1], [3, 1], [3, 3], [1, 3]], "
             "paths = [[0, 1, 2, 3], [4, 5, 6, 7]]);") == 12);
  CHECK(area("polygon(points = [[0, 0], [2, 2], [2, 0], [0, 2]], paths = undef);") == 2);
  CHECK(area("hull() { square(size = 1); " + moved(3, 3, 0, "square(size = 1);") + "}") == 7);
  // Squares that touch in a corner, and along a part of an edge.
  CHECK(area("square(size = 1); " + moved(1, 1, 0, "square(size = 1);")) == 2);
  CHECK(area("square(size = 1); " + moved(1, 0.5, 0, "square(size = 1);")) == 2);
}

TEST_CASE("extrusions", "[openscad]") {
  CHECK(outcome_of("linear_extrude(height = 5, center = true) { square(size = [2, 3]); }") ==
        Outcome{8, 12, 6, 1, 30});
  check_volume("linear_extrude(height = 3, scale = 0.5) { square(size = 2, center = true); }", frustum(3, 4, 1));
  check_volume("linear_extrude(height = 3, scale = [0, 0]) { square(size = 2, center = true); }", 4);
  // Four layers: 45 degrees in steps of 12.
  CHECK(
      outcome_of("linear_extrude(height = 10, twist = 45) { square(size = [10, 4], center = true); }").vertices ==
      20);
  CHECK(outcome_of("linear_extrude(height = 9, twist = 90, slices = 3) { square(size = 1); }").vertices == 16);
  CHECK(outcome_of("linear_extrude(height = 10, scale = [2, 0.5]) { square(size = [10, 4], center = true); }")
            .vertices == 28);
  const auto ring = [](int n, const std::string& angle) {
    return "rotate_extrude(" + angle + "$fn = " + std::to_string(n) + ") {" +
           moved(2, 1, 0, "square(size = [1, 3]);") + "}";
  };
  check_volume(ring(12, ""), 3 * (polygon_area(12, 3) - polygon_area(12, 2)));
  check_volume(ring(12, "angle = 90, "), 3 * (polygon_area(12, 3) - polygon_area(12, 2)) / 4);
  check_volume(ring(12, "angle = -90, "), 3 * (polygon_area(12, 3) - polygon_area(12, 2)) / 4);
  check_volume("rotate_extrude($fn = 6) { square(size = 2); }", 2 * polygon_area(6, 2));  // touches the axis
  check_volume("rotate_extrude($fn = 6) {" + moved(-3, 0, 0, "square(size = 1);") + "}",
               polygon_area(6, 3) - polygon_area(6, 2));
}

TEST_CASE("hulls and Minkowski sums", "[openscad]") {
  const std::string cube = "cube(size = [1, 1, 1]);\n", big = "cube(size = 4);";
  CHECK(outcome_of("hull() {" + cube + moved(2, 0, 0, cube) + "}") == Outcome{8, 12, 6, 1, 3});
  CHECK(outcome_of("hull() { union() {" + cube + moved(2, 0, 0, cube) + "} }") == Outcome{8, 12, 6, 1, 3});
  CHECK(outcome_of("hull() { difference() {" + big + moved(1, 1, -1, "cube(size = [2, 2, 9]);") + "} }") ==
        Outcome{8, 12, 6, 1, 64});
  CHECK(outcome_of("hull() { intersection() {" + big + moved(2, 0, 0, big) + "} }").volume == 32);
  CHECK(outcome_of("minkowski() {" + cube + "cube(size = [2, 3, 4]); }") == Outcome{8, 12, 6, 1, 60});
  // An L of two boxes grows by half a unit on both sides of each axis.
  const std::string ell = "union() { cube(size = [4, 2, 2]); cube(size = [2, 4, 2]); }";
  CHECK(outcome_of("minkowski() {" + ell + cube + "}") == Outcome{12, 18, 8, 1, 3 * (5 * 3 + 3 * 5 - 3 * 3)});
  // So does a frame, and its hole of 2 by 2 becomes one of 1 by 1; a cavity of 2 does likewise.
  const std::string hole = "difference() {" + big + moved(1, 1, -1, "cube(size = [2, 2, 9]);") + "}";
  CHECK(outcome_of("minkowski() {" + hole + cube + "}") == Outcome{16, 24, 10, 1, 5 * (25 - 1)});
  const std::string cavity = "difference() {" + big + moved(1, 1, 1, "cube(size = 2);") + "}";
  CHECK(outcome_of("minkowski() {" + cube + cavity + "}") == Outcome{16, 24, 12, 1, 125 - 1});
}

TEST_CASE("what is not read is an error with its construct, line and column", "[openscad]") {
  const auto expect = [](const std::string& text, const std::string& message) {
    INFO(text);
    CHECK_THROWS_WITH(parse_openscad(text, "t.csg"), Catch::Contains(message));
  };
  for (const std::string name : {"text", "surface", "offset", "projection", "resize", "for"})
    expect("cube();\n  " + name + "();", "t.csg:2:3: error: `" + name + "` is not read; let OpenSCAD write");
  expect("cube(size = [1, 2]);", "t.csg:1:1: error: `cube` needs `size`, a finite number or a list of 3");
  expect("cube(side = 2);", "has the argument `side`, which is not read");
  expect("cube(size = 2, size = 3);", "t.csg:1:1: error: `cube` has the argument `size` twice; remove one");
  expect("cube(2, $fn = 8, size = 3);", "has the argument `size` twice");
  expect("cube(2, 3);", "has an argument without a name");
  expect("sphere(r = nan);", "`sphere` needs `r`, a finite number");
  expect("sphere(r = 1, $fn = 1e9);", "`sphere` would have more than 1,000,000 corners");
  expect("cube(size = 1e13);", "farther than 10^12");
  expect("polyhedron(points = [[0, 0, 0]], faces = [[0, 1, 2]]);", "numbers of points, below 1");
  expect("rotate_extrude() { square(size = 2, center = true); }", "crosses it; move it");
  expect("linear_extrude() { cube(); }", "has a solid as child");
  expect("minkowski() { square(size = 1); circle(r = 1); }", "`minkowski` of areas is not read");
  expect("import(file = \"a.dxf\");", "`a.dxf` is none");
  expect("import(file = \"none.stl\");", "t.csg:1:1: error: there is no file 'none.stl': check the path");
  expect(std::string("import(file = \"none\0.stl\");", 27), "there is no file 'none\\x00.stl'");
  expect("group() {\n  cube(", "t.csg:2:8: error: a value is expected here, not the end of the file");
  expect("group() {\n  cube();", "`}` is expected here");
  expect("cube() cube", "`(` behind `cube` is expected here");
  expect("x = 3;", "`(` behind `x` is expected");
  expect("cube(size = 1/2);", "a number, a text, a list");
  expect("/* cube();", "this comment has no end");
  expect(std::string(2000, '['), "the name of a module");
  std::string deep;
  for (int i = 0; i < 2000; ++i) deep += "group() {";
  expect(deep, "more than 1,000 statements");
}

TEST_CASE("faults that show only in the geometry have their place", "[openscad]") {
  const Tree tree = parse_openscad(
      "difference() {\n  cube();\n   polyhedron(points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], "
      "[0, 0, 1]], faces = [[0, 1, 2], [0, 3, 1]]);\n}",
      "t.csg");
  CHECK_THROWS_WITH(evaluate(tree), Catch::StartsWith("t.csg:3:4: error: mesh is not closed"));
}

TEST_CASE("the tree file means the same", "[openscad]") {
  const std::string text =
      "difference() { cube(size = [0.1, 1, 1.3]); " + moved(0.05, 0.3, 0.5, "sphere(r = 1);") + "}";
  const Tree tree = parse_openscad(text, "t.csg");
  CHECK_THAT(tree.yaml, Catch::StartsWith("cnrg: 1\nnodes:\n"));
  CHECK(outcome_of(parse_tree(tree.yaml, "t.yaml")) == outcome_of(tree));
  CHECK(tree.find("difference-1").valid());
  CHECK(tree.nodes[tree.result].name == "model");
}

}  // namespace
}  // namespace cnrg
