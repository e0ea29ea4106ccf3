// Differences of small trees, counted by hand.

#include "tests/catch.h"
#include "tests/compare/trees.h"

namespace cnrg {
namespace {

using test::compared;
using test::text;

const std::string kBox = "box: {box: {min: [0, 0, 0], max: [2, 2, 2]}}";

TEST_CASE("A tree means the same as itself, and so does one that says the same otherwise", "[compare]") {
  CHECK(text(kBox, kBox).empty());
  CHECK(compared(kBox, kBox).same());
  CHECK(text(kBox, "p: {prism: {base: [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], vector: [0, 0, 2]}}").empty());
  CHECK(text(kBox, "half: {box: {min: [0, 0, 0], max: [1, 1, 1]}, scale: 2}").empty());
  CHECK(text("a: {box: {min: [0, 0, 0], max: [2, 2, 2]}}\nb: {box: {min: [1, 1, 1], max: [3, 3, 3]}}\n"
             "u: {union: [a, b]}",
             "b: {box: {min: [1, 1, 1], max: [3, 3, 3]}}\na: {box: {min: [0, 0, 0], max: [2, 2, 2]}}\n"
             "u: {union: [b, a]}")
            .empty());
}

TEST_CASE("The place and size of what only one tree has", "[compare]") {
  CHECK(text(kBox, "b: {box: {min: [0, 0, 0], max: [2, 2, 5/2]}}") ==
        "only in B: a region of volume 2 about (1, 1, 9/4)");
  // A corner that sticks out and one that is missing.
  CHECK(text(kBox, "b: {box: {min: [1, 0, 0], max: [3, 2, 2]}}") ==
        "only in A: a region of volume 4 about (1/2, 1, 1)/only in B: a region of volume 4 about (5/2, 1, 1)");
  CHECK(text("s: {polygon: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]}",
             "s: {polygon: [[0, 0, 0], [1, 0, 0], [0, 1, 0]]}") ==
        "only in A: a face of area 0.5 about (2/3, 2/3, 0)");
  CHECK(text("w: {polyline: [[0, 0, 0], [3, 3, 3]]}", "w: {polyline: [[1, 1, 1], [2, 2, 2]]}") ==
        "only in A: an edge of length sqrt(3) about (1/2, 1/2, 1/2)/"
        "only in A: an edge of length sqrt(3) about (5/2, 5/2, 5/2)/only in A: all 2 together: length 2 sqrt(3)");
  CHECK(text("p: {points: [[0, 0, 0], [1, 2, 3]]}", "p: {points: [[0, 0, 0]]}") == "only in A: a point (1, 2, 3)");
  CHECK(text("a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\nb: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n"
             "none: {difference: [a, b]}",
             kBox) == "only in B: a region of volume 8 about (1, 1, 1)/region 1 `box` of B is nowhere in A");
}

TEST_CASE("Open and closed sets differ by what bounds them", "[compare]") {
  CHECK(text("open: {interior: {unify: {box: {min: [0, 0, 0], max: [2, 2, 2]}}}}",
             "solid: {unify: {box: {min: [0, 0, 0], max: [2, 2, 2]}}}") ==
        "only in B: 6 faces of area 24 in all about (0, 1, 1)");
  CHECK(text("halved: {subtract: [{unify: {box: {min: [0, 0, 0], max: [2, 2, 2]}}}, "
             "{polygon: [[1, 0, 0], [1, 2, 0], [1, 2, 2], [1, 0, 2]]}]}",
             "solid: {unify: {box: {min: [0, 0, 0], max: [2, 2, 2]}}}") ==
        "only in B: a face of area 4 about (1, 1, 1)");
}

TEST_CASE("A wall of one tree alone parts a region in two", "[compare]") {
  const std::string walled = kBox +
                             "\nwall: {polygon: [[1, 0, 0], [1, 2, 0], [1, 2, 2], [1, 0, 2]]}\n"
                             "parted: {union: [wall, box], dominance: left}";
  CHECK(text(walled, kBox) ==
        "region 1 `box` and region 2 `box` of A are region 1 `box` of B/"
        "in both: a face of area 4 about (1, 1, 1): an entity of A, in region 1 `box` of B");
  CHECK(text(kBox, walled) ==
        "region 1 `box` of A is region 1 `box` and region 2 `box` of B/"
        "in both: a face of area 4 about (1, 1, 1): in region 1 `box` of A, an entity of B");
  CompareOptions points;
  points.components = false;
  CHECK(compared(walled, kBox, points).same());
}

TEST_CASE("A face that belongs to another component", "[compare]") {
  const std::string boxes =
      "l: {unify: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}\nr: {unify: {box: {min: [1, 0, 0], max: [2, 1, 1]}}}\n";
  CHECK(text(boxes + "all: {aggregate: [l, {subtract: [r, l]}]}",
             boxes + "all: {aggregate: [r, {subtract: [l, r]}]}") ==
        "component 1 `l` of A is mostly component 2 `l` of B/"
        "component 2 `r` of A is mostly component 1 `r` of B/"
        "in both: a face of area 1 about (1, 1/2, 1/2): in component 1 `l` of A, in component 1 `r` of B");
}

TEST_CASE("Numbers of components do not matter, their cells do", "[compare]") {
  const std::string low = "x: {box: {min: [0, 0, 0], max: [2, 2, 1]}, material: clay, name: low}\n";
  const std::string high = "y: {box: {min: [0, 0, 1], max: [2, 2, 2]}, material: rock, name: high}\n";
  CHECK(compared(low + high + "u: {union: [x, y], dominance: left}",
                 high + low + "u: {union: [y, x], dominance: left}")
            .same());
  const std::string third = "z: {box: {min: [0, 0, 2], max: [2, 2, 3]}}\n";
  CHECK(text(low + high + third + "u: {aggregate: [{interior: x}, {interior: y}, {interior: z}]}",
             low + high + third + "u: {aggregate: [{interior: z}, {interior: x}]}") ==
        "only in A: a region of volume 4 about (1, 1, 3/2)/component 2 `high` of A is nowhere in B");
}

TEST_CASE("Materials differ by name, and as functions of position", "[compare]") {
  const std::string box = "b: {box: {min: [0, 0, 0], max: [2, 2, 2]}";
  CHECK(text(box + ", material: rock}", box + ", material: clay}") ==
        "material of region 1 `b`: `rock` in A, `clay` in B");
  CHECK(text(box + ", material: rock}", box + "}") == "material of region 1 `b`: `rock` in A, no material in B");
  const auto graded = [&](const std::string& grade, const std::string& nodes = "") {
    return parse_tree("cnrg: 1\nmaterials: {rock: {}, clay: {}, g: {" + grade + "}}\nnodes:\n  b: {box: {min: " +
                          "[0, 0, 0], max: [2, 2, 2]}, material: g}\n" + nodes + "result: b\n",
                      "test.yaml");
  };
  const auto same = [](const Tree& a, const Tree& b) {
    const Comparison comparison = compare(a, a.result, b, b.result);
    if (!comparison.same()) {
      CHECK(comparison_text(comparison) ==
            "material of region 1 `b`: `g` changes otherwise with position in A than in B\n");
    }
    return comparison.same();
  };
  const Tree up = graded("linear: {from: [0, 0, 0], to: [0, 0, 2], stops: [[0, rock], [1, clay]]}");
  CHECK(same(up, up));
  CHECK(same(up, graded("linear: {from: [5, 7, 2], to: [5, 7, 0], stops: [[0, clay], [1, rock]]}")));
  CHECK(same(up, graded("linear: {from: [0, 0, 0], to: [0, 0, 1], stops: [[-3, rock], [0, rock], "
                        "[1, {rock: 1/2, clay: 1/2}], [2, clay], [3, clay]]}")));
  CHECK_FALSE(same(up, graded("linear: {from: [0, 0, 0], to: [0, 0, 3], stops: [[0, rock], [1, clay]]}")));
  CHECK_FALSE(same(up, graded("linear: {from: [0, 0, 0], to: [0, 1, 2], stops: [[0, rock], [1, clay]]}")));
  CHECK_FALSE(same(up, graded("linear: {from: [0, 0, 0], to: [0, 0, 2], stops: [[0, clay], [1, rock]]}")));
  const auto from = [&](const std::string& node) {
    return graded("distance: {to: s, stops: [[0, rock], [1, clay]]}", "  s: " + node + "\n");
  };
  const Tree far = from("{polygon: [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]}");
  CHECK(same(far, far));
  CHECK(same(far, from("{union: [{polygon: [[0, 0, 0], [2, 0, 0], [2, 2, 0]]}, {polygon: [[0, 0, 0], [2, 2, 0], "
                       "[0, 2, 0]]}]}")));
  CHECK_FALSE(same(far, from("{polygon: [[0, 0, 0], [1, 0, 0], [2, 2, 0], [0, 2, 0]]}")));
  CHECK_FALSE(same(far, up));
}

TEST_CASE("Names that somebody gave count, names of nodes do not", "[compare]") {
  const std::string box = ": {box: {min: [0, 0, 0], max: [2, 2, 2]}";
  CHECK(text("a" + box + "}", "b" + box + "}").empty());
  CHECK(text("a" + box + ", name: rock}", "b" + box + ", name: rock}").empty());
  CHECK(text("a & b" + box + "}", "c" + box + "}").empty());
  // A name with ` & ` in it is one name.
  CHECK(text("a & b" + box + "}", "c" + box + ", name: b & a}") == "name of region 1: `a & b` in A, `b & a` in B");
  CHECK(text("a & b" + box + "}", "c" + box + ", name: a & b}").empty());
  CHECK(text("rock" + box + "}", "b" + box + ", name: rock}").empty());
  CHECK(text("a" + box + ", name: rock}", "b" + box + "}") == "name of region 1: `rock` in A, `b` in B");
  CHECK(text("a" + box + ", name: rock}", "b" + box + ", name: ore}") ==
        "name of region 1: `rock` in A, `ore` in B");
  CompareOptions options;
  options.names = false;
  CHECK(text("a" + box + ", name: rock}", "b" + box + ", name: ore}", options).empty());
  // Joined names are compared word by word, in any order.
  const std::string two = "x" + box + ", name: one}\ny" + box + ", name: two}\n";
  CHECK(text(two + "s: {sum: [x, y]}", two + "s: {sum: [y, x]}").empty());
  CHECK(text("e: {closure: {interior" + box + "}}}", "u: {closure: {interior" + box + "}}}").empty());
}

TEST_CASE("Lines that only one tree has on its surfaces", "[compare]") {
  const std::string parts =
      "l: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\nr: {box: {min: [1, 0, 0], max: [2, 1, 1]}}\n";
  const std::string whole = "b: {box: {min: [0, 0, 0], max: [2, 1, 1]}}";
  CHECK(text(parts + "u: {union: [l, r]}", whole) ==
        "a cell of its own only in A: 4 edges of length 4 in all about (1, 1/2, 0)");
  CompareOptions options;
  options.features = false;
  CHECK(compared(parts + "u: {union: [l, r]}", whole, options).same());
  CHECK(compared(parts + "u: {simplify: {of: {union: [l, r]}, mode: points}}",
                 "s: {simplify: {of: {box: {min: [0, 0, "
                 "0], max: [2, 1, 1]}}, mode: points}}")
            .same());
}

TEST_CASE("One surface is one, however many segments it has", "[compare]") {
  const auto ball = [](int segments, const std::string& radius) {
    return "s: {sphere: {center: [0, 0, 0], radius: " + radius + ", segments: " + std::to_string(segments) + "}}";
  };
  CHECK(compared(ball(8, "1"), ball(12, "1")).same());
  const Comparison larger = compared(ball(8, "1"), ball(8, "2"));
  REQUIRE(larger.only[1].size() == 1);
  CHECK(larger.only[0].empty());
  CHECK(larger.moved.empty());
  // What a prism says is its facets: 3 sqrt(3) / 2 and 3 differ.
  CHECK(text("p: {prism: {base: [[0, 0, 0], [4, 0, 0], [2, 3, 0]], vector: [0, 0, 1]}}",
             "p: {prism: {base: [[0, 0, 0], [4, 0, 0], [2, 2, 0]], vector: [0, 0, 1]}}")
            .starts_with("only in A: a region of volume 2 about"));
}

TEST_CASE("What reaches infinity", "[compare]") {
  const std::string below = "h: {halfspace: {point: [0, 0, 0], normal: [0, 0, 1]}}";
  CHECK(compared(below, below).same());
  CHECK(compared(below, "h: {halfspace: {point: [7, 1, 0], normal: [0, 0, 5]}}").same());
  CHECK(text(below, "h: {halfspace: {point: [0, 0, 1], normal: [0, 0, 1]}}")
            .starts_with("only in B: a region of unbounded volume about"));
  CHECK(
      text("p: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}}", "p: {polygon: [[0, 0, 0], [1, 0, 0], [0, 1, 0]]}")
          .starts_with("only in A: a face of unbounded area about"));
  CHECK(text("w: {complement: {polyline: [[0, 0, 0], [1, 1, 1]]}}", kBox)
            .starts_with("only in A: a region of unbounded volume about"));
  CHECK(text("w: {complement: {unify: {box: {min: [0, 0, 0], max: [2, 2, 2]}}}}",
             "w: {complement: {unify: {box: {min: [0, 0, 0], max: [2, 2, 3]}}}}") ==
        "only in A: a region of volume 4 about (1, 1, 5/2)");
}

TEST_CASE("Many pieces are told as some, and how much all are", "[compare]") {
  std::string points = "p: {points: [";
  for (int i = 0; i < 14; ++i) points += (i == 0 ? "[" : ", [") + std::to_string(i) + ", 0, 0]";
  const std::string all = text(points + "]}", "p: {points: [[0, 0, 0]]}");
  CHECK(all.starts_with("only in A: a point (1, 0, 0)/only in A: a point (2, 0, 0)/"));
  CHECK(all.ends_with("only in A: and 3 more; all 13 together: 13 points"));
}

TEST_CASE("A tree with weld is compared as it comes out by itself", "[compare]") {
  const auto near = [](const std::string& weld, const std::string& gap, const std::string& name) {
    return parse_tree("cnrg: 1\n" + weld + "materials: {rock: {}}\nnodes:\n  " + name +
                          ": {box: {min: [0, 0, 0], max: [1, 1, 1]}, material: rock}\n" +
                          "  high: {box: {min: [0, 0, " + gap +
                          "], max: [1, 1, 2]}, name: upper}\n  u: {union: [" + name + ", high]}\nresult: u\n",
                      "near.yaml");
  };
  const Tree welded = near("weld: 1e-6\n", "1.0000001", "low"),
             same = near("weld: 0.000001\n", "1.0000001", "other");
  const Tree plain = near("", "1", "low"), apart = near("", "1.0000001", "low");
  const auto result = [](const Tree& a, const Tree& b) {
    return comparison_text(compare(a, a.result, b, b.result));
  };
  CHECK(result(welded, welded).empty());
  CHECK(result(welded, same).empty());
  // The plane that both got is between the two that they had, so the line between them is elsewhere.
  CompareOptions options;
  options.features = false;
  CHECK(compare(plain, plain.result, welded, welded.result, options).same());
  CHECK(compare(welded, welded.result, plain, plain.result, options).same());
  CHECK(result(apart, welded)
            .starts_with("only in B: a region of volume 0.0000001 about (1/2, 1/2, 20000001/20000000)\n"));
  CHECK_FALSE(result(plain, apart).empty());
  const Tree endless = parse_tree(
      "cnrg: 1\nweld: 1e-6\nnodes:\n  h: {halfspace: {point: [0, 0, 0], normal: [0, 0, 1]}}\n"
      "result: h\n",
      "endless.yaml");
  CHECK_THROWS_WITH(compare(plain, plain.result, endless, endless.result),
                    Catch::StartsWith("endless.yaml:2:7: error: ") && Catch::EndsWith("cut it with a box"));
  // Faults of the tree are told as without a comparison.
  const Tree bad = parse_tree(
      "cnrg: 1\nweld: 1e-6\nnodes:\n  o: {interior: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}\n"
      "  u: {union: [o, o]}\nresult: u\n",
      "bad.yaml");
  CHECK_THROWS_WITH(compare(plain, plain.result, bad, bad.result),
                    Catch::StartsWith("bad.yaml:5:7: error: `union` of `u` takes"));
}

TEST_CASE("A fault is told in the file that has it", "[compare]") {
  const Tree good = test::tree(kBox);
  const Tree bad = parse_tree(
      "cnrg: 1\nnodes:\n  o: {interior: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}\n"
      "  u: {union: [o, o]}\nresult: u\n",
      "bad.yaml");
  CHECK_THROWS_WITH(compare(good, good.result, bad, bad.result), Catch::StartsWith("bad.yaml:4:7: error:"));
  CHECK_THROWS_WITH(compare(bad, bad.result, good, good.result), Catch::StartsWith("bad.yaml:4:7: error:"));
}

TEST_CASE("Sums of roots are told exactly", "[compare]") {
  RootSum sum;
  CHECK(sum.text() == "0");
  for (const char* square : {"1", "1/4", "2", "8", "12", "75/4"}) sum.add_root(*parse_rational(square));
  // 1 + 1/2 + sqrt 2 + 2 sqrt 2 + 2 sqrt 3 + 5/2 sqrt 3
  CHECK(sum.text() == "3/2 + 3 sqrt(2) + 9/2 sqrt(3)");
  for (int n = 2; n < 60; ++n) sum.add_root(n);
  CHECK(sum.text().ends_with(" (rounded)"));
  // By doubles: the sum of all roots from 2 to 59, and what was there before.
  double expected = 1.5 + 3 * std::sqrt(2.0) + 4.5 * std::sqrt(3.0);
  for (int n = 2; n < 60; ++n) expected += std::sqrt(static_cast<double>(n));
  CHECK(std::stod(sum.text()) == Approx(expected).epsilon(1e-11));
  // Large squares in common are found where small ones are not.
  RootSum large;
  const Integer p("1000000007"), q("1000000009");
  large.add_root(Rational(p * q)), large.add_root(Rational(p * q * p * p));
  CHECK(large.text() == "1000000008 sqrt(1000000016000000063)");
}

}  // namespace
}  // namespace cnrg
