// Neighbourhoods of vertices: Euler's formula on the sphere over random scenes, nesting by hand.
#include "kernel/selection/neighbourhood.h"

#include <set>

#include "tests/catch.h"
#include "tests/operators/pieces.h"
#include "tests/scenes/scene.h"
#include "tests/scenes/seeds.h"

namespace cnrg {
namespace {

using namespace pieces;

VertexId vertex_at(const Complex& complex, const RationalPoint& p) {
  for (VertexId v : complex.vertices) {
    if (complex.points.rational(v) == p) return v;
  }
  FAIL("no vertex there");
  return {};
}

void check(const Complex& complex, const Neighbourhood& n) {
  CHECK(n.euler() == 1 + static_cast<long>(n.parts));
  // All regions, faces and edges of the star, each side of an arc on one circle, circles counted by germ.
  std::vector<RegionId> star;
  complex.star_regions(n.vertex, star);
  std::set<RegionId> regions;
  for (const auto& germ : n.germs) regions.insert(germ.region);
  CHECK(std::vector<RegionId>(regions.begin(), regions.end()) == star);
  std::vector<FaceId> faces;
  complex.star_faces(n.vertex, faces);
  std::set<FaceId> corners;
  for (const auto& arc : n.arcs) corners.insert(arc.face);
  CHECK(std::vector<FaceId>(corners.begin(), corners.end()) == faces);
  CHECK(n.nodes.size() == complex.vertex_edges[n.vertex].size());
  CHECK(n.sides.size() == 2 * n.arcs.size());
  std::vector<long> circles(n.germs.size(), 0);
  for (const auto& circle : n.circles) ++circles[circle.germ];
  for (std::size_t g = 0; g < n.germs.size(); ++g) CHECK(circles[g] == n.germs[g].circles);
  // A germ and a part meet in one circle at most: parts and germs form a tree.
  std::set<std::pair<std::uint32_t, std::uint32_t>> meetings;
  for (const auto& circle : n.circles) CHECK(meetings.emplace(circle.germ, circle.part).second);
  for (const auto& node : n.nodes) {
    for (const auto& dart : n.around(node)) {
      const FaceUse& after = complex.edge_uses.values()[dart.sector];
      CHECK(n.germs[dart.germ].region == complex.face_regions[after.face][after.half_edge.direction()]);
      CHECK(n.arcs[dart.arc].nodes[dart.end] == static_cast<std::uint32_t>(&node - n.nodes.data()));
    }
    if (node.count == 0) CHECK(n.germs[node.germ].region == complex.edge_region[node.edge.edge()]);
  }
}

TEST_CASE("neighbourhoods of random scenes are planar graphs on spheres", "[neighbourhood]") {
  const auto [begin, end] = scenes::seeds(60);
  std::size_t parted = 0;
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    for (const auto position :
         {scenes::Position::general, scenes::Position::degenerate, scenes::Position::tilted}) {
      const auto built_complex = build_complex(scenes::make_soup(scenes::random_leaves(seed, 4, position)));
      const Complex& complex = *built_complex;
      Neighbourhoods neighbourhoods(complex);
      CAPTURE(seed, static_cast<int>(position));
      for (VertexId v : complex.vertices) {
        const Neighbourhood n = neighbourhoods.at(v);
        parted += n.parts > 1;
        check(complex, n);
      }
    }
  }
  if (begin == 0 && end >= 60) CHECK(parted > 50);  // the scenes do ask for nesting
}

/// A square pyramid without its base, apex at the origin, opening upwards; faces outward or inward.
void add_cone(Soup& soup, int width, int height) {
  const LeafId leaf = soup.add_leaf(Fill::none);
  const PointId apex = soup.add_point(0, 0, 0);
  std::vector<PointId> rim;
  for (const auto& [x, y] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
    rim.push_back(soup.add_point(x * width, y * width, height));
  }
  for (std::uint32_t i = 0; i < 4; ++i) soup.add_triangle(leaf, apex, rim[i], rim[(i + 1) % 4], i, i);
}

void add_wire(Soup& soup, const Point& a, const Point& b) {
  const LeafId leaf = soup.add_leaf(Fill::none);
  soup.add_wire(leaf, soup.add_point(a[0], a[1], a[2]), soup.add_point(b[0], b[1], b[2]), 0);
}

const Neighbourhood::Node& node_towards(const Complex& complex, const Neighbourhood& n, const RationalPoint& p) {
  for (const auto& node : n.nodes) {
    if (complex.points.rational(complex.target(node.edge)) == p) return node;
  }
  FAIL("no edge to that point");
  return n.nodes[0];
}

TEST_CASE("parts of a neighbourhood are nested where one region lies on both sides", "[neighbourhood]") {
  // Two open cones, one within the other: one region; wires inside, between and outside, straight on and level.
  Soup soup;
  add_cone(soup, 4, 2);
  add_cone(soup, 1, 3);
  add_wire(soup, {0, 0, 0}, {0, 0, 4});
  add_wire(soup, {0, 0, 0}, {4, 0, 4});
  add_wire(soup, {0, 0, 0}, {-4, 0, 4});
  add_wire(soup, {0, 0, 0}, {0, 0, -4});
  add_wire(soup, {0, 0, 0}, {5, 5, 0});
  const auto built_complex = build_complex(soup);
  const Complex& complex = *built_complex;
  CHECK(complex.region_count == 1);
  Neighbourhoods neighbourhoods(complex);
  const Neighbourhood n = neighbourhoods.at(vertex_at(complex, {0, 0, 0}));
  check(complex, n);
  CHECK(n.parts == 7);
  REQUIRE(n.germs.size() == 3);
  const auto germ = [&](RationalPoint p) { return node_towards(complex, n, p).germ; };
  CHECK(germ({0, 0, -4}) == germ({5, 5, 0}));
  CHECK(germ({4, 0, 4}) == germ({-4, 0, 4}));
  CHECK(germ({0, 0, 4}) != germ({4, 0, 4}));
  CHECK(germ({0, 0, 4}) != germ({0, 0, -4}));
  CHECK(n.germs[germ({0, 0, 4})].circles == 2);
  CHECK(n.germs[germ({4, 0, 4})].circles == 4);
  CHECK(n.germs[germ({0, 0, -4})].circles == 3);
}

TEST_CASE("reflex corners, slit tips and full circles", "[neighbourhood]") {
  // A square with a quarter cut out at the origin, wires above, below, in the notch's plane and against it.
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  std::vector<std::vector<PointId>> loop(1);
  for (const auto& [x, y] : {std::pair{0, 0}, {0, 2}, {-2, 2}, {-2, -2}, {2, -2}, {2, 0}}) {
    loop[0].push_back(soup.add_point(x, y, 0));
  }
  soup.add_face(leaf, loop, 0, 0);
  add_wire(soup, {0, 0, 0}, {1, 1, 0});
  add_wire(soup, {0, 0, 0}, {0, 0, 1});
  add_wire(soup, {0, 0, 0}, {0, 0, -1});
  const auto built_complex = build_complex(soup);
  const Complex& complex = *built_complex;
  Neighbourhoods neighbourhoods(complex);
  const Neighbourhood n = neighbourhoods.at(vertex_at(complex, {0, 0, 0}));
  check(complex, n);
  CHECK(n.parts == 4);
  REQUIRE(n.germs.size() == 1);
  CHECK(n.germs[0].circles == 4);

  // A slit that ends within a rectangle, and a wire through another point of it.
  const auto built_plate = complex_of(
      {sheet({0, 0, 0}, {4, 4, 0}), wire({0, 2, 0}, {2, 2, 0}), wire({3, 3, -1}, {3, 3, 1}), point({1, 1, 0})});
  const Complex& plate = *built_plate;
  Neighbourhoods around(plate);
  const Neighbourhood tip = around.at(vertex_at(plate, {2, 2, 0}));
  check(plate, tip);
  REQUIRE(tip.arcs.size() == 1);
  CHECK(tip.arcs[0].nodes[0] == tip.arcs[0].nodes[1]);
  CHECK(!tip.arcs[0].full_circle());
  CHECK(tip.germs.size() == 2);
  const Neighbourhood pierced = around.at(vertex_at(plate, {3, 3, 0}));
  check(plate, pierced);
  CHECK(pierced.parts == 3);
  CHECK(pierced.germs.size() == 2);
  CHECK(pierced.germs[0].circles == 2);
  CHECK(pierced.nodes[0].germ != pierced.nodes[1].germ);
  const Neighbourhood lone = around.at(vertex_at(plate, {1, 1, 0}));
  check(plate, lone);
  CHECK(lone.germs.size() == 2);
  CHECK(lone.arcs[0].full_circle());
  // Triangles that stand on a face with one corner: a full circle and other arcs, whichever comes first.
  for (const bool face_first : {true, false}) {
    Soup standing;
    const LeafId none = standing.add_leaf(Fill::none);
    const auto add = [&](const std::vector<std::array<int, 3>>& corners, std::uint32_t face) {
      std::vector<std::vector<PointId>> loops(1);
      for (const auto& [x, y, z] : corners) loops[0].push_back(standing.add_point(x, y, z));
      standing.add_face(none, loops, face, face);
    };
    if (face_first) add({{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}}, 0);
    add({{0, 0, 0}, {1, 0, 1}, {0, 1, 1}}, 1);
    add({{0, 0, 0}, {0, 1, 1}, {-1, -1, 1}}, 2);
    if (!face_first) add({{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}}, 0);
    const auto built = build_complex(standing);
    Neighbourhoods both(*built);
    const Neighbourhood n = both.at(vertex_at(*built, {0, 0, 0}));
    check(*built, n);
    CHECK(n.arcs.size() == 3);
    CHECK(n.parts == 2);
  }
}

}  // namespace
}  // namespace cnrg
