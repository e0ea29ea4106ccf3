// The operators of CNRG on small scenes whose components can be counted by hand (csg/SEMANTICS.md#components).
#include "csg/operators/cnrg.h"

#include "csg/operators/component_attributes.h"
#include "csg/operators/component_lists.h"
#include "csg/operators/group.h"
#include "csg/operators/identities.h"
#include "csg/operators/node_value.h"
#include "tests/catch.h"
#include "tests/operators/pieces.h"

namespace cnrg {
namespace {

using namespace pieces;

struct Scene {
  const std::shared_ptr<const Complex> built;
  const Complex& complex = *built;
  std::vector<Components> leaves;
  explicit Scene(const std::vector<Piece>& pieces, const std::vector<std::vector<Attributes>>& names = {})
      : built(complex_of(pieces)) {
    for (const Group& group : leaf_groups(complex, names)) leaves.push_back(components_of(complex, group));
  }
  Components one(std::size_t leaf) const { return unify(complex, leaves[leaf]).value; }
};

std::array<std::size_t, 4> component_sizes(const Components& x) {
  const Selection& s = x.selection;
  return {s.vertices.size(), s.edges.size(), s.faces.size(), s.regions.size()};
}

std::vector<std::string> names(const Components& x) {
  std::vector<std::string> out;
  for (const auto& a : x.attributes) out.push_back(a.name);
  return out;
}

const std::vector<std::vector<Attributes>> kTwo{{{"a", "rock", {}}}, {{"b", "ore", {}}}};

}  // namespace

TEST_CASE("a group is its regions and its entities", "[cnrg]") {
  const Scene s({parted_box({0, 0, 0}, {4, 2, 2}, 2) + wire({0, 0, 0}, {-1, 0, 0})},
                {{{"l", "", {}}, {"r", "", {}}}});
  CHECK(check_components(s.complex, s.leaves[0]) == "");
  CHECK(names(s.leaves[0]) == std::vector<std::string>{"l", "r", "entities"});
  const Group again = group_of(s.complex, s.leaves[0]);
  CHECK(check_group(s.complex, again) == "");
  const Group first = leaf_groups(s.complex)[0];
  CHECK(again.faces == first.faces);
  CHECK(again.edges == first.edges);
  CHECK(again.vertices == first.vertices);
  CHECK(again.cells == first.cells);
  CHECK(again.features.edges == first.features.edges);
}

TEST_CASE("dominance gives the common part its name and material", "[cnrg]") {
  const Scene s({box({0, 0, 0}, {2, 2, 2}), box({1, 0, 0}, {3, 2, 2})}, kTwo);
  Components x = s.one(0), y = s.one(1);
  const ComponentsResult equal = product(s.complex, x, y);
  REQUIRE(equal.conflicts.size() == 1);
  CHECK(equal.conflicts[0].kept == "rock");
  CHECK(equal.conflicts[0].other == "ore");
  CHECK(equal.conflicts[0].cells == support(equal.value.selection));
  CHECK(equal.value.attributes.at(0).material == "rock");
  y.attributes.at(0).dominance = 2;
  const ComponentsResult right = product(s.complex, x, y);
  CHECK(right.conflicts.empty());
  CHECK(right.value.attributes.at(0).name == "b");
  CHECK(right.value.attributes.at(0).material == "ore");
  CHECK(right.value.attributes.at(0).dominance == 2);
  const ComponentsResult left = product(s.complex, x, y, Dominance::left);
  CHECK(left.value.attributes.at(0).material == "rock");
  y.attributes.at(0).dominance = x.attributes.at(0).dominance;
  const ComponentsResult told = product(s.complex, x, y, Dominance::right);
  CHECK(told.conflicts.empty());
  CHECK(told.value.attributes.at(0).material == "ore");
}

TEST_CASE("materials of solids that only touch are no conflict", "[cnrg]") {
  const Scene s({box({0, 0, 0}, {2, 2, 2}), box({2, 0, 0}, {3, 2, 2})}, kTwo);
  const ComponentsResult wall = product(s.complex, s.one(0), s.one(1));
  CHECK(wall.conflicts.empty());
  CHECK(component_sizes(wall.value) == std::array<std::size_t, 4>{4, 4, 1, 0});
}

TEST_CASE("aggregate keeps components apart and names an overlap", "[cnrg]") {
  const Scene s({box({0, 0, 0}, {2, 2, 2}), box({1, 0, 0}, {3, 2, 2}), box({5, 0, 0}, {6, 1, 1})});
  const Components x = s.one(0), y = s.one(1), z = s.one(2);
  const Components rest = subtract(s.complex, y, x).value;
  const std::vector<const Components*> apart{&x, &rest, &z};
  const std::vector<std::string> called{"x", "rest", "z"};
  const Components all = aggregate(s.complex, apart, called).value;
  CHECK(all.attributes.size() == 3);
  CHECK(check_components(s.complex, all) == "");
  const std::vector<const Components*> over{&z, &x, &y};
  using Catch::Contains;
  CHECK_THROWS_WITH(aggregate(s.complex, over, called),
                    Contains("`rest` and `z` overlap") && Contains("with `subtract`"));
  const std::vector<const Components*> one{&x};
  CHECK(aggregate(s.complex, one, {called.data(), 1}).value.attributes.size() == 1);
}

TEST_CASE("aggregate sees overlaps of points, of wires and of sheets", "[cnrg]") {
  using Catch::Contains;
  const std::vector<std::string> called{"x", "y"};
  for (const auto& leaves : {std::vector{point({1, 0, 0}), point({1, 0, 0})},
                             std::vector{wire({0, 0, 0}, {2, 0, 0}), wire({0, 0, 0}, {2, 0, 0})},
                             std::vector{sheet({0, 0, 0}, {2, 2, 0}), sheet({0, 0, 0}, {2, 2, 0})}}) {
    const Scene s(leaves);
    const Components x = s.one(0), y = s.one(1);
    const std::vector<const Components*> operands{&x, &y};
    CHECK_THROWS_WITH(aggregate(s.complex, operands, called), Contains("`x` and `y` overlap"));
  }
}

TEST_CASE("a plane is a component of entities though it has no vertex", "[cnrg]") {
  // As in a frame: a face whose boundary is no entity.
  const Scene s({box({0, 0, 0}, {2, 2, 2})});
  Group plane;
  const Group box = leaf_groups(s.complex)[0];
  plane.faces = {box.faces[0]};
  plane.origins.sets = box.origins.sets;
  plane.origins.faces = {box.origins.faces[0]};
  const Components x = components_of(s.complex, plane);
  CHECK(check_components(s.complex, x) == "");
  REQUIRE(names(x) == std::vector<std::string>{"entities"});
  CHECK(x.attributes[0].leaves == std::vector<LeafId>{LeafId(0)});
  CHECK(NodeValue(s.complex, plane).component_count() == 1);
}

TEST_CASE("closed components become a group with walls between them", "[cnrg]") {
  const Scene s({box({0, 0, 0}, {2, 2, 2}), box({1, 0, 0}, {3, 2, 2})}, kTwo);
  const Components parts = sum(s.complex, s.one(0), s.one(1)).value;
  const Group group = group_of(s.complex, parts);
  CHECK(check_group(s.complex, group) == "");
  CHECK(group.regions.size() == 3);
  for (const RegionAttributes& region : group.regions) {
    CHECK(region.leaves.size() == (region.name == "a & b" ? 2u : 1u));
  }
  const Group joined = group_of(s.complex, unify(s.complex, parts).value);
  CHECK(joined.regions.size() == 1);
  CHECK(joined.faces.size() < group.faces.size());
}

TEST_CASE("cells remember the leaves that they came from", "[cnrg]") {
  const Scene s({box({0, 0, 0}, {4, 4, 4}), box({4, 1, 1}, {6, 2, 2})});
  const auto leaves_of = [](const Components& x, FaceId f) {
    const auto set = x.origins.sets[x.origins.faces[place_in(x.selection.faces, f)]];
    return std::vector<LeafId>(set.begin(), set.end());
  };
  const Components wall = product(s.complex, s.one(0), s.one(1)).value;
  REQUIRE(wall.selection.faces.size() == 1);
  const FaceId f = wall.selection.faces[0].first;
  CHECK(leaves_of(wall, f) == std::vector<LeafId>{LeafId(0), LeafId(1)});
  CHECK(leaves_of(s.one(1), f) == std::vector<LeafId>{LeafId(1)});
  // What closure adds came from what it closes.
  const Components open = subtract(s.complex, s.one(0), s.one(1)).value;
  const Components shut = topological_operation(s.complex, Topological::closure, open).value;
  CHECK(leaves_of(shut, f) == std::vector<LeafId>{LeafId(0)});
  const auto cells = leaf_cells(s.complex, f, std::vector<LeafId>{LeafId(0), LeafId(1)});
  CHECK(std::count_if(cells.begin(), cells.end(), [](const LeafCell& c) { return c.dimension == 2; }) == 2);
}

}  // namespace cnrg
