// Patches of different leaves on one surface have one number, and so are one face.
#include "csg/carriers/surface_numbers.h"

#include <set>
#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/evaluate/prepared_leaves.h"
#include "tests/carriers/rows.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Cells = std::array<std::size_t, 4>;

Tree tree_of(const std::string& nodes) {
  return parse_tree("cnrg: 1\nnodes:\n" + nodes + "result: model\n", "t.yaml");
}

/// Of each leaf, the numbers of its curved patches in their order.
std::vector<std::vector<std::uint32_t>> numbers(const std::vector<std::string>& leaves) {
  std::string nodes, names;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    nodes += "  n" + std::to_string(i) + ": {" + leaves[i] + "}\n";
    names += (i > 0 ? ", n" : "n") + std::to_string(i);
  }
  const Tree tree = tree_of(nodes + "  model: {union: [" + names + "]}\n");
  const PreparedLeaves prepared(tree, unfold(tree, {tree.result}));
  std::vector<std::vector<std::uint32_t>> result;
  for (const auto& of : surface_numbers(prepared.instances())) {
    result.emplace_back();
    for (const std::uint32_t number : of) {
      if (number != 0) result.back().push_back(number);
    }
  }
  return result;
}

/// True if all leaves have one curved surface, the same.
bool one(const std::vector<std::string>& leaves) {
  std::set<std::uint32_t> all;
  for (const auto& of : numbers(leaves)) {
    if (of.empty()) return false;
    all.insert(of.begin(), of.end());
  }
  return all.size() == 1;
}

TEST_CASE("surfaces are compared whatever shape and transform they came with") {
  const std::string sphere = "sphere: {center: [1, 2, 3], radius: 2}";
  CHECK(one({sphere,
             "sphere: {center: [0, 0, 0], radius: 1, segments: 7}, scale: 2, "
             "rotate: {axis: [1, 1, 0], degrees: 20}, translate: [1, 2, 3]",
             "revolve: {profile: [[0, -2], {bezier: [[2, -2]], weights: [1, 1, 2]}, [2, 0], "
             "{bezier: [[2, 2]], weights: [1, 1, 2]}, [0, 2]], center: [1, 2, 3], axis: [2, 3, 6]}"}));
  CHECK_FALSE(one({sphere, "sphere: {center: [1, 2, 3], radius: 2.000000000001}"}));
  CHECK_FALSE(one({sphere, "sphere: {center: [1, 2, 3.000000000001], radius: 2}"}));

  const std::string cylinder = "cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 1}";
  CHECK(one({cylinder, "cylinder: {from: [0, 0, 9], to: [0, 0, 5], radius: 1}",
             "cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 1}, scale: [1, 1, 3]",
             "extrude: {profile: [[1, 0, 0], {bezier: [[1, 1, 0]], weights: [1, 1, 2]}, [0, 1, 0], [0, 0, 0]], "
             "vector: [0, 0, 2]}"}));
  CHECK_FALSE(one({cylinder, "cylinder: {from: [0, 0, 0], to: [0, 1, 4], radius: 1}"}));
  CHECK_FALSE(one({cylinder, "cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 1}, scale: [1, 2, 1]"}));

  const std::string cone = "cone: {from: [0, 0, 0], to: [0, 0, 4], radius: 2, top: 1}";
  CHECK(one({cone, "cone: {from: [0, 0, 8], to: [0, 0, 4], radius: 0, top: 1}"}));
  // Of the wedge's two curved patches one is a cylinder.
  CHECK(numbers({cone, "cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 1}",
                 "revolve: {profile: [[2, 0], [1, 4], [1, 0]], degrees: 90}"})[2] ==
        std::vector<std::uint32_t>{1, 2});
  CHECK_FALSE(one({cone, "cone: {from: [0, 0, 0], to: [0, 0, 4], radius: 2, top: 1.01}"}));

  const std::string torus = "torus: {center: [1, 0, 0], axis: [0, 0, 1], radius: 3, tube: 1}";
  CHECK(one({torus, "torus: {center: [1, 0, 0], axis: [0, 0, -2], radius: 3, tube: 1, segments: 9}",
             "torus: {center: [0, 0, 0], axis: [1, 0, 0], radius: 3/2, tube: 1/2}, scale: 2, "
             "rotate: {axis: [0, 1, 0], degrees: 90}, translate: [1, 0, 0]"}));
  CHECK_FALSE(one({torus, "torus: {center: [1, 0, 0], axis: [0, 0, 1], radius: 3, tube: 1.5}"}));
}

TEST_CASE("surfaces that are stretched alike are one") {
  const std::string by = ", scale: [2, 3, 1/5], rotate: {axis: [1, 2, 3], degrees: 50}, translate: [1/3, 0, 2]";
  CHECK(one({"sphere: {center: [1, 2, 3], radius: 2}" + by,
             "sphere: {center: [1, 2, 3], radius: 2, segments: 9}" + by}));
  CHECK(one({"torus: {center: [1, 0, 0], axis: [0, 1, 1], radius: 3, tube: 1}" + by,
             "torus: {center: [1, 0, 0], axis: [0, 1, 1], radius: 3, tube: 1, rings: 9}" + by}));
  CHECK_FALSE(one({"torus: {center: [1, 0, 0], axis: [0, 1, 1], radius: 3, tube: 1}" + by,
                   "torus: {center: [1, 0, 0], axis: [0, 1, -1], radius: 3, tube: 1, rings: 9}" + by}));
}

TEST_CASE("patches, their parts and walls are compared by their nets") {
  // Half of the second patch in u is the first one.
  const std::string net =
      "bezier: {patch: [[[0, 0, 0], [1, 0, 1], [2, 0, 0]], [[0, 1, 0], [1, 1, 2], [2, 1, 0]]]}";
  const std::string part =
      "bezier: {patch: [[[0, 0, 0], [1/2, 0, 1/2], [1, 0, 1/2]], [[0, 1, 0], [1/2, 1, 1], [1, 1, 1]]]}";
  CHECK(one({net, part}));
  CHECK(one({net, net + ", rotate: {axis: [0, 0, 1], degrees: 180, center: [1, 1/2, 0]}"}) == false);
  CHECK(one({"extrude: {profile: [[0, 0, 0], {bezier: [[1, 2, 0]]}, [2, 0, 0]], vector: [0, 0, 1]}",
             "bezier: {patch: [[[0, 0, 5], [1, 2, 5], [2, 0, 5]], [[0, 0, 9], [1, 2, 9], [2, 0, 9]]]}"}));
  // What is flat has no number.
  CHECK(
      numbers({"bezier: {patch: [[[0, 0, 0], [1, 2, 0], [2, 0, 0]], [[0, 5, 0], [1, 6, 0], [3, 5, 0]]]}", net})[0]
          .empty());
}

TEST_CASE("what two leaves make of one surface is one face") {
  const std::string halves =
      "  ball: {sphere: {center: [0, 0, 0], radius: 1, segments: 16}}\n"
      "  turned: {sphere: {center: [0, 0, 0], radius: 1, segments: 9}, rotate: {axis: [1, 2, 2], degrees: 30}}\n"
      "  upper: {box: {min: [-2, -2, 0], max: [2, 2, 2]}}\n"
      "  lower: {box: {min: [-2, -2, -2], max: [2, 2, 0]}}\n"
      "  a: {intersection: [ball, upper]}\n  b: {intersection: [turned, lower]}\n  both: {union: [a, b]}\n";
  // A group keeps the equator, where leaves have borders; regularized, nothing of it is left.
  CHECK(row(halves + "  model: {regularize: both}\n").cells == Cells{0, 0, 1, 1});
  const std::string pipes =
      "  down: {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 1, segments: 12}}\n"
      "  up: {cylinder: {from: [0, 0, 1], to: [0, 0, 5], radius: 1, segments: 7}}\n"
      "  lower: {box: {min: [-2, -2, -2], max: [2, 2, 2]}}\n"
      "  upper: {box: {min: [-2, -2, 2], max: [2, 2, 9]}}\n"
      "  a: {intersection: [down, lower]}\n  b: {intersection: [up, upper]}\n  both: {union: [a, b]}\n";
  CHECK(row(pipes + "  model: {regularize: both}\n").cells == Cells{0, 2, 3, 1});
  // The curve in which a third one crosses both is one curve.
  CHECK(row(pipes + "  c: {cylinder: {from: [-3, 0, 2], to: [0, 0, 2], radius: 1/2, segments: 16}}\n"
                    "  d: {union: [both, c]}\n  model: {regularize: d}\n")
            .cells == Cells{0, 4, 5, 1});  // the third one's side and its far end
}

TEST_CASE("the wall of a hole is one face, also where it belongs to what was cut") {
  CHECK(row("  box: {box: {min: [-2, -2, 0], max: [2, 2, 1]}}\n"
            "  pin: {cylinder: {from: [0, 0, -1], to: [0, 0, 2], radius: 1, segments: 12}}\n"
            "  inside: {interior: pin}\n  model: {subtract: [box, inside]}\n")
            .cells == Cells{8, 14, 7, 1});
}

}  // namespace
}  // namespace cnrg
