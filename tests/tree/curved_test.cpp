// Curved leaves in a tree file: what they become, and every fault at its place.

#include "csg/tree/tree.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

template <class S>
S read(const std::string& leaf) {
  const Tree tree = parse_tree("cnrg: 1\nnodes:\n  a: {" + leaf + "}\nresult: a\n", "t.yaml");
  return std::get<S>(*tree.nodes[tree.result].shape);
}

/// `leaf` with a mark @ where the error is; the message must hold all `parts`.
void expect_fault(std::string leaf, std::initializer_list<std::string> parts) {
  const std::string head = "cnrg: 1\nnodes:\n  a: {";
  const std::size_t mark = leaf.find('@');
  REQUIRE(mark != std::string::npos);
  leaf.erase(mark, 1);
  INFO(leaf);
  try {
    parse_tree(head + leaf + "}\nresult: a\n", "t.yaml");
  } catch (const TreeError& e) {
    INFO(e.what());
    CHECK(e.line() == 3);
    CHECK(e.column() == static_cast<int>(mark) + 7);
    for (const std::string& part : parts) CHECK_THAT(e.what(), Catch::Contains(part));
    return;
  }
  FAIL("no error");
}

TEST_CASE("Bézier nets are read", "[tree][curved]") {
  const auto patch = read<BezierShape>(
      "bezier: {patch: [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 1/3]]], chord: 1/100, fill: cells}");
  REQUIRE(patch.patches.size() == 1);
  CHECK(patch.patches[0].points[1][1] == RationalPoint{1, 1, Rational(1, 3)});
  CHECK(patch.patches[0].weights.empty());
  CHECK(patch.patches[0].degree == std::array<int, 2>{0, 0});
  CHECK(*patch.tessellation.chord == Rational(1, 100));
  CHECK(patch.fill == Fill::cells);
  CHECK_FALSE(patch.is_spline);
  const auto many = read<BezierShape>(
      "bezier: {patches: [{points: [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 1]]], weights: [[1, 2], [3, "
      "0.5]]}], "
      "curves: [[[0, 0, 0], [1, 1, 1]], {points: [[0, 0, 0], [1, 0, 0], [2, 2, 2]], weights: [1, 1, 2]}], "
      "segments: 7}");
  CHECK(many.patches[0].weights[1][1] == Rational(1, 2));
  REQUIRE(many.curves.size() == 2);
  CHECK(many.curves[1].weights == std::vector<Rational>{1, 1, 2});
  CHECK(*many.tessellation.segments == 7);
  CHECK(many.fill == Fill::none);
}

TEST_CASE("B-splines are read", "[tree][curved]") {
  const auto curve = read<BezierShape>(
      "bspline: {curve: {points: [[0, 0, 0], [1, 0, 0], [2, 1, 0]], degree: 1, knots: [0, 0, 1/2, 1, 1]}}");
  CHECK(curve.is_spline);
  CHECK(curve.curves[0].degree == 1);
  CHECK(curve.curves[0].knots[2] == Rational(1, 2));
  const auto patch = read<BezierShape>(
      "bspline: {patch: {points: [[[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 0], [1, 1, 1], [2, 1, 1]]], degree: "
      "[2, 1], "
      "knots: [[0, 0, 0, 1, 1, 1], [0, 0, 3, 3]]}}");
  CHECK(patch.patches[0].degree == std::array<int, 2>{2, 1});
  CHECK(patch.patches[0].knots[1][3] == 3);
}

TEST_CASE("Coons patches, extrusions and revolutions are read", "[tree][curved]") {
  const auto coons = read<CoonsShape>(
      "coons: {patch: [[[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [1, 1, 0]], {points: [[1, 1, 0], [0, 1, 0]], weights: "
      "[1, 2]}, "
      "[[0, 1, 0], [0, 0, 0]]], fill: none}");
  REQUIRE(coons.patches.size() == 1);
  CHECK(coons.patches[0][2].weights[1] == 2);
  const auto extrude = read<ExtrudeShape>(
      "extrude: {profile: {outer: [[0, 0, 0], [4, 0, 0], {bezier: [[5, 2, 0], [4, 3, 0]]}, [0, 4, 0]], "
      "holes: [[[1, 1, 0], {bezier: [[2, 1, 0]], weights: [1, 1, 2]}, [2, 2, 0]]]}, vector: [0, 0, 3], twist: "
      "-30.5, scale: 1/2, center: [1, 1, 0]}");
  REQUIRE(extrude.profile.lines.size() == 2);
  CHECK(extrude.profile.closed);
  REQUIRE(extrude.profile.lines[0].segments.size() == 3);
  CHECK(extrude.profile.lines[0].segments[1].points.size() == 4);
  CHECK(extrude.profile.lines[0].segments[2].points == std::vector<RationalPoint>{{0, 4, 0}, {0, 0, 0}});
  CHECK(extrude.profile.lines[1].segments[0].weights == std::vector<Rational>{1, 1, 2});
  CHECK(extrude.twist == Rational(-61, 2));
  CHECK(extrude.scale == Rational(1, 2));
  CHECK(*extrude.center == RationalPoint{1, 1, 0});
  const auto closing =
      read<ExtrudeShape>("extrude: {profile: [[0, 0, 0], [1, 0, 0], {bezier: [[1, 1, 0]]}], vector: [0, 0, 1]}");
  CHECK(closing.profile.lines[0].segments[1].points ==
        std::vector<RationalPoint>{{1, 0, 0}, {1, 1, 0}, {0, 0, 0}});
  const auto revolve =
      read<RevolveShape>("revolve: {curve: [[1, 0], {bezier: [[2, 1]]}, [1, 2]], axis: [1, 0, 0], degrees: 90}");
  CHECK_FALSE(revolve.profile.closed);
  CHECK(revolve.profile.lines[0].segments[0].points ==
        std::vector<RationalPoint>{{1, 0, 0}, {2, 0, 1}, {1, 0, 2}});
  CHECK(revolve.axis == RationalPoint{1, 0, 0});
  CHECK(revolve.degrees == 90);
  const auto sweep = read<SweepShape>(
      "sweep: {profile: {outer: [[0, 0, 0], [1, 0, 0], [0, 1, 0]]}, path: [[0, 0, 0], [0, 0, 2]], radius: 1/2}");
  CHECK(sweep.profile.closed);
  CHECK(sweep.path[1] == RationalPoint{0, 0, 2});
  CHECK(sweep.radius == Rational(1, 2));
  const auto loft = read<LoftShape>(
      "loft: {profiles: [[[0, 0, 0], [1, 0, 0], [0, 1, 0]], {outer: [[0, 0, 1], [1, 0, 1], [0, 1, 1]]}], chord: "
      "1}");
  CHECK(loft.profiles[1].lines[0].segments[0].points[1] == RationalPoint{1, 0, 1});
  CHECK(loft.tessellation.chord == Rational(1));
}

TEST_CASE("faults of curved leaves have their place", "[tree][curved]") {
  const std::string net = "[[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 0]]]";
  expect_fault("bezier: @{chord: 1}", {"needs `patch`, `patches`, `curve` or `curves`"});
  expect_fault("bezier: {patch: " + net + ", @curvs: []}",
               {"unknown key `curvs` in bezier", "did you mean `curve`?"});
  expect_fault("bezier: {patch: " + net + ", @patches: []}", {"has `patch` and `patches`"});
  expect_fault("bezier: {patch: [[[0, 0, 0], [1, 0, 0]], @[[0, 1, 0]]]}",
               {"this row has 1 control points and the first has 2"});
  expect_fault("bezier: {patch: @[[[0, 0, 0], [1, 0, 0]]]}", {"at least two rows of two points"});
  expect_fault("bezier: {patch: [[[0, 0, 0], [1, @x, 0]]]}", {"no number"});
  expect_fault("bezier: {patch: {points: " + net + ", weights: @[[1, 1]]}}",
               {"2 rows of control points and 1 of weights"});
  expect_fault("bezier: {patch: {points: " + net + ", weights: [[1, 1], [1, @0]]}}",
               {"a weight must be positive"});
  expect_fault("bezier: {curve: {points: [[0, 0, 0], [1, 0, 0]], weights: @[1]}}",
               {"2 control points and 1 weights"});
  expect_fault("bezier: {curve: {points: [[0, 0, 0], [1, 0, 0]], @degree: 1}}", {"unknown key `degree`"});
  expect_fault("bezier: {patch: " + net + ", chord: @0}", {"`chord` of bezier must be a positive length"});
  expect_fault("bezier: {patch: " + net + ", chord: 1, @segments: 3}", {"has `chord` and `segments`"});
  expect_fault("bezier: {patch: " + net + ", segments: @0}", {"whole number from 1"});
  expect_fault("bezier: {patch: " + net + ", fill: @full}", {"one of winding, parity, cells, none"});
  const std::string curve = "points: [[0, 0, 0], [1, 0, 0], [1, 1, 0]]";
  expect_fault("bspline: {curve: @{" + curve + "}}", {"needs `degree`"});
  expect_fault("bspline: {curve: {" + curve + ", degree: @3}}", {"degree 3 takes at least 4"});
  expect_fault("bspline: {curve: {" + curve + ", degree: @0}}", {"whole number from 1"});
  expect_fault("bspline: {curve: {" + curve + ", degree: 1, knots: @[0, 0, 1, 1]}}",
               {"3 control points of degree 1 take 5 knots, not 4"});
  expect_fault("bspline: {curve: {" + curve + ", degree: 1, knots: [0, 1, @0.5, 2, 2]}}",
               {"less than the one before it"});
  expect_fault("bspline: {patch: {points: " + net + ", degree: @2}}", {"two degrees"});
  expect_fault("bspline: {patch: {points: " + net + ", degree: [1, 1], knots: @[[0, 0, 1, 1]]}}",
               {"two lists of knots"});
  expect_fault("coons: {patch: @[[[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [1, 1, 0]], [[1, 1, 0], [0, 0, 0]]]}",
               {"four curves that go round"});
  expect_fault("coons: @{chord: 1}", {"needs `patch` or `patches`"});
}

TEST_CASE("faults of sweeps have their place", "[tree][curved]") {
  const std::string square = "[[0, 0, 0], [1, 0, 0], [1, 1, 0]]";
  expect_fault("extrude: @{vector: [0, 0, 1]}", {"extrude needs `profile`"});
  expect_fault("extrude: @{profile: " + square + "}", {"extrude needs `vector`"});
  expect_fault("extrude: {profile: " + square + ", @curve: " + square + ", vector: [0, 0, 1]}",
               {"has `profile` and `curve`"});
  expect_fault("extrude: {profile: [@{bezier: [[1, 1, 0]]}, [0, 0, 0]], vector: [0, 0, 1]}",
               {"begin with a corner"});
  expect_fault("extrude: {profile: [[0, 0, 0], {bezier: [[1, 1, 0]]}, @{bezier: [[1, 1, 0]]}], vector: [0, 0, 1]}",
               {"give the corner between"});
  expect_fault("extrude: {curve: [[0, 0, 0], @{bezier: [[1, 1, 0]]}], vector: [0, 0, 1]}", {"end with a corner"});
  expect_fault("extrude: {profile: [[0, 0, 0], {@points: [[1, 1, 0]]}, [1, 0, 0]], vector: [0, 0, 1]}",
               {"unknown key `points`"});
  expect_fault(
      "extrude: {profile: [[0, 0, 0], {bezier: [[1, 1, 0]], weights: @[1]}, [1, 0, 0]], vector: [0, 0, 1]}",
      {"3 control points and 1 weights"});
  expect_fault("extrude: {profile: @[[0, 0, 0]], vector: [0, 0, 1]}", {"at least two corners"});
  expect_fault("extrude: {profile: @[], vector: [0, 0, 1]}", {"is empty"});
  expect_fault("extrude: {profile: [@[0, 0]], vector: [0, 0, 1]}", {"[x, y, z]"});
  expect_fault("extrude: {profile: " + square + ", vector: [0, 0, 1], scale: @-1}", {"must be 0 or more"});
  expect_fault("revolve: {profile: [@[0, 0, 0]]}", {"[x, y]"});
  expect_fault("sweep: {profile: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], path: [[0, 0, 0], [0, 0, 1]], radius: @0}",
               {"must be a positive length"});
  expect_fault("loft: {profiles: @[[[0, 0, 0], [1, 0, 0], [0, 1, 0]]]}", {"two profiles or more"});
  expect_fault("revolve: {profile: [[0, 0], [1, 0], [1, 1]], degrees: @400}", {"at most 360"});
}

}  // namespace
}  // namespace cnrg
