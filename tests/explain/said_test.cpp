// What explanations tell of names, materials and attributes: who gave them, what gave way. By hand.
#include <string>

#include "csg/explain/explain.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

/// The lines that say so, node by node: `bolts: material `steel`, given here/...`.
std::string said_at(const std::string& nodes, const RationalPoint& point) {
  const Tree tree = parse_tree(
      "cnrg: 1\nmaterials: {rock: {}, clay: {}, steel: {}, iron: {}}\nnodes:\n" + nodes + "result: model\n",
      "t.yaml");
  EvaluateOptions options;
  options.keep_all = true;
  const Evaluation evaluation = evaluate(tree, options);
  const Explanation e = explain(tree, evaluation, tree.result, point);
  std::string out;
  for (const LifeStep& step : e.classes.front().life) {
    for (const Word& word : step.said) {
      out += step.name + ": " + word.key + " " + (word.value.empty() ? "-" : word.value) +
             (word.given ? " given" : "");
      for (const std::string& from : word.from) out += " from " + from;
      for (const auto& [name, other] : word.gave_way) out += " not " + other + " of " + name;
      out += "/";
    }
  }
  return out;
}

const std::string kGround =
    "  low:    {box: {min: [0, 0, 0], max: [4, 4, 2]}, material: rock}\n"
    "  lens:   {box: {min: [1, 1, 0], max: [3, 3, 1]}, material: clay, attributes: {porosity: 1/4}}\n";
const std::string kBolts =
    "  first:  {polyline: [[1, 1, 1], [1, 1, 5]], attributes: {diameter: 25}}\n"
    "  second: {polyline: [[1, 1, 2], [1, 1, 6]], material: iron, attributes: {diameter: \"25\"}}\n";

TEST_CASE("a region's material, and what gave way to it", "[explain]") {
  const RationalPoint in_lens{2, 2, Rational(1, 2)};
  const std::string leaves = "low: material rock given/lens: material clay given/lens: porosity 1/4 given/";
  CHECK(said_at(kGround + "  model: {union: [low, lens]}\n", in_lens) ==
        leaves + "model: material rock from low not clay of lens/model: name low from low not lens of lens/");
  CHECK(said_at(kGround + "  model: {union: [low, lens], dominance: right}\n", in_lens) ==
        leaves + "model: material clay from lens not rock of low/model: name lens from lens not low of low/");
  CHECK(said_at(kGround + "  model: {union: [low, lens], material: iron, name: all}\n", in_lens) ==
        leaves +
            "model: material iron given not rock of low not clay of lens/"
            "model: name all given not low of low not lens of lens/");
  CHECK(said_at(kGround + "  model: {difference: [low, {box: {min: [3, 3, 1], max: [4, 4, 2]}}]}\n", {1, 1, 1}) ==
        "low: material rock given/");  // it is handed on
}

TEST_CASE("wires speak for themselves", "[explain]") {
  const RationalPoint both{1, 1, 3}, first{1, 1, Rational(3, 2)};
  CHECK(said_at(kBolts + "  model: {union: [first, second]}\n", both) ==
        "first: diameter 25 given/second: diameter \"25\" given/second: material iron given/"
        "model: diameter 25 from first not \"25\" of second/");
  const std::string bolts = kBolts + "  bolts: {union: [first, second], material: steel, name: bolts}\n";
  // In rock, which says nothing of a wire.
  CHECK(said_at(kGround + bolts + "  model: {union: [bolts, low], dominance: left}\n", first) ==
        "first: diameter 25 given/bolts: material steel given/bolts: name bolts given/low: material rock given/");
  CHECK(said_at(bolts + "  model: {unify: bolts}\n", both) ==
        "first: diameter 25 given/second: diameter \"25\" given/second: material iron given/"
        "bolts: diameter 25 from first not \"25\" of second/bolts: material steel given not iron of second/"
        "bolts: name bolts given/");
}

TEST_CASE("names that are lost or joined, and a wire in a sheet", "[explain]") {
  const std::string twice =
      "  a: {polyline: [[1, 1, 1], [1, 1, 5]], name: bolts, attributes: {k: 1}}\n"
      "  b: {polyline: [[1, 1, 1], [1, 1, 5]]}\n";
  CHECK(said_at(twice + "  model: {union: [a, b], dominance: right}\n", {1, 1, 3}) ==
        "a: k 1 given/a: name bolts given/model: k - not 1 of a/model: name - not bolts of a/");
  CHECK(said_at(twice + "  model: {union: [a, b]}\n", {1, 1, 3}) == "a: k 1 given/a: name bolts given/");
  CHECK(
      said_at("  left: {box: {min: [0, 0, 0], max: [2, 2, 2]}}\n  right: {box: {min: [1, 0, 0], max: [3, 2, 2]}}\n"
              "  model: {sum: [left, right]}\n",
              {Rational(3, 2), 1, 1}) == "model: name left & right from left from right/");
  CHECK(said_at("  fault: {polygon: [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], material: clay, attributes: "
                "{open: 1}}\n"
                "  bolt: {polyline: [[1, 1, 0], [3, 1, 0]], material: steel}\n"
                "  model: {union: [fault, bolt], dominance: left}\n",
                {2, 1, 0}) ==
        "bolt: material steel given/model: material steel from bolt not clay of fault/"
        "model: open - not 1 of fault/");
}

}  // namespace
}  // namespace cnrg
