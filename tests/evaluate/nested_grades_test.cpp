// Gradients of gradients: products of fractions at the point, one placement for all, targets of inner ones.
#include <string>

#include "csg/materials/sampler.h"
#include "csg/operators/node_value.h"
#include "tests/catch.h"
#include "tests/evaluate/evaluated_tree.h"

namespace cnrg {
namespace {

RegionMaterial material_of(const EvaluatedTree& r, Component component = 1) {
  return r.evaluation.value(r.tree.result).value->attributes(component).material;
}

TEST_CASE("fractions of nested gradients are products at the point", "[grades]") {
  const EvaluatedTree r = evaluated_tree(R"(cnrg: 1
materials:
  outer: {linear: {from: [0, 0, 0], to: [4, 0, 0], stops: [[0, alloy], [1, {glaze: 1/2, alloy: 1/4, rubber: 1/4}]]}}
  alloy: {linear: {from: [0, 0, 0], to: [0, 4, 0], stops: [[0, steel], [1, tin]]}}
  glaze: {distance: {to: skin, stops: [[0, ceramic], [2, alloy]]}}
  steel: {}
  tin: {}
  ceramic: {}
  rubber: {}
nodes:
  skin: {polygon: [[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]]}
  r: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: outer}
result: r
)");
  const RegionMaterial material = material_of(r);
  const MaterialSampler sampler(material);
  CHECK(sampler.names() == std::vector<std::string>{"ceramic", "rubber", "steel", "tin"});
  for (const RationalPoint& p : {RationalPoint{1, 1, 1}, RationalPoint{3, 2, Rational(1, 2)},
                                 RationalPoint{4, 4, 3}, RationalPoint{0, 3, 0}}) {
    const Rational s = p[0] / 4, tin = p[1] / 4, far = p[2] < 2 ? Rational(p[2] / 2) : Rational(1);
    const Rational alloy = (1 - s) + s / 4 + s / 2 * far, ceramic = s / 2 * (1 - far), rubber = s / 4;
    Mixture expected;
    for (const auto& [name, part] :
         Mixture{{"ceramic", ceramic}, {"rubber", rubber}, {"steel", alloy * (1 - tin)}, {"tin", alloy * tin}}) {
      if (part != 0) expected.emplace_back(name, part);
    }
    CHECK(sampler.at(p) == expected);
  }
  // Nobody warns of the node that an inner distance is measured to.
  CHECK(reading_warnings(r.tree, {r.tree.result}).empty());
}

TEST_CASE("nested gradients stand where the outer one does", "[grades]") {
  const std::string head = R"(cnrg: 1
materials:
  outer: {linear: {from: [0, 0, 0], to: [4, 0, 0], stops: [[0, inner], [1, rubber]]}}
  inner: {linear: {from: [0, 0, 0], to: [0, 4, 0], stops: [[0, steel], [1, tin]]}}
  steel: {}
  tin: {}
  rubber: {}
nodes:
  a: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: outer}
)";
  const std::string move = "translate: [1, 2, 3], rotate: {axis: [0, 0, 1], degrees: 90}, scale: [2, 3, 1]";
  const EvaluatedTree here = evaluated_tree(head + "result: a\n"),
                      there = evaluated_tree(head + "  r: {simplify: a, " + move + "}\nresult: r\n");
  const Transform moved = Transform::scaling({2, 3, 1}) * Transform::rotation({0, 0, 1}, 90, {0, 0, 0}) *
                          Transform::translation({1, 2, 3});
  const RegionMaterial at_home = material_of(here), away = material_of(there);
  const RationalPoint p{1, 3, 2};
  CHECK(MaterialSampler(at_home).at(p) ==
        Mixture{{"rubber", Rational(1, 4)}, {"steel", Rational(3, 16)}, {"tin", Rational(9, 16)}});
  CHECK(MaterialSampler(away).at(moved.apply(p)) == MaterialSampler(at_home).at(p));
}

TEST_CASE("a chain of many gradients, each named twice, costs no more than its length", "[grades]") {
  constexpr int kDepth = 20000;
  std::string text = "cnrg: 1\nmaterials:\n  m0: {}\n  other: {}\n";
  for (int i = 1; i <= kDepth; ++i) {
    const std::string below = "m" + std::to_string(i - 1);
    text += "  m" + std::to_string(i) + ": {linear: {from: [0, 0, 0], to: [0, 0, 1], stops: [[0, " + below +
            "], [1, " + below + "]]}}\n";
  }
  text += "  top: {linear: {from: [0, 0, 0], to: [0, 0, 1], stops: [[0, m" + std::to_string(kDepth) +
          "], [1, other]]}}\nnodes:\n  r: {box: {min: [0, 0, 0], max: [1, 1, 1]}, material: top}\nresult: r\n";
  const RegionMaterial material = material_of(evaluated_tree(text));
  CHECK(MaterialSampler(material).at({0, 0, Rational(1, 3)}) ==
        Mixture{{"m0", Rational(2, 3)}, {"other", Rational(1, 3)}});
}

TEST_CASE("a material that is made of itself is refused where it is named", "[grades]") {
  const auto read = [](const std::string& materials) {
    return parse_tree("cnrg: 1\nmaterials:\n  steel: {}\n" + materials +
                          "nodes:\n  r: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\nresult: r\n",
                      "t.yaml");
  };
  const std::string way = "{linear: {from: [0, 0, 0], to: [0, 0, 1], stops: [[0, steel], [1, ";
  CHECK_THROWS_WITH(
      read("  a: " + way + "a]]}}\n"),
      Catch::Contains("t.yaml:4:72: error: the material `a` is made of itself: `a` -> `a`; remove one of "
                      "the mentions"));
  CHECK_THROWS_WITH(
      read("  a: " + way + "b]]}}\n  b: " + way + "{c: 1/2, steel: 1/2}]]}}\n  c: " + way + "b]]}}\n"),
      Catch::Contains("t.yaml:6:72: error: the material `b` is made of itself: `b` -> `c` -> `b`"));
  CHECK_NOTHROW(read("  a: " + way + "b]]}}\n  b: " + way + "steel]]}}\n"));
  CHECK_THROWS_WITH(read("  a: " + way + "stel]]}}\n"),
                    Catch::Contains("t.yaml:4:72: error: the material `stel` is "
                                    "not declared"));
}

}  // namespace
}  // namespace cnrg
