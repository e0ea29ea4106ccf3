// Mixtures where operands overlap, against distances that are counted here by hand: a point in a box has the
// distance of its nearest side from the boundary.
#include <optional>
#include <random>
#include <string>

#include "csg/explain/explain.h"
#include "csg/materials/sampler.h"
#include "csg/operators/node_value.h"
#include "tests/catch.h"
#include "tests/evaluate/evaluated_tree.h"

namespace cnrg {
namespace {

const Group& blended(const EvaluatedTree& r) { return r.evaluation.value(r.tree.result).value->group(); }

const RegionAttributes* region_at(const EvaluatedTree& r, const RationalPoint& p) {
  const Location at = Locator(*r.evaluation.complex).locate(p);
  REQUIRE(at.dimension == 3);
  const std::uint32_t region = blended(r).region_of(at.region);
  return region == 0 ? nullptr : &blended(r).regions[region - 1];
}

Mixture mixture_at(const EvaluatedTree& r, const RationalPoint& p) {
  const RegionAttributes* region = region_at(r, p);
  return region == nullptr ? Mixture() : MaterialSampler(region->material).at(p);
}

struct Box {
  RationalPoint low, high;
  Rational depth(const RationalPoint& p) const {
    std::optional<Rational> least;
    for (int k = 0; k < 3; ++k) {
      for (const Rational& d : {Rational(p[k] - low[k]), Rational(high[k] - p[k])}) {
        if (!least || d < *least) least = d;
      }
    }
    return *least;
  }
  bool holds(const RationalPoint& p) const { return depth(p) > 0; }
};

const std::string kBlendHead =
    "cnrg: 1\nmaterials: {steel: {}, ceramic: {}, rubber: {},\n"
    "  up: {linear: {from: [0, 0, 0], to: [0, 0, 4], stops: [[0, steel], [1, rubber]]}}}\nnodes:\n";
const std::string kTwoBoxes =
    "  a: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: steel}\n"
    "  b: {box: {min: [2, 1, 1], max: [8, 7, 6]}, material: ceramic}\n";
const Box kA{{0, 0, 0}, {4, 4, 4}}, kB{{2, 1, 1}, {8, 7, 6}};

/// Points off every plane of the boxes; binary fractions, so that distances are doubles.
std::vector<RationalPoint> points(int count) {
  std::mt19937 random(7);
  std::vector<RationalPoint> out;
  for (int i = 0; i < count; ++i) {
    RationalPoint p;
    for (int k = 0; k < 3; ++k) p[k] = Rational(int(random() % 128) * 2 + 1, 32);
    out.push_back(p);
  }
  return out;
}

TEST_CASE("what two boxes share is mixed by the distances to their boundaries", "[blend]") {
  const EvaluatedTree r =
      evaluated_tree(kBlendHead + kTwoBoxes + "  r: {union: [a, b], blend: linear}\nresult: r\n");
  CHECK(blended(r).regions.size() == 3);
  CHECK(r.evaluation.rows.back().removals.empty());
  CHECK(r.evaluation.diagnostics.empty());
  int shared = 0;
  for (const RationalPoint& p : points(400)) {
    INFO(p[0] << " " << p[1] << " " << p[2]);
    const bool in_a = kA.holds(p), in_b = kB.holds(p);
    const Mixture mixture = mixture_at(r, p);
    if (!in_a || !in_b) {
      CHECK(mixture == (in_a ? Mixture{{"steel", 1}} : in_b ? Mixture{{"ceramic", 1}} : Mixture{}));
      continue;
    }
    ++shared;
    const Rational a = kA.depth(p), b = kB.depth(p), t = b / (a + b);
    CHECK(mixture == Mixture{{"ceramic", t}, {"steel", 1 - t}});
    CHECK(region_at(r, p)->name == "a & b");
    CHECK(region_at(r, p)->material.name() == "ceramic & steel");
  }
  CHECK(shared > 10);
  // On the boundaries: all of the other one; where both meet half of each.
  const MaterialSampler sampler(region_at(r, {3, 2, 2})->material);
  CHECK(sampler.at({2, 2, 2}) == Mixture{{"steel", 1}});
  CHECK(sampler.at({4, 2, 2}) == Mixture{{"ceramic", 1}});
  CHECK(sampler.at({2, 4, 2}) == Mixture{{"ceramic", Rational(1, 2)}, {"steel", Rational(1, 2)}});
  CHECK(sampler.names() == std::vector<std::string>{"ceramic", "steel"});
}

TEST_CASE("every wall of both operands stays, and touching without overlap blends nothing", "[blend]") {
  const EvaluatedTree r =
      evaluated_tree(kBlendHead + kTwoBoxes + "  r: {union: [a, b], blend: linear}\nresult: r\n");
  const EvaluatedTree all =
      evaluated_tree(kBlendHead + kTwoBoxes + "  r: {sum: [{unify: a}, {unify: b}]}\nresult: r\n");
  const NodeValue& value = *r.evaluation.value(r.tree.result).value;
  const NodeValue& sum = *all.evaluation.value(all.tree.result).value;
  CHECK(blended(r).faces.size() == selection_of(*all.evaluation.complex, sum).faces.size());
  CHECK(simplified_counts(*r.evaluation.complex, value, selection_of(*r.evaluation.complex, value))[3] == 3);
  const EvaluatedTree beside = evaluated_tree(kBlendHead +
                                              "  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}, material: steel}\n"
                                              "  b: {box: {min: [1, 0, 0], max: [2, 1, 1]}, material: ceramic}\n"
                                              "  r: {union: [a, b], blend: linear}\nresult: r\n");
  CHECK(blended(beside).regions.size() == 2);
  CHECK(mixture_at(beside, {Rational(1, 2), Rational(1, 2), Rational(1, 2)}) == Mixture{{"steel", 1}});
  CHECK(mixture_at(beside, {Rational(3, 2), Rational(1, 2), Rational(1, 2)}) == Mixture{{"ceramic", 1}});
}

TEST_CASE("a graded material is blended as it is at the point", "[blend]") {
  const std::string boxes =
      "  a: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: up}\n"
      "  b: {box: {min: [2, 1, 1], max: [8, 7, 6]}, material: ceramic}\n";
  const EvaluatedTree r = evaluated_tree(kBlendHead + boxes + "  r: {union: [a, b], blend: linear}\nresult: r\n");
  for (const RationalPoint& p : points(400)) {
    if (!kA.holds(p) || !kB.holds(p)) continue;
    const Rational a = kA.depth(p), b = kB.depth(p), t = b / (a + b), up = p[2] / 4;
    CHECK(mixture_at(r, p) == Mixture{{"ceramic", t}, {"rubber", (1 - t) * up}, {"steel", (1 - t) * (1 - up)}});
  }
}

TEST_CASE("transforms above a blend move it along, and stretch its distances", "[blend]") {
  const std::string boxes =
      "  a: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: up}\n"
      "  b: {box: {min: [2, 1, 1], max: [8, 7, 6]}, material: ceramic}\n";
  const std::string moves = "translate: [1, 2, 3], rotate: {axis: [0, 0, 1], degrees: 90}, scale: [2, 1, 3]";
  const EvaluatedTree here =
      evaluated_tree(kBlendHead + boxes + "  r: {union: [a, b], blend: linear}\nresult: r\n");
  const EvaluatedTree there = evaluated_tree(
      kBlendHead + boxes + "  u: {union: [a, b], blend: linear}\n  r: {simplify: u, " + moves + "}\nresult: r\n");
  const Transform move = Transform::scaling({2, 1, 3}) * Transform::rotation({0, 0, 1}, 90, {0, 0, 0}) *
                         Transform::translation({1, 2, 3});
  for (const RationalPoint& p : points(200)) CHECK(mixture_at(here, p) == mixture_at(there, move.apply(p)));
  // The node's own transform is done: distances are those of what is stretched.
  const EvaluatedTree own = evaluated_tree(kBlendHead + kTwoBoxes +
                                           "  r: {union: [a, b], blend: linear, scale: [1/2, 1, 1]}\nresult: r\n");
  const Box a{{0, 0, 0}, {2, 4, 4}}, b{{1, 1, 1}, {4, 7, 6}};
  const RationalPoint p{Rational(5, 4), 2, 3};
  const Rational t = b.depth(p) / (a.depth(p) + b.depth(p));
  CHECK(mixture_at(own, p) == Mixture{{"ceramic", t}, {"steel", 1 - t}});
}

TEST_CASE("operands are taken from left to right", "[blend]") {
  const EvaluatedTree r = evaluated_tree(kBlendHead + kTwoBoxes +
                                         "  c: {box: {min: [1, 2, 2], max: [3, 6, 5]}, material: rubber}\n"
                                         "  r: {union: [a, b, c], blend: linear}\nresult: r\n");
  const Box c{{1, 2, 2}, {3, 6, 5}}, both{{2, 1, 1}, {4, 4, 4}};
  const RationalPoint p{Rational(5, 2), 3, Rational(7, 2)};
  const Rational t = kB.depth(p) / (kA.depth(p) + kB.depth(p));
  const Rational u = c.depth(p) / (both.depth(p) + c.depth(p));
  CHECK(mixture_at(r, p) == Mixture{{"ceramic", (1 - u) * t}, {"rubber", u}, {"steel", (1 - u) * (1 - t)}});
  CHECK(region_at(r, p)->name == "a & b & c");
  CHECK(region_at(r, p)->material.name() == "ceramic & rubber & steel");
}

TEST_CASE("one material, and none, have nothing to blend", "[blend]") {
  for (const std::string material : {", material: steel", ""}) {
    INFO(material);
    const EvaluatedTree r = evaluated_tree(kBlendHead +
                                           "  a: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: steel}\n"
                                           "  b: {box: {min: [2, 1, 1], max: [8, 7, 6]}" +
                                           material +
                                           "}\n"
                                           "  r: {union: [a, b], blend: linear}\nresult: r\n");
    CHECK(blended(r).regions.size() == 3);
    CHECK(region_at(r, {3, 2, 2})->material == RegionMaterial("steel"));
  }
}

TEST_CASE("what is said besides of a material is not blended", "[blend]") {
  const auto boxes = [&](const std::string& of_a, const std::string& of_b) {
    return evaluated_tree(
        kBlendHead + "  a: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: steel, attributes: {" + of_a +
        "}}\n" + "  b: {box: {min: [2, 1, 1], max: [8, 7, 6]}, material: ceramic, attributes: {" + of_b + "}}\n" +
        "  r: {union: [a, b], blend: linear}\nresult: r\n");
  };
  const EvaluatedTree apart = boxes("phase: 1", "porosity: 1/2");
  CHECK(apart.evaluation.diagnostics.empty());
  CHECK(region_at(apart, {3, 2, 2})->properties ==
        Properties{{"phase", Rational(1)}, {"porosity", Rational(1, 2)}});
  CHECK(region_at(apart, {1, 2, 2})->properties == Properties{{"phase", Rational(1)}});
  const EvaluatedTree at_odds = boxes("phase: 1", "phase: 2");
  REQUIRE(at_odds.evaluation.diagnostics.size() == 1);
  CHECK_THAT(at_odds.evaluation.diagnostics[0].message, Catch::Contains("phase"));
  CHECK(region_at(at_odds, {3, 2, 2})->properties == Properties{{"phase", Rational(1)}});
}

TEST_CASE("a region without a bounded boundary cannot blend", "[blend]") {
  const std::string below = "  below: {halfspace: {point: [0, 0, 2], normal: [0, 0, 1]}, material: ceramic}\n";
  CHECK_THROWS_WITH(
      evaluated_tree(kBlendHead + kTwoBoxes + below + "  r: {union: [a, below], blend: linear}\nresult: r\n"),
      Catch::Contains("t.yaml:8:7: error:") &&
          Catch::Contains("the distance to the boundary of the region `below`, which overlaps `a` and "
                          "has an unbounded one; cut it with a box first"));
  // Where it overlaps nothing it need not.
  const std::string far = "  far: {halfspace: {point: [0, 0, -2], normal: [0, 0, 1]}, material: ceramic}\n";
  CHECK(
      blended(evaluated_tree(kBlendHead + kTwoBoxes + far + "  r: {union: [a, far], blend: linear}\nresult: r\n"))
          .regions.size() == 2);
}

TEST_CASE("what `blend` is for", "[blend]") {
  const auto refused = [&](const std::string& node) {
    return [=] { parse_tree(kBlendHead + kTwoBoxes + "  r: {" + node + "}\nresult: r\n", "t.yaml"); };
  };
  CHECK_THROWS_WITH(refused("union: [a, b], blend: smooth")(),
                    Catch::Contains("t.yaml:7:29: error: ") && Catch::Contains("linear"));
  CHECK_THROWS_WITH(refused("intersection: [a, b], blend: linear")(),
                    Catch::Contains("t.yaml:7:29: error: `blend` is for union; remove it from `intersection`"));
  CHECK_THROWS_WITH(refused("union: [a, b], blend: linear, dominance: left")(),
                    Catch::Contains("t.yaml:7:37: error: `r` blends its operands, so none of them dominates"));
  CHECK_NOTHROW(refused("union: [a, b], blend: linear, dominance: 2")());
}

TEST_CASE("explain says that a blend keeps what is of either operand", "[blend]") {
  const EvaluatedTree r =
      evaluated_tree(kBlendHead + kTwoBoxes + "  r: {union: [a, b], blend: linear}\nresult: r\n", true);
  const auto told = [&](const RationalPoint& p) {
    return explanation_text(r.tree, r.evaluation, explain(r.tree, r.evaluation, r.tree.result, p));
  };
  CHECK_THAT(told({4, 2, 2}), Catch::Contains("the walls of both operands stay"));
  CHECK_THAT(told({4, 2, 2}), Catch::Contains("kept by union.face.AinB.dominant, which never removes"));
  CHECK_THAT(told({3, 2, 2}), Catch::Contains("in both: their materials are mixed"));
  CHECK_THAT(told({3, 2, 2}), Catch::Contains("made of ceramic 1/2, steel 1/2"));
}

}  // namespace
}  // namespace cnrg
