// Where cells of results came from: the leaves and leaf cells that files name, after simplification.
#include <nlohmann/json.hpp>
#include <set>

#include "csg/operators/cnrg.h"
#include "csg/result/flat.h"
#include "tests/catch.h"
#include "tests/formats/cases.h"

using namespace cnrg;
using namespace cnrg::test;
using Json = nlohmann::json;

namespace {

using LeafFaces = std::set<std::pair<std::size_t, std::uint32_t>>;

LeafFaces faces_of(const FlatComplex::Provenance& origin) {
  LeafFaces result;
  for (const LeafCell& cell : origin.cells) {
    if (cell.dimension == 2) result.emplace(cell.leaf.index(), cell.number);
  }
  return result;
}

std::set<std::size_t> leaves_of(const FlatComplex::Provenance& origin) {
  std::set<std::size_t> result;
  for (const LeafId leaf : origin.leaves) result.insert(leaf.index());
  return result;
}

/// The face whose points have all this coordinate.
const FlatComplex::Face& face_at(const Case& c, const FlatComplex& flat, std::size_t axis, const Rational& at) {
  const FlatComplex::Face* found = nullptr;
  for (const auto& face : flat.faces) {
    const auto& loop = face.loops[0];
    if (!std::all_of(loop.begin(), loop.end(),
                     [&](auto p) { return c.complex->points.rational(flat.points[p])[axis] == at; })) {
      continue;
    }
    REQUIRE(found == nullptr);
    found = &face;
  }
  REQUIRE(found != nullptr);
  return *found;
}

Group boolean(const Case& c, BooleanOp op, const Group& a, const Group& b) {
  return boolean_operation(*c.complex, op, Dominance::equal, a, b).group;
}

}  // namespace

TEST_CASE("a face that a difference removed and another leaf brought back came from that leaf only") {
  // The face x = 4 of A lies inside of B but for its rim; C has a face on the same plane, inside of B.
  Soup soup;
  add_box(soup, {0, 0, 0}, {4, 4, 4});
  add_box(soup, {2, -1, -1}, {6, 5, 5});
  add_box(soup, {4, 1, 1}, {5, 3, 3});
  Case c(soup, {{{"a", "", {}}}, {{"b", "", {}}}, {{"c", "", {}}}});
  const Group cut = boolean(c, BooleanOp::subtract, c.leaves[0], c.leaves[1]);
  c.show(boolean(c, BooleanOp::unite, cut, c.leaves[2]));
  const FlatComplex flat = flatten(c.view());
  REQUIRE(flat.faces.size() == 12);
  CHECK(faces_of(face_at(c, flat, 0, 0).origin) == LeafFaces{{0, 0}});
  CHECK(faces_of(face_at(c, flat, 0, 2).origin) == LeafFaces{{1, 0}});  // B's face closes the cut
  CHECK(faces_of(face_at(c, flat, 0, 4).origin) == LeafFaces{{2, 0}});
  CHECK(leaves_of(face_at(c, flat, 0, 4).origin) == std::set<std::size_t>{2});
  for (const auto& region : flat.regions) {
    if (region.component == 0) {
      CHECK(region.origin.leaves.empty());
      continue;
    }
    const std::string& name = attributes_of(c.view(), region.component).name;
    const std::size_t leaf = name == "a" ? 0 : 2;
    CHECK(leaves_of(region.origin).contains(leaf));
    CHECK(leaves_of(region.origin).contains(2 - leaf) == false);
    CHECK(std::count(region.origin.cells.begin(), region.origin.cells.end(), LeafCell{LeafId(leaf), 3, 1}) == 1);
  }
}

TEST_CASE("pieces of one leaf face are one face again; coplanar faces of two leaves list both") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {2, 2, 2});
  add_box(soup, {1, -1, 0}, {4, 3, 2});  // shares the planes z = 0 and z = 2
  Case c(soup, {{{"a", "", {}}}, {{"b", "", {}}}});
  c.show(c.leaves[0]);  // cut by the second box
  FlatComplex flat = flatten(c.view());
  REQUIRE(flat.faces.size() == 6);
  CHECK(face_at(c, flat, 2, 2).triangles.size() == 2);
  CHECK(faces_of(face_at(c, flat, 2, 2).origin) == LeafFaces{{0, 5}});
  CHECK(leaves_of(face_at(c, flat, 2, 2).origin) == std::set<std::size_t>{0});

  c.show(c.unite(), SimplifyMode::points);
  flat = flatten(c.view());
  CHECK(faces_of(face_at(c, flat, 2, 2).origin) == LeafFaces{{0, 5}, {1, 5}});
  CHECK(faces_of(face_at(c, flat, 0, 0).origin) == LeafFaces{{0, 0}});
  CHECK_FALSE(face_at(c, flat, 2, 2).patch.has_value());
  for (const auto& edge : flat.edges) CHECK_FALSE(edge.origin.leaves.empty());
  for (const auto& vertex : flat.vertices) CHECK_FALSE(vertex.origin.leaves.empty());
}

TEST_CASE("wires, points, and cells of components name where they came from") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {4, 4, 4});
  add_wire(soup, {1, 1, 1}, {9, 1, 1});
  add_point(soup, {2, 2, 2});
  Case c(soup, {{{"a", "", {}}}});
  const Complex& complex = *c.complex;
  const Components a = components_of(complex, c.leaves[0]), wire = components_of(complex, c.leaves[1]);
  c.show(product(complex, a, wire).value);
  const FlatComplex both = flatten(c.view());
  const auto active = [](const auto& edge) { return edge.component != 0; };
  const auto inside = std::find_if(both.edges.begin(), both.edges.end(), active);
  REQUIRE(inside != both.edges.end());
  CHECK(inside->origin.cells == ShortList<LeafCell, 4>{{LeafId(0), 3, 1}, {LeafId(1), 1, 0}});

  c.show(sum(complex, sum(complex, a, wire).value, components_of(complex, c.leaves[2])).value);
  const ScratchFolder dir;
  write(dir / "m.json", c.view());
  const Json json = Json::parse(text_of(dir / "m.json"));
  std::size_t points = 0, wires = 0;
  for (const auto& vertex : json["vertices"]) {
    REQUIRE(vertex["origin"].size() >= 1);
    for (const auto& item : vertex["origin"]) {
      if (!item.contains("point")) continue;
      ++points;
      CHECK(item == Json{{"leaf", 2}, {"point", true}});
    }
  }
  for (const auto& edge : json["edges"]) {
    for (const auto& item : edge["origin"]) wires += item == Json{{"leaf", 1}, {"edges", {0}}};
  }
  CHECK(points == 1);
  CHECK(wires == 2);  // inside and outside of the box
  for (const auto& region : json["regions"]) CHECK(region.contains("origin") == (region["component"] != 0));

  // What no leaf holds still names the leaves.
  c.show(complement(complex, a).value);
  const FlatComplex outside = flatten(c.view());
  REQUIRE(outside.regions.size() == 2);
  for (const auto& region : outside.regions) {
    CHECK(leaves_of(region.origin).size() == (region.component == 0 ? 0 : 1));
  }
  for (const auto& face : outside.faces) CHECK(face.origin.leaves.empty());
}
