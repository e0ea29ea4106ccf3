// Tetrahedra of results: exact volumes by region, and everything that they have to conform to.
#include "csg/mesh/tetrahedra.h"

#include <array>
#include <cmath>
#include <random>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/formats.h"
#include "csg/formats/mesh_file.h"
#include "csg/operators/cnrg.h"
#include "kernel/base/error.h"
#include "kernel/selection/measure.h"
#include "kernel/tetrahedra/bounds.h"
#include "kernel/tetrahedra/shapes.h"
#include "tests/catch.h"
#include "tests/mesh/mesh_cases.h"
#include "tests/scenes/mesh_readers.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

/// As .msh, read back. Everything on faces and edges belongs to a tetrahedron.
MeshFile meshed(const ResultView& view, const TetrahedraOptions& options = {}) {
  const MeshFile mesh = read_msh(msh_text(tetrahedra(view, options).mesh));
  for (const auto& e : mesh.elements) {
    if (e.dimension == 3) CHECK(mesh.six_volumes(e) > 0);
  }
  return mesh;
}

const TetrahedraOptions kKept{0, 0, true}, kConstrained{0, 0, false, true};

}  // namespace

TEST_CASE("tetrahedra conform to a wall, a dangling face, a wire and a point", "[mesh]") {
  Case c = two_regions();
  for (const TetrahedraOptions& options :
       {TetrahedraOptions{}, kKept, kConstrained, TetrahedraOptions{0.05, 1.5, false}}) {
    const MeshFile mesh = meshed(c.view(), options);
    CHECK(mesh.volume("rock") == 8);
    CHECK(mesh.volume("seam") == 8);
    CHECK(mesh.volume("material granite") == 8);
    CHECK(mesh.measure(mesh.in_group(2, "wall rock | seam")) == Approx(4).epsilon(1e-14));
    CHECK(mesh.measure(mesh.in_group(2, "face of leaf2")) == Approx(1).epsilon(1e-14));
    CHECK(mesh.measure(mesh.in_group(2, "boundary of rock")) == Approx(20).epsilon(1e-14));
    CHECK(mesh.measure(mesh.in_group(1, "wire of leaf3")) == Approx(1).epsilon(1e-14));
    CHECK(mesh.in_group(0, "point of leaf4").size() == 1);
    for (int d = 0; d < 3; ++d) CHECK(mesh.loose(d) == 0);
  }
}

TEST_CASE("tetrahedra of regions with holes, cavities and edges in common", "[mesh]") {
  for (const TetrahedraOptions& options : {TetrahedraOptions{}, kKept, kConstrained}) {
    MeshFile mesh = meshed(ring().view(), options);
    CHECK(mesh.volume("region 1") == 24);
    CHECK(mesh.measure(mesh.in_group(2, "boundary of region 1")) == Approx(64).epsilon(1e-14));
    mesh = meshed(nested().view(), options);
    CHECK(mesh.volume("shell") == 386);
    CHECK(mesh.volume("block") == 8);
    mesh = meshed(hinge().view(), options);
    CHECK(mesh.volume("region 1") == 1);
    CHECK(mesh.volume("region 2") == 1);
    CHECK(mesh.loose(2) == 0);
  }
}

TEST_CASE("what lies outside of the regions is in the mesh, too, and conforms", "[mesh]") {
  Case c = pierced();
  for (const TetrahedraOptions& options : {TetrahedraOptions{}, TetrahedraOptions{0, 1.5, false}}) {
    const MeshFile mesh = meshed(c.view(), options);
    CHECK(to_double(mesh.volume("region 1")) == Approx(27).epsilon(1e-12));
    CHECK(mesh.measure(mesh.in_group(2, "face of leaf1")) == Approx(6).epsilon(1e-12));
    CHECK(mesh.measure(mesh.in_group(1, "wire of leaf2")) == Approx(std::sqrt(49.5)).epsilon(1e-12));
    CHECK(mesh.in_group(0, "point of leaf3").size() == 1);
    CHECK(mesh.loose(2) > 0);
    CHECK(mesh.loose(0) > 0);
    // Each corner of a triangle outside is one point with what is inside: no node lies twice at one place.
    std::set<std::array<double, 3>> places;
    for (const auto& [number, p] : mesh.nodes) CHECK(places.insert(p).second);
  }
}

// TetGen puts tetrahedra into the gap that overlap; the improver then lost triangles of the sheet.
TEST_CASE("a sheet just above a box, of which TetGen makes tetrahedra that overlap, keeps its area", "[mesh]") {
  const Result result = evaluate(parse_tree(R"(cnrg: 1
nodes:
  box:  {box: {min: [0, 0, 0], max: [1, 2, 3]}}
  near: {polygon: [[-1, -1, 3.00001], [3, -1, 3.00001], [0.5, 4, 3.00001]]}
  all:  {union: [near, box], dominance: left}
result: all
)",
                                            "near.yaml"))
                            .result();
  const TetrahedralMesh made = tetrahedra(result, {});
  CHECK_THAT(made.notice, Catch::Contains("overlap outside of all regions"));
  const MeshFile mesh = read_msh(msh_text(made.mesh));
  CHECK(mesh.volume("box") == 6);
  CHECK(mesh.measure(mesh.in_group(2, "face of near")) == Approx(10).epsilon(1e-12));
}

TEST_CASE("small parts far from the origin, where doubles are far apart, are meshed", "[mesh]") {
  for (const char* part :
       {"{sphere: {center: [1e6, 1e6, 0], radius: 0.00001, segments: 8}}",
        "{cylinder: {from: [1e7, 1e7, 0], to: [1e7, 1e7, 0.0006], radius: 0.0002, segments: 6}}"}) {
    INFO(part);
    const Result result =
        evaluate(parse_tree("cnrg: 1\nnodes:\n  part: " + std::string(part) + "\nresult: part\n", "far.yaml"))
            .result();
    for (const double size : {0.0, 1e-4}) {
      TetrahedraOptions options;
      options.size = size;
      const TetrahedralMesh made = tetrahedra(result, options);
      CHECK(!made.mesh.tetrahedra.empty());
    }
  }
}

// TetGen leaves edges of more than twice the size in it.
TEST_CASE("no edge of a flat tetrahedron's mesh is longer than the size allows", "[mesh][sizes]") {
  const Result result = evaluate(parse_tree(R"(cnrg: 1
nodes: {flat: {tetrahedron: [[10, 4, 0], [3, 2, 9], [7, 9, 10], [2, 3, 10]]}}
result: flat
)",
                                            "flat.yaml"))
                            .result();
  for (const bool constrained : {false, true}) {
    TetrahedraOptions options;
    options.size = 0.5;
    options.constrained = constrained;
    const TetrahedralMesh made = tetrahedra(result, options);
    INFO("constrained " << constrained << ": " << made.notice);
    std::size_t longer = 0;
    const auto& p = made.mesh.points;
    for (const auto& t : made.mesh.tetrahedra)
      longer += longest_edge_of(p[t.points[0]], p[t.points[1]], p[t.points[2]], p[t.points[3]]).length >
                kLongestEdge * options.size;
    CHECK(longer == 0);
    CHECK(made.mesh.tetrahedra.size() > 1000);
    CHECK_THAT(made.notice, !Catch::Contains("1.4 times"));
  }
}

TEST_CASE("rounded corners: volumes to the last bit where the boundary is kept", "[mesh]") {
  Case c = oblique();
  const TetrahedralMesh kept = tetrahedra(c.view(), kKept);
  CHECK(kept.rounding.moved > 0);
  CHECK(kept.rounding.embedded);
  Rational all = 0;
  for (const auto& region : kept.regions) all += region.volume;
  const TetrahedralMesh split = tetrahedra(c.view(), {2, 1.4, false});
  REQUIRE(kept.regions.size() == split.regions.size());
  for (std::size_t i = 0; i < kept.regions.size(); ++i) {
    CHECK(kept.regions[i].tetrahedra < split.regions[i].tetrahedra);
    const Rational error = abs(kept.regions[i].volume / split.regions[i].volume - 1);
    CHECK(error < Rational(1, 10000000000000));
  }
  // Of the exact regions: the last digits of the points only.
  std::vector<RegionId> cells;
  for (const auto& [cell, region] : c.group.cells) cells.push_back(cell);
  const Rational exact = *volume(*c.complex, cells);
  CHECK(abs(all / exact - 1) < Rational(1, 1000000000000));
}

TEST_CASE("bounds of volume and shape hold", "[mesh]") {
  Case c = ring();
  const MeshFile mesh = meshed(c.view(), {0.1, 1.4, false});
  for (const auto& e : mesh.elements) {
    if (e.dimension == 3) CHECK(mesh.six_volumes(e) < Rational(6001, 10000));
  }
  CHECK(mesh.count(3) >= 240);
}

TEST_CASE("with the boundary kept no point is added to it", "[mesh]") {
  Soup soup;
  add_drum(soup, 24, 0, 10);
  Case c(soup);
  const TetrahedralMesh made = tetrahedra(c.view(), {1, 1.4, true});
  std::set<std::uint32_t> on_faces;
  for (const auto& t : made.mesh.triangles) on_faces.insert(t.points.begin(), t.points.end());
  CHECK(on_faces.size() == 48);
  CHECK(made.mesh.triangles.size() == 2 * 24 + 2 * 22);
}

TEST_CASE("the same mesh every time, in every format", "[mesh]") {
  const Case c = oblique();
  const Mesh a = tetrahedra(c.view(), {2, 1.4, false}).mesh, b = tetrahedra(c.view(), {2, 1.4, false}).mesh;
  CHECK(msh_text(a) == msh_text(b));
  CHECK(medit_text(a) == medit_text(b));
  CHECK(vtu_text(c.view(), a) == vtu_text(c.view(), b));
  const MeshFile msh = read_msh(msh_text(a)), medit = read_medit(medit_text(a));
  CHECK(medit.nodes == msh.nodes);
  CHECK(medit.names_of(3) == msh.names_of(3));
  for (int d = 2; d < 4; ++d) CHECK(medit.count(d) == msh.count(d));
  for (const std::string& name : msh.names_of(3)) CHECK(medit.volume(name) == msh.volume(name));
}

TEST_CASE("a rim that comes back to its only vertex", "[mesh]") {
  Soup soup;
  add_drum(soup, 12, 0, 3);
  add_wire(soup, {5, 0, 3}, {8, 0, 3});
  Case c(soup);
  c.show(c.unite());
  for (const TetrahedraOptions& options : {TetrahedraOptions{}, kKept, kConstrained}) {
    const MeshFile mesh = meshed(c.view(), options);
    CHECK(mesh.measure(mesh.in_group(1, "wire of leaf1")) == Approx(3).epsilon(1e-14));
    CHECK(mesh.names_of(3).size() == 1);
  }
}

TEST_CASE("crossing fractures: their area and the volume of the rock are kept", "[mesh]") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {2, 2, 2});
  add_sheet(soup, {{Rational(1, 3), Rational(1, 3), 1},
                   {Rational(5, 3), Rational(1, 3), 1},
                   {Rational(5, 3), Rational(5, 3), 1},
                   {Rational(1, 3), Rational(5, 3), 1}});
  add_sheet(soup, {{1, Rational(1, 7), Rational(1, 7)},
                   {1, Rational(9, 7), Rational(1, 7)},
                   {1, Rational(9, 7), Rational(13, 7)},
                   {1, Rational(1, 7), Rational(13, 7)}});
  Case c(soup);
  c.show(c.unite(Dominance::right));
  for (const TetrahedraOptions& options :
       {TetrahedraOptions{}, kKept, kConstrained, TetrahedraOptions{0, 1.4, false}}) {
    const MeshFile mesh = meshed(c.view(), options);
    CHECK(to_double(mesh.volume("region 1")) == Approx(8).epsilon(1e-14));
    CHECK(mesh.measure(mesh.in_group(2, "face of leaf1")) == Approx(16.0 / 9).epsilon(1e-14));
    CHECK(mesh.measure(mesh.in_group(2, "face of leaf2")) == Approx(96.0 / 49).epsilon(1e-14));
    CHECK(mesh.loose(2) == 0);
  }
}

TEST_CASE("what cannot be meshed says so", "[mesh][errors]") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  add_sheet(soup, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const Rational beyond = 1 + Rational(1, Integer("1000000000000000000000000000000"));
  add_point(soup, {beyond, Rational(1, 2), Rational(1, 2)});
  Case c(soup);
  c.show(c.leaves[1]);
  CHECK_THROWS_WITH(tetrahedra(c.view()), Catch::Contains("no region to fill"));
  c.show(topological_operation(*c.complex, Topological::interior, components_of(*c.complex, c.leaves[0])).value);
  CHECK_THROWS_WITH(tetrahedra(c.view()), Catch::Contains("apply `closure`"));
  c.show(boolean_operation(*c.complex, BooleanOp::unite, Dominance::equal, c.leaves[0], c.leaves[2]).group);
  CHECK_THROWS_WITH(tetrahedra(c.view()), Catch::Contains("makes facets cross"));
}

// The end of a wire lies beside another wire, nearer than doubles are there: what cuts the other one beside it
// comes to lie on it, or on its other side.
TEST_CASE("a wire that ends beside another one, nearer than doubles are, is meshed", "[mesh]") {
  Soup soup;
  add_box(soup, {-4, -4, -4}, {4, 4, 4});
  const auto at = [](double x, double y, double z) {
    return RationalPoint{from_double(x), from_double(y), from_double(z)};
  };
  const RationalPoint end = at(-0.5, 0.87499994039535522, 0.49999997019767761);
  add_wire(soup, at(-2.5, 1.875, 0.50000011920928955), at(1.5, -0.12500011920928961, 0.49999982118606567));
  add_wire(soup, end, at(-0.5, -1, 0.25));
  Case c(soup);
  c.show(c.unite());
  const MeshFile mesh = meshed(c.view(), kConstrained);
  CHECK(to_double(mesh.volume("region 1")) == Approx(512).epsilon(1e-14));
  const double first = std::hypot(4, 2.00000011920928961, 3.0e-7);
  CHECK(mesh.measure(mesh.in_group(1, "wire of leaf1")) == Approx(first).epsilon(1e-9));
  CHECK(mesh.measure(mesh.in_group(1, "wire of leaf2")) == Approx(std::hypot(1.875, 0.25)).epsilon(1e-7));
}

TEST_CASE("wires too near to each other for doubles are told with a place", "[mesh][errors]") {
  Soup soup;
  add_box(soup, {-4, -4, -4}, {4, 4, 4});
  std::mt19937_64 random(1);
  const auto part = [&] { return double(random() % 1'000'000) / 1e6 - 0.5; };
  for (int wire = 0; wire < 6; ++wire) {
    const std::array<double, 3> way{part(), part(), part()};
    const auto at = [&](double t) {
      return RationalPoint{from_double(0.3 + t * way[0]), from_double(0.4 + t * way[1]),
                           from_double(0.7 + t * way[2])};
    };
    add_wire(soup, at(1), at(-0.7));
  }
  Case c(soup);
  c.show(c.unite());
  CHECK_THROWS_WITH(tetrahedra(c.view(), kConstrained),
                    Catch::Contains("too thin for doubles near (0.3 0.4 0.7)"));
}

TEST_CASE("rounding that takes a point through a wall is refused", "[mesh][errors]") {
  // The wall x + y = z/3 at z = 1 lies beside every double; the point is nearer to it than the doubles around it.
  Soup soup;
  const LeafId solid = soup.add_leaf(Fill::winding);
  const Rational third(1, 3);
  const RationalPoint corners[] = {{third, 0, 0}, {third, 1, 0}, {third, 0, 1}, {-1, 0, 0}};
  std::vector<PointId> p;
  for (const auto& corner : corners) p.push_back(soup.add_point(corner));
  const int faces[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  std::uint32_t number = 0;
  for (const auto& f : faces) {
    soup.add_triangle(solid, p[std::size_t(f[0])], p[std::size_t(f[1])], p[std::size_t(f[2])], number, number);
    ++number;
  }
  // 1/3 rounds down; a point just outside of the wall rounds to the same double and so onto the wall.
  const Rational tiny(1, Integer("100000000000000000000"));
  add_point(soup, {third + tiny, Rational(1, 4), Rational(1, 4)});
  Case c(soup);
  c.show(c.unite());
  CHECK_THROWS_AS(tetrahedra(c.view()), InputError);
}
