// Circles that are a meridian of one leaf and go around another one: bends of pipes, and balls in tori.
#include <algorithm>

#include "tests/carriers/rows.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

std::mt19937_64 fineness(21);
std::string segments() { return number(std::uniform_int_distribution<int>(6, 30)(fineness)); }

/// A bend of a pipe of radius 1 along a circle of radius 3 about z, from x to y.
std::string bend(const std::string& name, const std::string& at) {
  return "  " + name +
         ": {revolve: {profile: [[4, 0], {bezier: [[4, 1]], weights: [1, 1, 2]}, [3, 1], {bezier: [[2, 1]],\n"
         "    weights: [1, 1, 2]}, [2, 0], {bezier: [[2, -1]], weights: [1, 1, 2]}, [3, -1], {bezier: [[4, -1]],\n"
         "    weights: [1, 1, 2]}], degrees: 90, segments: " +
         segments() + "}" + at + "}\n";
}
std::string leaf(const std::string& name, const std::string& shape, const std::string& at) {
  return "  " + name + ": {" + shape + ", segments: " + segments() + "}" + at + "}\n";
}

TEST_CASE("a bend goes on as a straight pipe, and in another bend") {
  std::mt19937_64 random(22);
  for (int i = 0; i < 8; ++i) {
    const std::string at = i == 0 ? "" : placed(random) + (i % 3 == 2 ? ", scale: [1, 2, 0.7]" : "");
    std::vector<std::string> leaves{bend("a", at),
                                    leaf("b", "cylinder: {from: [3, 0, 0], to: [3, -5, 0], radius: 1", at)};
    std::shuffle(leaves.begin(), leaves.end(), random);
    std::string nodes;
    for (const std::string& line : leaves) nodes += line;
    INFO(nodes);
    CHECK(evaluated(nodes + "  model: {unify: {union: [a, b]}}\n").rows.back().cells == Cells{0, 3, 4, 1});
  }
  for (int i = 0; i < 4; ++i) {
    // From one bend into the next, in its plane and out of it, and on through a pipe.
    const std::string at = i == 0 ? "" : placed(random);
    const std::string nodes =
        bend("a", "") + bend("b", ", rotate: {axis: [0, 0, 1], degrees: 180}, translate: [6, 0, 0]") +
        bend("c", ", rotate: {axis: [0, 1, 0], degrees: 77, center: [3, 0, 0]}, mirror: {normal: [0, 1, 0]}") +
        leaf("d", "cylinder: {from: [0, 3, 0], to: [-4, 3, 0], radius: 1", "");
    INFO(nodes << at);
    for (const std::string next : {"b", "c"}) {
      const Evaluation found = evaluated(nodes + "  model: {unify: {union: [a, " + next + ", d]}" + at + "}\n");
      CHECK(found.rows.back().cells == Cells{0, 4, 5, 1});
    }
  }
}

TEST_CASE("a ball fills the tube of a torus") {
  std::mt19937_64 random(23);
  for (int i = 0; i < 8; ++i) {
    const std::string at = i == 0 ? "" : placed(random) + (i % 3 == 2 ? ", scale: [1, 2, 0.7]" : "");
    const std::string radius = i % 2 == 0 ? "3" : "1.2";
    const std::string nodes =
        leaf("a", "torus: {center: [0, 0, 0], axis: [0, 0, 1], radius: " + radius + ", tube: 1", at) +
        leaf("b", "sphere: {center: [0, -" + radius + ", 0], radius: 1", at) +
        "  rest: {difference: [a, b]}\n  all: {union: [a, b]}\n  model: {union: [all, rest], dominance: left}\n";
    INFO(nodes);
    const Evaluation found = evaluated(nodes);
    for (const NodeRow& row : found.rows) {
      if (row.name == "rest") CHECK(row.cells == Cells{0, 1, 3, 1});
      if (row.name == "all") CHECK(row.cells == Cells{0, 0, 1, 1});
    }
  }
  // At the end of a bend, half of it inside.
  for (int i = 0; i < 4; ++i) {
    const std::string nodes = bend("a", "") + leaf("b", "sphere: {center: [3, 0, 0], radius: 1", "") +
                              leaf("c", "cylinder: {from: [3, 0, 0], to: [3, -4, 0], radius: 1", "");
    INFO(nodes);
    CHECK(evaluated(nodes + "  model: {unify: {union: [a, b]}}\n").rows.back().cells == Cells{0, 2, 3, 1});
    CHECK(evaluated(nodes + "  model: {unify: {union: [a, b, c]}}\n").rows.back().cells == Cells{0, 3, 4, 1});
  }
}

}  // namespace
}  // namespace cnrg
