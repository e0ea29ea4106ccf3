// Surface meshes for meshers, read back number by number; Gmsh and tetgen make tetrahedra of them.
#include <cmath>
#include <cstdlib>

#include "csg/operators/cnrg.h"
#include "csg/result/flat.h"
#include "kernel/base/error.h"
#include "tests/catch.h"
#include "tests/mesh/mesh_cases.h"
#include "tests/scenes/mesh_readers.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

std::string written(const ResultView& view, const std::string& extension) {
  const ScratchFolder dir;
  write(dir / ("m" + extension), view);
  return text_of(dir / ("m" + extension));
}

/// The volume that the triangles on the boundary of a region enclose, by the signs of its surfaces.
Rational enclosed(const MeshFile& mesh, int region) {
  Rational six = 0;
  for (const int s : mesh.entities.at({3, region}).boundary) {
    bool dangling = true;  // both sides look into the region: the volume has none of it
    for (const auto& [key, entity] : mesh.entities) {
      if (key.first != 2 || key.second != std::abs(s)) continue;
      dangling = mesh.names.at({2, entity.groups.at(0)}).rfind("face", 0) == 0;
    }
    if (dangling) continue;
    for (const auto& e : mesh.elements) {
      if (e.dimension != 2 || e.entity != std::abs(s)) continue;
      RationalPoint p[3];
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t j = 0; j < 3; ++j) p[k][j] = from_double(mesh.nodes.at(e.nodes[k])[j]);
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
        const Rational d = p[0][k] * (p[1][u] * p[2][v] - p[1][v] * p[2][u]);
        six += s > 0 ? d : Rational(-d);
      }
    }
  }
  return six / 6;
}

/// The boundary of every surface is closed, and every piece of an edge runs between its ends.
void check_topology(const MeshFile& mesh) {
  for (const auto& [key, entity] : mesh.entities) {
    if (key.first == 1) CHECK((entity.boundary.size() == 2 && entity.boundary[0] > 0 && entity.boundary[1] < 0));
    if (key.first != 2) continue;
    std::map<int, int> ends;
    for (const int c : entity.boundary) {
      for (const int p : mesh.entities.at({1, std::abs(c)}).boundary) {
        ends[std::abs(p)] += (p > 0) == (c > 0) ? 1 : -1;
      }
    }
    for (const auto& [point, sum] : ends) CHECK(sum == 0);
  }
}

/// The volume of each region by Gmsh.
std::map<int, double> by_gmsh(const ResultView& view) {
  const ScratchFolder dir;
  write(dir / "m.msh", view);
  const std::string run = "cd '" + dir.path() + "' && gmsh -3 m.msh -o out.msh >log 2>&1";
  const int status = std::system(run.c_str());
  INFO(text_of(dir / "log"));
  CHECK(status == 0);
  CHECK(text_of(dir / "log").find("Error") == std::string::npos);
  const MeshFile mesh = read_msh(text_of(dir / "out.msh"));
  CHECK(mesh.loose(2) == 0);
  std::map<int, double> volumes;
  for (const auto& [key, entity] : mesh.entities) {
    if (key.first == 3) volumes[key.second] = to_double(mesh.volume(key.second));
  }
  return volumes;
}

/// The volume of each region by tetgen.
std::map<int, double> by_tetgen(const ResultView& view, const std::string& extension) {
  const ScratchFolder dir;
  write(dir / ("m" + extension), view);
  const std::string run = "cd '" + dir.path() + "' && tetgen -pAQ m" + extension + " >log 2>&1";
  const int status = std::system(run.c_str());
  INFO(text_of(dir / "log"));
  CHECK(status == 0);
  return tetgen_volumes(text_of(dir / "m.1.node"), text_of(dir / "m.1.ele"));
}

void check_volumes(const std::map<int, double>& found, const std::vector<double>& expected) {
  REQUIRE(found.size() == expected.size());
  int number = 0;
  for (const double volume : expected) CHECK(found.at(++number) == Approx(volume).epsilon(1e-12));
}

}  // namespace

TEST_CASE(".msh of a surface: entities, groups by name in every dimension, boundaries", "[mesh]") {
  Case c = two_regions();
  const MeshFile mesh = read_msh(written(c.view(), ".msh"));
  CHECK(mesh.names_of(3) == std::set<std::string>{"rock", "seam", "material granite", "material ore"});
  CHECK(mesh.names_of(2) == std::set<std::string>{"boundary of rock", "boundary of seam", "wall rock | seam",
                                                  "face of leaf2", "from leaf0", "from leaf1", "from leaf2"});
  CHECK(mesh.measure(mesh.in_group(2, "from leaf0")) ==
        mesh.measure(mesh.in_group(2, "boundary of rock")) + mesh.measure(mesh.in_group(2, "wall rock | seam")));
  CHECK(mesh.measure(mesh.in_group(2, "from leaf2")) == 1);
  CHECK(mesh.names_of(1) == std::set<std::string>{"wire of leaf3", "edges"});
  CHECK(mesh.names_of(0) == std::set<std::string>{"point of leaf4", "vertices"});
  for (const auto& [key, entity] : mesh.entities) CHECK_FALSE(entity.groups.empty());
  CHECK(mesh.measure(mesh.in_group(2, "boundary of rock")) == 20);
  CHECK(mesh.measure(mesh.in_group(2, "wall rock | seam")) == 4);
  CHECK(mesh.measure(mesh.in_group(2, "face of leaf2")) == 1);
  CHECK(mesh.measure(mesh.in_group(1, "wire of leaf3")) == 1);
  REQUIRE(mesh.in_group(0, "point of leaf4").size() == 1);
  CHECK(mesh.nodes.at(mesh.in_group(0, "point of leaf4")[0].nodes[0]) == std::array<double, 3>{1, 1, 1.5});
  CHECK(mesh.nodes.size() == 12 + 4 + 2 + 1);
  CHECK(mesh.count(3) == 0);
  check_topology(mesh);
  CHECK(enclosed(mesh, 1) == 8);
  CHECK(enclosed(mesh, 2) == 8);
}

TEST_CASE(".msh: parts with one name are told apart by their numbers", "[mesh]") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {4, 1, 1});
  add_sheet(soup, {{1, -1, -1}, {1, 2, -1}, {1, 2, 2}, {1, -1, 2}});
  Case c(soup, {{{"a \"good\"\nrock", "", {}}}, {}});
  c.show(c.unite(Dominance::right));
  const MeshFile mesh = read_msh(written(c.view(), ".msh"));
  CHECK(mesh.names_of(3) == std::set<std::string>{"a 'good'\\nrock", "a 'good'\\nrock 1", "a 'good'\\nrock 2",
                                                  "a 'good'\\nrock front of leaf1",
                                                  "a 'good'\\nrock behind leaf1"});
  CHECK(mesh.names_of(2).count("wall a 'good'\\nrock 1 | a 'good'\\nrock 2") == 1);
}

TEST_CASE(".msh: what walks over itself or has a point inside is an entity per triangle", "[mesh]") {
  Case c = pierced();
  const MeshFile mesh = read_msh(written(c.view(), ".msh"));
  check_topology(mesh);
  std::map<int, int> triangles;
  for (const auto& e : mesh.elements) {
    if (e.dimension == 2) ++triangles[e.entity];
  }
  std::size_t single = 0;
  for (const auto& [entity, n] : triangles) single += n == 1;
  CHECK(single >= 12);
  CHECK(mesh.measure(mesh.in_group(2, "boundary of region 1")) == Approx(54).epsilon(1e-14));
}

TEST_CASE("curved patches: an entity for each facet, edges between them are no features", "[mesh]") {
  Soup soup;
  add_drum(soup, 12, 0, 3);
  Case c(soup);
  const MeshFile msh = read_msh(written(c.view(), ".msh"));
  std::size_t surfaces = 0, curves = 0;
  for (const auto& [key, entity] : msh.entities) surfaces += key.first == 2, curves += key.first == 1;
  CHECK(surfaces == 14);
  CHECK(curves == 36);
  check_topology(msh);
  const MeshFile medit = read_medit(written(c.view(), ".mesh"));
  CHECK(medit.count(1) == 24);
  CHECK(medit.lists.at("Ridges").size() == 24);
  CHECK(medit.lists.count("RequiredEdges") == 0);
}

TEST_CASE(".mesh of a surface: references, ridges, corners, required wires", "[mesh]") {
  Case c = two_regions();
  const MeshFile mesh = read_medit(written(c.view(), ".mesh"));
  CHECK(mesh.nodes.size() == 19);
  CHECK(mesh.names_of(2) ==
        std::set<std::string>{"boundary of rock", "boundary of seam", "wall rock | seam", "face of leaf2"});
  CHECK(mesh.measure(mesh.in_group(2, "boundary of seam")) == 20);
  CHECK(mesh.measure(mesh.in_group(2, "face of leaf2")) == 1);
  CHECK(mesh.measure(mesh.in_group(1, "wire of leaf3")) == 1);
  CHECK(mesh.in_group(0, "point of leaf4").size() == 1);
  CHECK(mesh.count(1) == 20 + 4 + 1);
  CHECK(mesh.lists.at("Ridges").size() == 24);
  CHECK(mesh.lists.at("RequiredEdges").size() == 1);
  CHECK(mesh.lists.at("Corners").size() == 19);
  CHECK(mesh.lists.at("RequiredVertices") == mesh.lists.at("Corners"));
}

TEST_CASE(".poly: whole faces with their holes, seeds of regions and cavities, wires, points", "[mesh]") {
  Case c = ring();
  const TetgenFile bored = read_tetgen(written(c.view(), ".poly"), true);
  std::size_t with_hole = 0;
  for (const auto& facet : bored.facets) {
    with_hole += facet.holes.size();
    CHECK(facet.polygons.size() == 1 + facet.holes.size());
    for (const auto& hole : facet.holes) {
      CHECK((hole[0] > 1 && hole[0] < 2 && hole[1] > 1 && hole[1] < 2));
      CHECK((hole[2] == 0 || hole[2] == 3));
    }
  }
  CHECK(bored.facets.size() == 10);
  CHECK(with_hole == 2);
  CHECK(bored.holes.empty());

  c = nested();
  const TetgenFile file = read_tetgen(written(c.view(), ".poly"), true);
  CHECK(file.facets.size() == 18);
  REQUIRE(file.regions.size() == 2);
  REQUIRE(file.holes.size() == 1);
  const auto within = [](const std::array<double, 3>& p, double low, double high) {
    return std::all_of(p.begin(), p.end(), [&](double x) { return x > low && x < high; });
  };
  CHECK((within(file.holes[0], 1, 8) && !within(file.holes[0], 3, 5)));
  for (const auto& region : file.regions) {
    if (within(region.point, 1, 8)) CHECK(within(region.point, 3, 5));
    CHECK(within(region.point, 0, 9));
  }

  c = two_regions();
  const TetgenFile two = read_tetgen(written(c.view(), ".poly"), true);
  std::map<int, int> marks;
  for (const auto& facet : two.facets) ++marks[facet.marker];
  CHECK(marks == std::map<int, int>{{1, 5}, {2, 5}, {3, 1}, {4, 1}, {5, 1}});  // the last: the wire
  int points = 0;
  for (const auto& [number, mark] : two.node_marker) points += mark;
  CHECK(points == 1);
}

TEST_CASE(".smesh: a triangle per facet", "[mesh]") {
  Case c = two_regions();
  const TetgenFile file = read_tetgen(written(c.view(), ".smesh"), false);
  CHECK(file.facets.size() == 2 * 12 + 1);
  CHECK(std::count_if(file.facets.begin(), file.facets.end(),
                      [](const auto& f) { return f.polygons[0].size() == 3; }) == 24);
  CHECK(file.regions.size() == 2);
}

TEST_CASE("formats of meshers hold closed and bounded results, and TetGen's embedded ones", "[mesh][errors]") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  const Rational beyond = 1 + Rational(1, Integer("1000000000000000000000000000000"));
  add_box(soup, {beyond, 0, 0}, {2, 1, 1});
  Case c(soup);
  c.show(c.unite());
  const ScratchFolder dir;
  for (const std::string extension : {".smesh", ".poly"}) {
    CHECK_THROWS_WITH(write(dir / ("m" + extension), c.view()),
                      Catch::Contains("makes facets cross") && Catch::Contains("4 vertices move"));
  }
  CHECK_FALSE(write(dir / "m.msh", c.view()).embedded);
  c.show(topological_operation(*c.complex, Topological::interior, components_of(*c.complex, c.leaves[0])).value);
  for (const std::string extension : {".msh", ".mesh", ".smesh", ".poly"}) {
    CHECK_THROWS_WITH(write(dir / ("m" + extension), c.view()), Catch::Contains("apply `closure`"));
  }
}

TEST_CASE("Gmsh fills our .msh: volumes are ours, walls and dangling faces are in the mesh", "[mesh][programs]") {
  if (!installed("gmsh")) NOT_RUN("gmsh is not installed (Debian: gmsh)");
  check_volumes(by_gmsh(two_regions().view()), {8, 8});
  check_volumes(by_gmsh(ring().view()), {24});
  check_volumes(by_gmsh(nested().view()), {386, 8});
  check_volumes(by_gmsh(hinge().view()), {1, 1});
}

TEST_CASE("tetgen fills our .smesh and .poly: volumes are ours", "[mesh][programs]") {
  if (!installed("tetgen")) NOT_RUN("tetgen is not installed (Debian: tetgen)");
  for (const std::string extension : {".smesh", ".poly"}) {
    check_volumes(by_tetgen(two_regions().view(), extension), {8, 8});
    check_volumes(by_tetgen(ring().view(), extension), {24});
    check_volumes(by_tetgen(nested().view(), extension), {386, 8});
    check_volumes(by_tetgen(hinge().view(), extension), {1, 1});
    check_volumes(by_tetgen(pierced().view(), extension), {27});
  }
}
