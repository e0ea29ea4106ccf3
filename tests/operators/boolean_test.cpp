// Booleans beyond point sets: attributes, features, unbounded groups, chains of operations.
#include "csg/operators/boolean.h"

#include "csg/operators/group.h"
#include "csg/operators/identities.h"
#include "csg/operators/table_engine.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/simplify.h"
#include "tests/catch.h"
#include "tests/operators/pieces.h"
#include "tests/oracles/paper_classification.h"

namespace cnrg {
namespace {

using namespace pieces;
using Counts = std::array<std::size_t, 4>;

Counts counts(const Complex& complex, const Group& g, SimplifyMode mode = SimplifyMode::features) {
  return active_counts(simplify(complex, selection_of(complex, g), g.features, mode));
}

std::vector<Group> named_leaves(const Complex& complex) {
  std::vector<std::vector<Attributes>> attributes(complex.leaf_count);
  const char* materials[] = {"rock", "ore", "air"};
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    attributes[i] = {{"leaf" + std::to_string(i), materials[i % 3], {}}};
  }
  return leaf_groups(complex, attributes);
}

TEST_CASE("a leaf keeps its features: cuts of other leaves are none", "[leaf_group]") {
  const auto built_complex = complex_of({box({0, 0, 0}, {4, 4, 4}), box({2, 1, 1}, {6, 3, 3}),
                                         sheet({0, 0, 2}, {4, 4, 2}), wire({-1, 2, 4}, {5, 2, 4})});
  const Complex& complex = *built_complex;
  const auto leaves = leaf_groups(complex);
  CHECK(counts(complex, leaves[0]) == Counts{8, 12, 6, 1});
  CHECK(counts(complex, leaves[1]) == Counts{8, 12, 6, 1});
  CHECK(counts(complex, leaves[2]) == Counts{4, 4, 1, 0});
  CHECK(counts(complex, leaves[3]) == Counts{2, 1, 0, 0});
  for (const Group& g : leaves) CHECK(check_group(complex, g) == "");
  CHECK(leaves[0].features.vertices.size() == 8);
  CHECK(leaves[3].features.vertices.size() == 2);
}

TEST_CASE("a face cut by its leaf keeps the cut, in the point set it goes", "[leaf_group]") {
  const auto built_complex = complex_of({box({0, 0, 0}, {4, 4, 4}, 1, 0)});
  const Complex& complex = *built_complex;
  const auto leaves = leaf_groups(complex);
  CHECK(counts(complex, leaves[0]) == Counts{8 + 10, 12 + 8 + 8, 6 + 6, 1});
  CHECK(counts(complex, leaves[0], SimplifyMode::points) == Counts{8, 12, 6, 1});
}

TEST_CASE("faces of one patch part where it is planar, and are one where it is curved", "[leaf_group]") {
  // Three leaves of two squares side by side, the second square rising by 0, 1 and 2: two faces of one patch.
  Soup soup;
  for (int rise : {0, 1, 2}) {
    const LeafId leaf = soup.add_leaf(Fill::none);
    PointId p[2][3];
    for (int y : {0, 1}) {
      for (int x : {0, 1, 2}) p[y][x] = soup.add_point(x, y + 2 * rise, x == 2 ? rise : 0);
    }
    for (std::uint32_t i : {0u, 1u}) {
      const std::vector<std::vector<PointId>> loops{{p[0][i], p[0][i + 1], p[1][i + 1], p[1][i]}};
      soup.add_face(leaf, loops, i, 0);
    }
  }
  const auto complex = build_complex(soup, {});
  const auto leaves = leaf_groups(*complex);
  CHECK(counts(*complex, leaves[0]) == Counts{6, 7, 2, 0});
  CHECK(leaves[0].features.edges.size() == 7);
  CHECK(leaves[1].features.edges.size() == 6);
  CHECK(leaves[2].features.edges.size() == 6);
}

TEST_CASE("a face without area, or a part of one, has no edges", "[leaf_group]") {
  // On a side of a square: a quad that goes to and fro, and a triangle with a thorn.
  Soup soup;
  std::uint32_t number = 0;
  const auto add = [&](LeafId leaf, const std::vector<Point>& corners) {
    std::vector<std::vector<PointId>> loops(1);
    for (const auto& [x, y, z] : corners) loops[0].push_back(soup.add_point(x, y, z));
    soup.add_face(leaf, loops, number, number, 0, 0);
    ++number;
  };
  const LeafId square = soup.add_leaf(Fill::none), other = soup.add_leaf(Fill::none);
  add(square, {{0, 0, 0}, {2, 0, 0}, {2, 0, 2}, {0, 0, 2}});
  add(other, {{0, 0, 2}, {0, 0, 0}, {0, 0, 2}, {0, 1, 0}});
  add(other, {{0, 0, 0}, {0, 0, 1}, {0, 0, 0}, {0, -1, 0}, {0, -1, -1}});
  const auto built_complex = build_complex(soup);
  const Complex& complex = *built_complex;
  const auto leaves = leaf_groups(complex);
  for (const Group& g : leaves) CHECK(check_group(complex, g) == "");
  CHECK(counts(complex, leaves[0]) == Counts{4, 4, 1, 0});
  CHECK(counts(complex, leaves[1]) == Counts{3, 3, 1, 0});
  const Group both = boolean_operation(complex, BooleanOp::unite, Dominance::left, leaves[0], leaves[1]).group;
  CHECK(counts(complex, both) == Counts{4 + 2, 4 + 3, 2, 0});
}

TEST_CASE("one label in two places is two regions with one set of attributes", "[leaf_group]") {
  const auto built_complex = complex_of({box({0, 0, 0}, {1, 1, 1}) + box({2, 0, 0}, {3, 1, 1})});
  const Complex& complex = *built_complex;
  const auto leaves = named_leaves(complex);
  REQUIRE(leaves[0].regions.size() == 2);
  CHECK(leaves[0].regions[1].material == "rock");
  CHECK(leaves[0].regions[1].leaves == std::vector<LeafId>{LeafId(0)});
}

TEST_CASE("attributes follow dominance", "[attributes]") {
  const auto built_complex = complex_of({box({0, 0, 0}, {4, 4, 4}), box({2, 1, 1}, {6, 3, 3})});
  const Complex& complex = *built_complex;
  auto leaves = named_leaves(complex);
  leaves[1].dominance = 2;
  SECTION("left dominates the union: its region stays whole, the other keeps the rest") {
    const auto result = boolean_operation(complex, BooleanOp::unite, Dominance::left, leaves[0], leaves[1]);
    REQUIRE(result.group.regions.size() == 2);
    CHECK(result.conflicts.empty());
    CHECK(result.group.dominance == 2);
    for (const auto& region : result.group.regions) {
      CHECK(region.leaves.size() == (region.material == "rock" ? 2u : 1u));
    }
    CHECK(result.group.regions[0].material != result.group.regions[1].material);
  }
  SECTION("equal operands: the left one's material, reported") {
    const auto result = boolean_operation(complex, BooleanOp::unite, Dominance::equal, leaves[1], leaves[0]);
    REQUIRE(result.group.regions.size() == 1);
    CHECK(result.group.regions[0].material == "ore");
    CHECK(result.group.regions[0].name == "leaf1");
    REQUIRE(result.conflicts.size() == 1);
    CHECK(result.group.region_of(result.conflicts[0].cells.regions.at(0)) == 1);
    CHECK(result.conflicts[0].kept == "ore");
    CHECK(result.conflicts[0].other == "rock");
  }
  SECTION("equal operands: who has no material yields") {
    leaves[0].regions[0].material = {};
    const auto result = boolean_operation(complex, BooleanOp::unite, Dominance::equal, leaves[0], leaves[1]);
    CHECK(result.group.regions.at(0).material == "ore");
    CHECK(result.conflicts.empty());
  }
  SECTION("a dominant operand without a material stays without") {
    leaves[0].regions[0].material = {};
    const auto result = boolean_operation(complex, BooleanOp::intersect, Dominance::left, leaves[0], leaves[1]);
    CHECK(result.group.regions.at(0).material.empty());
  }
  SECTION("right dominates the intersection") {
    const auto result = boolean_operation(complex, BooleanOp::intersect, Dominance::right, leaves[0], leaves[1]);
    CHECK(result.group.regions.at(0).material == "ore");
  }
  SECTION("the difference keeps those of its left operand") {
    const auto result = boolean_operation(complex, BooleanOp::subtract, Dominance::right, leaves[0], leaves[1]);
    REQUIRE(result.group.regions.size() == 1);
    CHECK(result.group.regions[0].material == "rock");
    CHECK(result.group.regions[0].leaves == std::vector<LeafId>{LeafId(0)});
  }
}

TEST_CASE("a notch has the features of the tool", "[features]") {
  const auto built_complex = complex_of({box({0, 0, 0}, {4, 4, 4}), box({2, 1, 1}, {6, 3, 3}, 1, 0)});
  const Complex& complex = *built_complex;
  const auto leaves = leaf_groups(complex);
  const Group result =
      boolean_operation(complex, BooleanOp::subtract, Dominance::equal, leaves[0], leaves[1]).group;
  // The bottom of the notch is cut into four by the tool.
  CHECK(counts(complex, result) == Counts{8 + 4 + 4 + 5, 12 + 4 + 4 + 8 + 4, 6 + 4 + 4, 1});
  CHECK(counts(complex, result, SimplifyMode::points) == Counts{16, 24, 11, 1});
}

TEST_CASE("a step of a fold asks what the steps before it have left", "[boolean]") {
  const auto fold = [](const Complex& complex, BooleanOp op, const std::vector<Group>& groups) {
    const Group* first = &groups[0];
    const LeafOrder order;
    TableEngine engine(complex, op, std::span(&first, 1), order);
    FoldStep step;
    for (std::size_t i = 1; i < groups.size(); ++i) {
      const Group* next = &groups[i];
      engine.step(Dominance::left, std::span(&next, 1), step);
    }
    return engine.group();
  };
  // A sheet hangs in a box, up to half of its height; what is above it goes, and then it parts two regions.
  const Point low{2, 0, 0}, high{2, 4, 2};
  const auto built_complex =
      complex_of({box({0, 0, 0}, {4, 4, 4}) + sheet(low, high, 1), box({1, -1, 2}, {3, 5, 5}), sheet(low, high)});
  const Complex& complex = *built_complex;
  const auto leaves = leaf_groups(complex);
  const Group alone = fold(complex, BooleanOp::subtract, {leaves[0], leaves[2]});
  CHECK(alone.regions.size() == 1);
  CHECK(counts(complex, alone) == Counts{8 + 4, 12 + 3 + 2, 6 + 1, 1});  // its rim on the box stays as features
  const Group parted = fold(complex, BooleanOp::subtract, leaves);
  CHECK(parted.regions.size() == 2);
  CHECK(counts(complex, parted) == Counts{16 + 4, 24 + 4 + 4, 10 + 4 + 1, 2});
  // Of the third box, a part is in the first one alone.
  const auto built_boxes =
      complex_of({box({0, 0, 0}, {4, 4, 4}), box({2, 0, 0}, {6, 4, 4}), box({0, 1, 1}, {6, 3, 3})});
  const Group common = fold(*built_boxes, BooleanOp::intersect, leaf_groups(*built_boxes));
  std::vector<RegionId> cells;
  for (const auto& cell : common.cells) cells.push_back(cell.first);
  CHECK(*volume(*built_boxes, cells) == 2 * 2 * 2);
  CHECK(common.regions.size() == 1);
}

TEST_CASE("identities find what is wrong", "[identities]") {
  const auto built_complex = complex_of({box({0, 0, 0}, {4, 4, 4}), box({2, 1, 1}, {6, 3, 3})});
  const Complex& complex = *built_complex;
  const auto leaves = leaf_groups(complex);
  const Group good = boolean_operation(complex, BooleanOp::unite, Dominance::left, leaves[0], leaves[1]).group;
  Group bad = good;
  bad.faces.pop_back();
  CHECK(check_group(complex, bad) != "");
  bad = good;
  bad.cells.pop_back();
  CHECK(check_boolean(complex, BooleanOp::unite, leaves[0], leaves[1], bad) != "");
  bad = good;
  bad.vertices.pop_back();
  CHECK(check_group(complex, bad).find("closed") != std::string::npos);
  CHECK(check_point_set(complex, BooleanOp::intersect, leaves[0], leaves[1], good) != "");
  CHECK(check_volumes(complex, BooleanOp::subtract, leaves[0], leaves[1], good) != "");
}

}  // namespace
}  // namespace cnrg
