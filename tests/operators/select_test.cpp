// Selections: small scenes counted by hand, and random ones against incidences read off the other way, from each
// 3-cell to its walls.
#include "csg/operators/select.h"

#include <map>
#include <random>
#include <set>

#include "csg/operators/boolean.h"
#include "csg/operators/cell_sources.h"
#include "csg/operators/identities.h"
#include "csg/operators/say.h"
#include "tests/catch.h"
#include "tests/operators/pieces.h"

namespace cnrg {
namespace {

using namespace pieces;
using Counts = std::array<std::size_t, 4>;

/// Vertices, edges, faces and regions as the complex has them.
Counts sizes(const Group& g) { return {g.vertices.size(), g.edges.size(), g.faces.size(), g.regions.size()}; }

/// Leaf i has the i-th name and material; both are said of its sheets, wires and points, too.
std::vector<Group> named(const Complex& complex, const std::vector<Attributes>& said) {
  std::vector<std::vector<Attributes>> of_regions;
  for (const Attributes& a : said) of_regions.push_back({a, a});
  std::vector<Group> leaves = leaf_groups(complex, of_regions);
  for (std::size_t i = 0; i < leaves.size(); ++i) say(complex, said[i], Saying::replaces, leaves[i]);
  return leaves;
}

Group united(const Complex& complex, const std::vector<Group>& leaves) {
  Group all = leaves[0];
  for (std::size_t i = 1; i < leaves.size(); ++i) {
    all = boolean_operation(complex, BooleanOp::unite, Dominance::right, all, leaves[i]).group;
  }
  return all;
}

Attributes said(const char* name, const char* material, Properties properties = {}) {
  return {name, material, std::move(properties)};
}

/// Two boxes with a wall in common, a sheet in the first one, and a wire outside that touches nothing.
struct SelectScene {
  std::shared_ptr<const Complex> built = complex_of({box({0, 0, 0}, {4, 4, 4}), box({4, 0, 0}, {8, 4, 4}),
                                                     sheet({1, 1, 2}, {3, 3, 2}), wire({10, 0, 0}, {12, 0, 0})});
  const Complex& complex = *built;
  Group all = united(complex, named(complex, {said("west", "rock"), said("east", "clay"),
                                              said("fault", "gouge", {{"aperture", Rational(2)}}),
                                              said("bolt", "steel", {{"section", std::string("round")}})}));
  Counts pick(const Criteria& criteria) const {
    const Group picked = select(complex, all, criteria);
    CHECK(check_group(complex, picked) == "");
    return sizes(picked);
  }
};

Criteria of_dimension(std::vector<int> dimensions) {
  Criteria c;
  c.dimensions = std::move(dimensions);
  return c;
}

TEST_CASE("names, materials and attributes pick what they are said of", "[select]") {
  const SelectScene s;
  Criteria c;
  c.materials = {"clay"};
  CHECK(s.pick(c) == Counts{8, 12, 6, 1});
  c.materials = {"gouge", "steel"};
  CHECK(s.pick(c) == Counts{4 + 2, 4 + 1, 1, 0});
  c.dimensions = {1};  // the sheet speaks by its face, not by its edges
  CHECK(s.pick(c) == Counts{2, 1, 0, 0});
  Criteria named_west;
  named_west.names = {"west"};
  CHECK(s.pick(named_west) == Counts{8 + 4, 12 + 4, 6 + 1, 1});  // the fault lies in it
  Criteria property;
  property.properties = {{"aperture", Rational(2)}};
  CHECK(s.pick(property) == Counts{4, 4, 1, 0});
  property.properties.emplace_back("aperture", Rational(3));  // or
  CHECK(s.pick(property) == Counts{4, 4, 1, 0});
  property.properties.emplace_back("section", std::string("round"));  // and
  CHECK(s.pick(property) == Counts{0, 0, 0, 0});
}

TEST_CASE("cells are picked by faces of leaves, and regions by number", "[select]") {
  const SelectScene s;
  // Face 5 of a box is its last one, x = 8 of the eastern; 4 is x = 4, the wall.
  Criteria c = of_dimension({2});
  c.leaves = {LeafId(1)};
  std::size_t faces = 0;
  for (std::uint32_t face = 0; face < 6; ++face) {
    c.source_faces = {face};
    CHECK(s.pick(c) == Counts{4, 4, 1, 0});
    c.source_faces.push_back(face == 0 ? 1 : 0);
    faces += s.pick(c)[2];
  }
  CHECK(faces == 12);
  Criteria edges = of_dimension({1});
  edges.leaves = {LeafId(1)};
  edges.source_faces = {0};  // its border
  CHECK(s.pick(edges) == Counts{4, 4, 0, 0});
  Criteria number = of_dimension({3});
  number.region_numbers = {2};
  CHECK(s.pick(number) == Counts{8, 12, 6, 1});
  number.region_numbers = {3};
  CHECK(s.pick(number) == Counts{0, 0, 0, 0});
}

TEST_CASE("of components single cells are picked, which keep their component", "[select]") {
  const SelectScene s;
  const Components all = components_of(s.complex, s.all);  // west, east, entities
  REQUIRE(all.attributes.size() == 3);
  Criteria c = of_dimension({3});
  c.regions = {"east"};
  const Components east = select(s.complex, all, c);
  REQUIRE(east.attributes.size() == 1);
  CHECK(east.attributes[0].name == "east");
  CHECK(support(east.selection) == support(all.selection, 2));
  Criteria steel;
  steel.materials = {"steel"};
  const Components bolt = select(s.complex, all, steel);
  CHECK(bolt.selection.edges.size() == 1);
  CHECK(support(bolt.selection).size() == 1);  // without its ends
  CHECK(bolt.attributes.size() == 1);
  CHECK(bolt.attributes[0].name.is_of_entities());
  CHECK(select(s.complex, all, {}).selection == all.selection);
}

/// Cells by dimension and id.
using Cells = std::set<std::pair<int, std::size_t>>;

/// The cells in the closure of an edge, of a face.
void add_closure(const Complex& complex, EdgeId e, Cells& out) {
  out.emplace(1, e.index());
  for (const VertexId v : complex.edge_ends[e]) out.emplace(0, v.index());
}
void add_closure(const Complex& complex, FaceId f, Cells& out) {
  std::vector<EdgeId> edges;
  complex.closure_edges(f, edges);
  out.emplace(2, f.index());
  for (const EdgeId e : edges) add_closure(complex, e, out);
  for (const VertexId v : complex.face_vertices[f]) out.emplace(0, v.index());
}

TEST_CASE("selections in random scenes are what brute force picks", "[select][random]") {
  std::mt19937 random(7);
  const auto number = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
  std::size_t picked_cells = 0;
  for (int scene = 0; scene < 40; ++scene) {
    std::vector<Piece> pieces;
    std::vector<Attributes> said_of;
    const char* const materials[] = {"rock", "clay", "steel"};
    for (int i = 0; i < 4; ++i) {
      const Point low{number(4), number(4), number(4)};
      const Point high{low[0] + 1 + number(3), low[1] + 1 + number(3), low[2] + 1 + number(3)};
      const int kind = i == 0 ? 0 : number(3);
      pieces.push_back(kind == 0   ? box(low, high)
                       : kind == 1 ? sheet(low, {high[0], high[1], low[2]})
                                   : wire(low, {high[0], low[1], low[2]}));
      said_of.push_back(said(("n" + std::to_string(i)).c_str(), materials[number(3)]));
    }
    const auto built = complex_of(pieces);
    const Complex& complex = *built;
    const Group all = united(complex, named(complex, said_of));
    std::vector<CellSet> sets;  // point sets to be inside of, or to touch
    for (const Group& leaf : leaf_groups(complex)) sets.push_back(support(selection_of(complex, leaf)));
    sets.push_back(interior(complex, sets[0]));
    const GroupSources sources(complex, all);
    const SimplifiedComplex simplified =
        simplify(complex, selection_of(complex, all), all.features, SimplifyMode::features, &sources);
    // From each 3-cell to all in its closure.
    std::map<std::pair<int, std::size_t>, std::set<std::uint32_t>> around;
    std::vector<Cells> closure(all.regions.size() + 1);
    for (const RegionId r : IdRange<RegionId>(complex.region_count)) {
      Cells cells;
      for (const HalfFace h : complex.region_faces[r]) add_closure(complex, h.face(), cells);
      for (const EdgeId e : complex.region_wires[r]) add_closure(complex, e, cells);
      for (const VertexId v : complex.region_vertices[r]) cells.emplace(0, v.index());
      for (const auto& cell : cells) around[cell].insert(all.region_of(r));
      closure[all.region_of(r)].insert(cells.begin(), cells.end());
    }
    for (int trial = 0; trial < 20; ++trial) {
      Criteria c;
      for (int d = 0; d < 4; ++d) {
        if (number(2)) c.dimensions.push_back(d);
      }
      const std::string near = "n" + std::to_string(number(4));
      const LeafId leaf(static_cast<std::size_t>(number(4)));
      const std::string material = materials[number(3)];
      const int asked = number(4);
      if (asked & 1) c.regions = {near};
      if (asked & 2) c.leaves = {leaf};
      const int between = number(3);  // 0 nothing, 1 outside, 2 a material
      const std::string other = materials[number(3)];
      if (between == 1) c.between = {{material, std::nullopt}};
      if (between == 2) c.between = {{material, other}};
      const int place = number(3);  // 0 nothing, 1 inside, 2 touching
      const CellSet& set = sets[static_cast<std::size_t>(number(static_cast<int>(sets.size())))];
      if (place == 1) c.inside = set;
      if (place == 2) c.touching = set;
      const auto in_set = [&](int d, std::size_t id) {
        const auto in = [&](const auto& list) {
          return std::any_of(list.begin(), list.end(), [&](auto cell) { return cell.index() == id; });
        };
        return d == 3 ? in(set.regions) : d == 2 ? in(set.faces) : d == 1 ? in(set.edges) : in(set.vertices);
      };
      const auto is_in_place = [&](int d, std::size_t id, const Cells& closed) {
        if (place == 0) return true;
        if (place == 1 || in_set(d, id)) return in_set(d, id);
        return std::any_of(closed.begin(), closed.end(),
                           [&](auto& cell) { return in_set(cell.first, cell.second); });
      };

      const auto wants = [&](int d) {
        return c.dimensions.empty() || std::count(c.dimensions.begin(), c.dimensions.end(), d) != 0;
      };
      const auto holds = [&](int d, std::size_t id, std::span<const LeafId> leaves) {
        const std::set<std::uint32_t>& regions = around[{d, id}];
        bool is_near = false, parts = false;
        for (const std::uint32_t a : regions) {
          if (a == 0) continue;
          const RegionAttributes& of_a = all.regions[a - 1];
          is_near |= of_a.name == near;
          if (of_a.material.name() != material) continue;
          for (const std::uint32_t b : regions) {
            if (between == 1) parts |= b == 0;
            else parts |= b != 0 && b != a && all.regions[b - 1].material.name() == other;
          }
        }
        return wants(d) && (!(asked & 1) || is_near) && (between == 0 || parts) &&
               (!(asked & 2) || std::count(leaves.begin(), leaves.end(), leaf) != 0);
      };
      // Cells that are one after simplification are picked as one.
      struct Seen {
        Cells closure;
        bool asked = false, all_in_place = true, one_in_place = false;
      };
      std::map<std::pair<int, std::uint32_t>, Seen> seen;
      const auto see = [&](int d, std::size_t id, const SimplifiedComplex::Place& at, const Cells& closed,
                           std::span<const LeafId> leaves) {
        Seen& one = seen[{at.dimension, at.index}];
        one.closure.insert(closed.begin(), closed.end());
        one.asked |= at.dimension == d && holds(d, id, leaves);
        one.all_in_place &= is_in_place(d, id, closed);
        one.one_in_place |= is_in_place(d, id, closed);
      };
      const Origins& o = all.origins;
      for (std::size_t k = 0; k < all.faces.size(); ++k) {
        Cells closed;
        add_closure(complex, all.faces[k], closed);
        const std::size_t id = all.faces[k].index();
        see(2, id, simplified.face_place[id], closed, o.sets[o.faces[k]]);
      }
      for (std::size_t k = 0; k < all.edges.size(); ++k) {
        Cells closed;
        add_closure(complex, all.edges[k], closed);
        const std::size_t id = all.edges[k].index();
        see(1, id, simplified.edge_place[id], closed, o.sets[o.edges[k]]);
      }
      for (std::size_t k = 0; k < all.vertices.size(); ++k) {
        const std::size_t id = all.vertices[k].index();
        see(0, id, simplified.vertex_place[id], {{0, id}}, o.sets[o.vertices[k]]);
      }
      Cells expected;
      for (const auto& [at, one] : seen) {
        if (one.asked && (place == 2 ? one.one_in_place : one.all_in_place))
          expected.insert(one.closure.begin(), one.closure.end());
      }
      std::vector<std::string> regions;
      for (std::size_t r = 1; r <= all.regions.size(); ++r) {
        const RegionAttributes& of = all.regions[r - 1];
        if (!wants(3) || between != 0 || ((asked & 1) && of.name != near)) continue;
        if ((asked & 2) && std::count(of.leaves.begin(), of.leaves.end(), leaf) == 0) continue;
        bool all_in = true, touched = is_in_place(0, std::size_t(-1), closure[r]);
        for (const auto& [cell, region] : all.cells) {
          if (region != r) continue;
          all_in = all_in && in_set(3, cell.index());
          touched = touched || in_set(3, cell.index());
        }
        if ((place == 1 && !all_in) || (place == 2 && !touched)) continue;
        regions.push_back(of.name);
        expected.insert(closure[r].begin(), closure[r].end());
      }
      Cells entities;  // cells inside of regions are in closures, but no entities
      for (const FaceId f : all.faces) entities.emplace(2, f.index());
      for (const EdgeId e : all.edges) entities.emplace(1, e.index());
      for (const VertexId v : all.vertices) entities.emplace(0, v.index());
      Cells wanted;
      std::set_intersection(expected.begin(), expected.end(), entities.begin(), entities.end(),
                            std::inserter(wanted, wanted.end()));

      const Group picked = select(complex, all, c);
      REQUIRE(check_group(complex, picked) == "");
      Cells found;
      for (const FaceId f : picked.faces) found.emplace(2, f.index());
      for (const EdgeId e : picked.edges) found.emplace(1, e.index());
      for (const VertexId v : picked.vertices) found.emplace(0, v.index());
      REQUIRE(found == wanted);
      REQUIRE(picked.regions.size() == regions.size());
      for (std::size_t r = 0; r < regions.size(); ++r) CHECK(picked.regions[r].name == regions[r]);
      picked_cells += found.size();
    }
  }
  CHECK(picked_cells > 1000);
}

}  // namespace
}  // namespace cnrg
