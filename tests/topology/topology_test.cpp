// Topology in words: Euler-Poincare on simplified cells of random selections, known texts, adjacency of regions.
#include "csg/topology/topology.h"

#include <regex>

#include "csg/topology/region_graph.h"
#include "tests/catch.h"
#include "tests/formats/cases.h"
#include "tests/scenes/scene.h"
#include "tests/scenes/seeds.h"

using namespace cnrg;
using cnrg::test::Case;

namespace {

std::string text_of_case(const Case& c) {
  std::vector<RegionAttributes> components = c.group.regions;
  components.push_back({{.name = "entities"}, {}});
  return topology_text(*c.complex, selection_of(*c.complex, c.group), c.simplified, components);
}
bool says(const std::string& text, const std::string& words) {
  const bool found = text.find(words) != std::string::npos;
  if (!found) UNSCOPED_INFO(text << "\ndoes not say\n" << words);
  return found;
}

TEST_CASE("Euler-Poincare holds on the simplified cells of random selections", "[topology]") {
  const auto [begin, end] = scenes::seeds(40);
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    for (const auto position :
         {scenes::Position::general, scenes::Position::degenerate, scenes::Position::tilted}) {
      const auto built_complex = build_complex(scenes::make_soup(scenes::random_leaves(seed, 3, position)));
      const Complex& complex = *built_complex;
      scenes::Random random(seed);
      // Components by what holds the cell, so that there is something to merge; some cells at random.
      const auto component = [&](const std::vector<RegionId>& star) -> Component {
        if (random.one_in(12)) return static_cast<Component>(random.below(3));
        const std::size_t labels = complex.labels(star.front()).size();
        for (RegionId r : star) {
          if (r == RegionId(0) || complex.labels(r).size() != labels) return random.one_in(2) ? 3 : 0;
        }
        return static_cast<Component>(labels % 3);
      };
      Selection selection;
      const auto add = [&](auto& list, auto cell, const std::vector<RegionId>& star) {
        if (const Component c = component(star); c != 0) list.emplace_back(cell, c);
      };
      std::vector<RegionId> star;
      for (VertexId v : complex.vertices) complex.star_regions(v, star), add(selection.vertices, v, star);
      for (EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
        complex.star_regions(e, star), add(selection.edges, e, star);
      }
      for (FaceId f : IdRange<FaceId>(complex.face_count())) {
        add(selection.faces, f, {complex.face_regions[f][0], complex.face_regions[f][1]});
      }
      for (RegionId r : IdRange<RegionId>(complex.region_count)) {
        if (r != RegionId(0)) add(selection.regions, r, {r});
      }
      for (const SimplifyMode mode : {SimplifyMode::features, SimplifyMode::points, SimplifyMode::raw}) {
        CAPTURE(seed, static_cast<int>(position), static_cast<int>(mode));
        const SimplifiedComplex simplified = simplify(complex, selection, {}, mode);
        const SimplifiedEuler t = simplified_euler(complex, selection, simplified);
        REQUIRE(t.left() == t.right());
        REQUIRE(!topology_text(complex, selection, simplified, {}).empty());
      }
    }
  }
}

TEST_CASE("topology of a box with a core and a sheet", "[topology]") {
  Soup soup;
  test::add_box(soup, {0, 0, 0}, {6, 6, 6});
  test::add_box(soup, {2, 2, 2}, {4, 4, 4});
  test::add_sheet(soup, {{6, 1, 1}, {8, 1, 1}, {8, 4, 1}, {6, 4, 1}});
  test::add_wire(soup, {0, 0, 0}, {-1, 0, 0});
  Case c(soup, {{{"rock", "granite", {}}}, {{"core", "", {}}}, {}, {}});
  c.show(c.unite(Dominance::right));
  const std::string text = text_of_case(c);
  CHECK(says(text, "v - e + (f - r) - (V - Vh + Vc) = C - Ch + Cc\n"));
  CHECK(says(text, "  21 - 29 + (13 - 1) - (2 - 0 + 1) = 1 - 0 + 0   (1 = 1)\n"));
  CHECK(says(text, "  point set          1        0        0      1      0      0\n"));
  CHECK(says(text, "  1 rock             1        0        1      1      0      1\n"));
  CHECK(says(text, "  2 core             1        0        0      1      0      0\n"));
  CHECK(says(text, "  a sheet hangs on the solid: e"));
  CHECK(says(text, "  a wire and a solid cone meet in a point: v"));
  CHECK(says(text, "  wire end               1      0\n"));
  CHECK(says(text, "sheets without solid: 1, closed 0, one-sided (not orientable) 0\n"));
  CHECK(says(text, "  outside - 1 rock: 6 faces\n  1 rock - 2 core: 6 faces\n"));
}

// The two boxes meet in one edge with four faces around it, and in its two ends.
TEST_CASE("around the edge that two boxes share: radial order, neighbourhoods, shells", "[topology]") {
  Soup soup;
  test::add_box(soup, {0, 0, 0}, {1, 1, 1});
  test::add_box(soup, {1, 1, 0}, {2, 2, 1});
  Case c(soup, {{{"left", "", {}}}, {{"right", "", {}}}});
  c.show(c.unite());
  const std::string text = text_of_case(c);
  CHECK(says(text, "4 boundary faces meet: 2 solid sectors: e"));
  const std::size_t at = text.find("radial order (faces and regions about the edge)\n  e");
  REQUIRE(at != std::string::npos);
  const std::string line = text.substr(text.find('\n', at) + 1, 80);
  const std::regex turn(
      "  e\\d+: f\\d+, (1 left|2 right|outside), f\\d+, (1 left|2 right|outside), "
      "f\\d+, (1 left|2 right|outside), f\\d+, (1 left|2 right|outside)\n[\\s\\S]*");
  std::smatch match;
  REQUIRE(std::regex_match(line, match, turn));
  // Solid and outside take turns, and both solids are met.
  std::vector<std::string> wedges{match[1], match[2], match[3], match[4]};
  if (wedges[0] != "outside") std::rotate(wedges.begin(), wedges.begin() + 1, wedges.end());
  if (wedges[1] != "1 left") std::rotate(wedges.begin(), wedges.begin() + 2, wedges.end());
  CHECK(wedges == std::vector<std::string>{"outside", "1 left", "outside", "2 right"});
  CHECK(
      says(text, ": 5 nodes (edges), 6 arcs (corners of faces), 3 faces (pieces of regions), 1 connected part\n"));
  CHECK(says(text, " (1 left): 1 shell of 6 sides of faces\n"));
  CHECK(says(text, " (2 right): 1 shell of 6 sides of faces\n"));
}

TEST_CASE("topology of a curved patch, an open set, an unbounded one, and none", "[topology]") {
  Soup soup;
  test::add_drum(soup, 12, 0, 5);
  Case drum(soup);
  const Selection value = selection_of(*drum.complex, drum.group);
  const SimplifiedEuler t = simplified_euler(*drum.complex, value, drum.simplified);
  CHECK(t.v == 0);
  CHECK(t.e == 2);
  CHECK(t.edge_loops == 2);
  CHECK(t.f == 3);
  CHECK(t.r == 1);
  CHECK(t.left() == 1);
  CHECK(says(text_of_case(drum), "  0 - (2 - 2) + (3 - 1 + 0) - (1 - 0 + 0) = 1 - 0 + 0   (1 = 1)\n"));

  Selection open;
  for (RegionId r : IdRange<RegionId>(drum.complex->region_count)) {
    if (r != RegionId(0)) open.regions.emplace_back(r, 1u);
  }
  const auto simplified = simplify(*drum.complex, open, {});
  CHECK(says(topology_text(*drum.complex, open, simplified, {}), "of the closure"));
  CHECK(says(topology_text(*drum.complex, open, simplified, {}), "  component 1"));
  Selection outside;
  outside.regions.emplace_back(RegionId(0), 1u);
  CHECK(says(topology_text(*drum.complex, outside, simplify(*drum.complex, outside, {}), {}), "is unbounded"));
  CHECK(topology_text(*drum.complex, {}, simplify(*drum.complex, Selection(), {}), {}) ==
        "the point set is empty\n");
}

// The half-open boxes of the lesson on open sets: of 12 corners and 20 edges 4 and 4 bound the wall that is cut
// out.
TEST_CASE("local shapes count cells of the set; what it misses is a row of its own", "[topology]") {
  Soup soup;
  test::add_box(soup, {0, 0, 0}, {1, 2, 2});
  test::add_box(soup, {1, 0, 0}, {2, 2, 2});
  Case c(soup);
  Selection cut;
  const Complex& complex = *c.complex;
  const auto wall = [&](VertexId v) { return complex.points.rational(v)[0] == 1; };
  for (const VertexId v : IdRange<VertexId>(complex.points.size())) {
    if (!wall(v)) cut.vertices.emplace_back(v, 1u);
  }
  for (const EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
    const HalfEdge h(e, 0);
    if (!wall(complex.origin(h)) || !wall(complex.target(h))) cut.edges.emplace_back(e, 1u);
  }
  for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
    const auto sides = complex.face_regions[f];
    if (sides[0] == RegionId(0) || sides[1] == RegionId(0)) cut.faces.emplace_back(f, 1u);
  }
  for (const RegionId r : IdRange<RegionId>(complex.region_count)) {
    if (r != RegionId(0)) cut.regions.emplace_back(r, 1u);
  }
  const auto simplified = simplify(complex, cut, {});
  CHECK(says(topology_text(complex, cut, simplified, {}),
             "local shape  vertices  edges\n  manifold          8     16\n  missing           4      4\n"));
}

TEST_CASE("adjacency of regions as a graph", "[topology]") {
  Soup soup;
  test::add_box(soup, {0, 0, 0}, {2, 2, 2});
  test::add_box(soup, {2, 0, 0}, {4, 2, 2});
  test::add_box(soup, {7, 0, 0}, {8, 1, 1});
  Case c(soup, {{{"left", "rock", {}}}, {{"say \"right\"", "", {}}}, {{"", "", {}}}});
  c.show(c.unite(Dominance::left));
  const RegionGraph graph = region_graph(c.simplified, c.group.regions);
  REQUIRE(graph.nodes.size() == 4);
  CHECK(graph.nodes[0].name == "outside");
  CHECK(graph.nodes[1].name == "1 left");
  CHECK(graph.nodes[3].name == "component 3");
  CHECK(graph.edges == std::vector<RegionGraph::Edge>{{{0, 1}, 5}, {{0, 2}, 5}, {{0, 3}, 6}, {{1, 2}, 1}});
  CHECK(graph.parts(false) == std::vector<std::uint32_t>{0, 0, 0, 0});
  CHECK(graph.parts(true) == std::vector<std::uint32_t>{0, 1, 1, 2});
  CHECK(graph.dot() ==
        "graph G {\n"
        "graph [layout=neato, overlap=false]\n"
        "node [shape=box]\n"
        "0[label=\"outside\", style=dashed];\n"
        "1[label=\"1 left\\nrock\"];\n"
        "2[label=\"2 say \\\"right\\\"\"];\n"
        "3[label=\"component 3\"];\n"
        "0--1 [label=\"5 faces\"];\n"
        "0--2 [label=\"5 faces\"];\n"
        "0--3 [label=\"6 faces\"];\n"
        "1--2 [label=\"1 face\"];\n"
        "}\n");
}

}  // namespace
