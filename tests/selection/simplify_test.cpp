// Simplification where grids do not reach: curved patches, curves, tips, slits, punctures.
#include "kernel/selection/simplify.h"

#include <cmath>

#include "tests/catch.h"
#include "tests/operators/pieces.h"

namespace cnrg {
namespace {

using namespace pieces;
using Counts = std::array<std::size_t, 4>;

std::shared_ptr<const Complex> built(const Soup& soup) {
  RefineOptions options;
  options.threads = 1;
  const auto complex = build_complex(soup, options);
  REQUIRE(validate(*complex) == "");
  return complex;
}

// All cells but the unbounded region as one component, or lower cells as a second one.
Selection everything(const Complex& complex, Component lower = 1) {
  Selection s;
  for (VertexId v : complex.vertices) s.vertices.emplace_back(v, lower);
  for (EdgeId e : IdRange<EdgeId>(complex.edge_count())) s.edges.emplace_back(e, lower);
  for (FaceId f : IdRange<FaceId>(complex.face_count())) s.faces.emplace_back(f, lower);
  for (std::size_t r = 1; r < complex.region_count; ++r) s.regions.emplace_back(RegionId(r), 1);
  return s;
}

// A prism over a regular polygon with n corners on a circle (up to doubles), its side one patch.
Soup prism(int n, bool caps) {
  Soup soup;
  const LeafId leaf = soup.add_leaf(caps ? Fill::winding : Fill::none);
  std::vector<PointId> low, high;
  for (int i = 0; i < n; ++i) {
    const double x = std::cos(2 * M_PI * i / n), y = std::sin(2 * M_PI * i / n);
    low.push_back(soup.add_point(x, y, 0));
    high.push_back(soup.add_point(x, y, 1));
  }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    const std::vector<std::vector<PointId>> loops{{low[i], low[j], high[j], high[i]}};
    soup.add_face(leaf, loops, 0, 0);
  }
  if (caps) {
    const std::vector<std::vector<PointId>> top{high}, bottom{{low.rbegin(), low.rend()}};
    soup.add_face(leaf, top, 1, 1);
    soup.add_face(leaf, bottom, 2, 2);
  }
  return soup;
}

TEST_CASE("the side of a cylinder is one face, its rims are closed curves", "[simplify]") {
  const auto built_complex = built(prism(7, true));
  const Complex& complex = *built_complex;
  const auto s = simplify(complex, everything(complex, 2), {});
  CHECK(active_counts(s) == Counts{0, 2, 3, 1});
  for (const auto& edge : s.edges) {
    CHECK(edge.closed);
    CHECK(edge.chain.size() == 7);
  }
  for (const auto& face : s.faces) CHECK(face.loops.size() == (face.cells.size() == 7 ? 2u : 1u));
  REQUIRE(s.regions.size() == 2);
  CHECK(s.regions[0].shells.size() == 1);
  CHECK(s.regions[1].shells.size() == 1);
  CHECK(!s.regions[0].bounded);
  for (const SimplifyMode mode : {SimplifyMode::points, SimplifyMode::raw}) {
    CHECK(active_counts(simplify(complex, everything(complex, 2), {}, mode)) == Counts{14, 21, 9, 1});
  }
}

TEST_CASE("an open tube: both rims are borders of one patch", "[simplify]") {
  for (const int sides : {3, 4, 9}) {
    const auto built_complex = built(prism(sides, false));
    const Complex& complex = *built_complex;
    CHECK(active_counts(simplify(complex, everything(complex), {})) == Counts{0, 2, 1, 0});
  }
}

TEST_CASE("features stay where they are named", "[simplify]") {
  const auto built_complex = built(prism(7, true));
  const Complex& complex = *built_complex;
  Features features;
  features.edges = {EdgeId(0)};
  for (EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
    const auto uses = complex.edge_uses[e];
    if (complex.sources[complex.cover(uses[0].face)[0].source].patch == 0 &&
        complex.sources[complex.cover(uses[1].face)[0].source].patch == 0) {
      features.edges = {e};
    }
  }
  // One seam: it ends on both rims and cuts the side open.
  CHECK(active_counts(simplify(complex, everything(complex, 2), features)) == Counts{2, 3, 3, 1});
  features.vertices = {complex.vertices[0]};
  features.edges.clear();
  CHECK(active_counts(simplify(complex, everything(complex, 2), features)) == Counts{1, 2, 3, 1});
}

// Two tetrahedra without bottoms, tip to tip; the sides of each are one patch.
TEST_CASE("a vertex where two faces only touch stays", "[simplify]") {
  Soup soup;
  const PointId tip = soup.add_point(0, 0, 0);
  for (int side : {-1, 1}) {
    const LeafId leaf = soup.add_leaf(Fill::none);
    const PointId p[3] = {soup.add_point(4, 0, 4 * side), soup.add_point(-4, 3, 4 * side),
                          soup.add_point(-4, -3, 4 * side)};
    for (int i = 0; i < 3; ++i) soup.add_triangle(leaf, tip, p[i], p[(i + 1) % 3], 0, 0);
  }
  const auto built_complex = built(soup);
  const Complex& complex = *built_complex;
  const auto s = simplify(complex, everything(complex), {});
  CHECK(s.vertices.size() >= 1);
  CHECK(s.faces.size() == 2);
  std::size_t isolated = 0;
  for (const auto& face : s.faces) isolated += face.isolated.size();
  CHECK(isolated == 2);
}

TEST_CASE("a patch that cannot be oriented keeps one seam", "[simplify]") {
  // A Moebius strip of 5 quadrilaterals, split into triangles; the last rung is joined the other way round.
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  const int n = 5;
  std::vector<std::array<PointId, 2>> rung;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * M_PI * i / n;
    std::array<PointId, 2> ends;
    for (int k = 0; k < 2; ++k) {
      const double w = k ? 1 : -1;
      ends[k] = soup.add_point((4 + w * std::cos(t / 2)) * std::cos(t), (4 + w * std::cos(t / 2)) * std::sin(t),
                               w * std::sin(t / 2));
    }
    rung.push_back(ends);
  }
  for (int i = 0; i < n; ++i) {
    const auto a = rung[i];
    auto b = rung[(i + 1) % n];
    if (i == n - 1) std::swap(b[0], b[1]);
    soup.add_triangle(leaf, a[0], a[1], b[0], 0, 0);
    soup.add_triangle(leaf, a[1], b[1], b[0], 0, 0);
  }
  const auto built_complex = built(soup);
  const Complex& complex = *built_complex;
  const auto s = simplify(complex, everything(complex), {});
  CHECK(s.faces.size() == 1);
  std::size_t kept = 0;
  for (const auto& edge : s.edges) {
    kept += edge.chain.size() == 1 && complex.edge_uses[edge.chain[0].edge()].size() == 2;
  }
  CHECK(kept == 1);
}

TEST_CASE("wires: straight pieces are one edge, pieces of one curve too", "[simplify]") {
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  std::vector<PointId> p;
  for (int i = 0; i < 6; ++i) p.push_back(soup.add_point(std::cos(i), std::sin(i), i));
  for (int i = 0; i < 5; ++i) soup.add_wire(leaf, p[i], p[i + 1], 0);
  const PointId q[4] = {soup.add_point(5, 0, 0), soup.add_point(6, 0, 0), soup.add_point(7, 0, 0),
                        soup.add_point(7, 1, 0)};
  for (int i = 0; i < 3; ++i) soup.add_wire(leaf, q[i], q[i + 1], static_cast<std::uint32_t>(i + 1));
  const auto built_complex = built(soup);
  const Complex& complex = *built_complex;
  CHECK(active_counts(simplify(complex, everything(complex), {})) == Counts{5, 3, 0, 0});
  CHECK(active_counts(simplify(complex, everything(complex), {}, SimplifyMode::points)) == Counts{9, 7, 0, 0});
}

TEST_CASE("a closed curve and the region around it are listed without a vertex", "[simplify]") {
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  std::vector<PointId> p;
  for (int i = 0; i < 7; ++i)
    p.push_back(soup.add_point(std::cos(2 * M_PI * i / 7), std::sin(2 * M_PI * i / 7), 0));
  for (int i = 0; i < 7; ++i) soup.add_wire(leaf, p[i], p[(i + 1) % 7], 0);
  const auto built_complex = built(soup);
  const Complex& complex = *built_complex;
  const auto s = simplify(complex, everything(complex), {});
  CHECK(active_counts(s) == Counts{0, 1, 0, 0});
  CHECK(s.vertices.empty());
  REQUIRE(s.regions.size() == 1);
  CHECK(s.regions[0].cells == std::vector<RegionId>{RegionId(0)});
  Location outside;
  outside.region = RegionId(0);
  CHECK(s.place(complex, outside).index == 0);
}

TEST_CASE("a closed surface of one patch is a face without a border between two regions", "[simplify]") {
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  const PointId p[4] = {soup.add_point(0, 0, 0), soup.add_point(1, 0, 0), soup.add_point(0, 1, 0),
                        soup.add_point(0, 0, 1)};
  for (int i = 0; i < 4; ++i) soup.add_triangle(leaf, p[i], p[(i + 1) % 4], p[(i + 2) % 4], 0, 0);
  const auto built_complex = built(soup);
  const Complex& complex = *built_complex;
  Selection surface = everything(complex);
  surface.regions.clear();
  const auto s = simplify(complex, surface, {});
  CHECK(active_counts(s) == Counts{0, 0, 1, 0});
  REQUIRE(s.faces.size() == 1);
  CHECK(s.faces[0].loops.size() == 0);
  REQUIRE(s.regions.size() == 2);
  CHECK(s.faces[0].regions[0] + s.faces[0].regions[1] == 1);
  for (const auto& region : s.regions) CHECK(region.shells.size() == 1);
}

TEST_CASE("what is not listed is of no component", "[simplify]") {
  const auto built_complex = complex_of({box({0, 0, 0}, {4, 4, 4})});
  const Complex& complex = *built_complex;
  const auto nothing = simplify(complex, {}, {});
  CHECK(nothing.regions.empty());
  Location inside;
  inside.region = RegionId(1);
  const auto place = nothing.place(complex, inside);
  CHECK(cell_name(place.dimension, place.index) == "-");
  CHECK(component_of(nothing, place) == 0);
  // As soon as something is active, what lies around is listed and inactive.
  Selection corner;
  corner.vertices.emplace_back(complex.vertices[0], 2);
  const auto some = simplify(complex, corner, {});
  REQUIRE(some.regions.size() == 1);
  CHECK(component_of(some, some.place(complex, inside)) == 0);
  CHECK(component_of(some, some.vertex_place[complex.vertices[0].index()]) == 2);
}

TEST_CASE("open sets: missing cells remain as inactive ones", "[simplify]") {
  // A box without its walls, and without one inner point and one inner wire.
  const auto built_complex = complex_of(
      {box({0, 0, 0}, {4, 4, 4}), sheet({0, 0, 2}, {4, 4, 2}) + point({1, 1, 1}) + wire({2, 2, 1}, {2, 2, 3})});
  const Complex& complex = *built_complex;
  Selection s;
  for (std::size_t r = 1; r < complex.region_count; ++r) s.regions.emplace_back(RegionId(r), 1);
  for (FaceId f : IdRange<FaceId>(complex.face_count())) {
    const auto& [front, back] = complex.face_regions[f];
    if (front != RegionId(0) && back != RegionId(0)) s.faces.emplace_back(f, 1);
  }
  for (VertexId v : complex.vertices) {
    const auto x = complex.points.approx(v);
    if (x[0] == 2 && x[1] == 2 && x[2] == 2) s.vertices.emplace_back(v, 1);
  }
  const auto simplified = simplify(complex, s, {});
  CHECK(active_counts(simplified) == Counts{1, 0, 0, 1});
  // Walls, their edges and corners, the pieces of the wire with their ends, the missing point.
  CHECK(simplified.faces.size() == 6);
  CHECK(simplified.edges.size() == 12 + 2);
  CHECK(simplified.vertices.size() == 8 + 3 + 1);
}

TEST_CASE("a slit is walked twice and a puncture is isolated", "[simplify]") {
  const auto built_complex =
      complex_of({sheet({0, 0, 0}, {4, 4, 0}), wire({1, 1, 0}, {3, 1, 0}), point({2, 3, 0})});
  const Complex& complex = *built_complex;
  Features features;
  for (EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
    if (complex.edge_uses[e].size() == 2) features.edges.push_back(e);
  }
  for (VertexId v : complex.vertices) {
    if (!complex.isolated_leaves[v].empty()) features.vertices.push_back(v);
  }
  REQUIRE(features.edges.size() == 1);
  const auto s = simplify(complex, everything(complex), features);
  CHECK(active_counts(s) == Counts{7, 5, 1, 0});
  REQUIRE(s.faces.size() == 1);
  REQUIRE(s.faces[0].loops.size() == 2);
  CHECK(s.faces[0].loops[0].size() == 4);
  CHECK(s.faces[0].loops[1].size() == 2);
  CHECK(s.faces[0].isolated.size() == 1);
  const auto points = simplify(complex, everything(complex), features, SimplifyMode::points);
  CHECK(active_counts(points) == Counts{4, 4, 1, 0});
}

}  // namespace
}  // namespace cnrg
