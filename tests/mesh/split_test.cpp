// Sides of faults with nodes of their own, held against what the unsplit mesh says by brute force.
#include "csg/mesh/split.h"

#include <map>
#include <random>
#include <set>

#include "csg/formats/formats.h"
#include "csg/mesh/mesh_of_result.h"
#include "csg/mesh/second_order.h"
#include "csg/result/result_data.h"
#include "kernel/base/sorted.h"
#include "kernel/base/union_find.h"
#include "tests/catch.h"
#include "tests/mesh/result_of.h"

using namespace cnrg;
using Catch::Contains;

namespace {

using Index = Mesh::Index;
using Side3 = std::array<Index, 3>;

std::vector<Side3> sides_by_corners(const Mesh::Simplex<4>& t) {
  const auto& [a, b, c, d] = t.points;
  return {sorted(Side3{b, c, d}), sorted(Side3{a, c, d}), sorted(Side3{a, b, d}), sorted(Side3{a, b, c})};
}

std::vector<Side3> triangles_of(const Mesh& mesh, const std::string& name) {
  std::vector<Side3> out;
  for (const auto& t : mesh.triangles) {
    for (const Index g : mesh.entities[2][t.entity].groups)
      if (mesh.groups[2][g - 1] == name) out.push_back(t.points);
  }
  return out;
}

/// Tetrahedra that have a node in common, joined.
std::size_t bodies(const Mesh& mesh) {
  UnionFind sets(mesh.points.size());
  for (const auto& t : mesh.tetrahedra)
    for (const Index p : t.points) sets.unite(p, t.points[0]);
  std::set<Index> roots;
  for (const auto& t : mesh.tetrahedra) roots.insert(sets.find(t.points[0]));
  return roots.size();
}

/// Walks from a tetrahedron at a node to the others, through sides that `through` lets pass.
template <class Through>
std::map<Index, Index> classes(const Mesh& mesh, const std::vector<Index>& at, Index node,
                               const Through& through) {
  std::map<Index, Index> of;
  for (const Index first : at) {
    if (of.contains(first)) continue;
    std::vector<Index> stack{first};
    of[first] = first;
    while (!stack.empty()) {
      const Index t = stack.back();
      stack.pop_back();
      for (const Index u : at) {
        for (const Side3& side : sides_by_corners(mesh.tetrahedra[u])) {
          const auto others = sides_by_corners(mesh.tetrahedra[t]);
          if (of.contains(u) || std::ranges::find(side, node) == side.end() || !through(side)) continue;
          if (std::ranges::find(others, side) == others.end()) continue;
          of[u] = first;
          stack.push_back(u);
        }
      }
    }
  }
  return of;
}

/// All that is promised of a split mesh, from the whole one.
void check_split(const Mesh& whole, const Mesh& parted, const std::vector<std::string>& names, bool interfaces) {
  std::set<Side3> faults;
  for (const std::string& name : names)
    for (const Side3& t : triangles_of(whole, "from " + name)) faults.insert(sorted(t));
  REQUIRE(parted.tetrahedra.size() == whole.tetrahedra.size());
  std::map<Index, std::vector<Index>> at;
  std::map<Side3, std::size_t> sides, whole_sides;
  for (Index t = 0; t < whole.tetrahedra.size(); ++t) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Index p = whole.tetrahedra[t].points[k], q = parted.tetrahedra[t].points[k];
      at[p].push_back(t);
      CHECK(parted.twins[q] == p);
      CHECK(parted.points[q] == whole.points[p]);
    }
    for (const Side3& side : sides_by_corners(parted.tetrahedra[t])) ++sides[side];
    for (const Side3& side : sides_by_corners(whole.tetrahedra[t])) ++whole_sides[side];
  }
  for (const auto& [p, tetrahedra] : at) {
    const auto stars = classes(whole, tetrahedra, p, [](const Side3&) { return true; });
    const auto sectors = classes(whole, tetrahedra, p, [&](const Side3& side) { return !faults.contains(side); });
    const auto node = [&](Index t) {
      const auto& points = whole.tetrahedra[t].points;
      return parted.tetrahedra[t].points[std::size_t(std::ranges::find(points, p) - points.begin())];
    };
    for (const Index t : tetrahedra) {
      for (const Index u : tetrahedra) {
        if (stars.at(t) == stars.at(u)) CHECK((node(t) == node(u)) == (sectors.at(t) == sectors.at(u)));
      }
    }
  }
  // A triangle is a side of as many tetrahedra as before, one of each half of a face that was split.
  const auto before = [&](const Side3& t) {
    return sorted(Side3{parted.twins[t[0]], parted.twins[t[1]], parted.twins[t[2]]});
  };
  std::map<Side3, std::size_t> halves;
  for (const auto& t : parted.triangles) ++halves[before(t.points)];
  for (const auto& t : parted.triangles) {
    const Side3 whole_side = before(t.points);
    CHECK(halves[whole_side] * sides[sorted(t.points)] == whole_sides[whole_side]);
    CHECK(halves[whole_side] <= (faults.contains(whole_side) ? 2 : 1));
  }
  std::size_t wedges = 0;
  for (const std::string& name : names) {
    const auto back = triangles_of(parted, "back of " + name), front = triangles_of(parted, "front of " + name);
    std::set<Side3> opened;
    for (const Side3& t : back) {
      if (halves[before(t)] == 2) opened.insert(before(t));
    }
    CHECK(front.size() == opened.size());
    for (const Side3& t : front) CHECK(opened.contains(before(t)));
    wedges += front.size();
  }
  CHECK(parted.wedges.size() == (interfaces ? wedges : 0));
  // A wire is in one piece but where it passes a fault, and each piece is of edges of tetrahedra.
  std::set<std::uint64_t> edges;
  for (const auto& t : parted.tetrahedra)
    for (const auto& [i, j] : kSecondOrderEdges) edges.insert(edge_key(t.points[i], t.points[j]));
  for (const auto& s : parted.segments) CHECK(edges.contains(edge_key(s.points[0], s.points[1])));
  if (!whole.middles.empty()) {
    std::map<Index, std::set<Index>> twins;
    for (const auto& [ends, m] : parted.middles) {
      CHECK(parted.points[m] == parted.points[parted.twins[m]]);
      CHECK(parted.twins[m] == whole.middle(parted.twins[ends[0]], parted.twins[ends[1]]));
      CHECK(twins[parted.twins[m]].insert(m).second);
    }
  }
}

Mesh mesh_of(const std::string& nodes, const TetrahedraOptions& options = {}) {
  return tetrahedra(result_of(nodes), options).mesh;
}

std::string block_with(const std::vector<std::string>& polygons, const std::string& more = "") {
  std::string text = "  block: {box: {min: [0, 0, 0], max: [8, 8, 8]}}\n", all = "block";
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    text += "  f" + std::to_string(i) + ": {polygon: " + polygons[i] + "}\n";
    all += ", f" + std::to_string(i);
  }
  return text + more + "  model: {union: [" + all + (more.empty() ? "" : ", bolt") + "]}\n";
}

const std::string kTip = "[[4, 0, 0], [4, 8, 0], [4, 8, 5], [4, 0, 5]]",
                  kBolt = "  bolt: {polyline: [[1, 1, 3], [7, 2, 3]]}\n";

}  // namespace

TEST_CASE("a fault through a block parts it, a fault with a tip does not", "[mesh][split]") {
  const Mesh through = mesh_of(
      block_with({"[[4, 0, 0], [4, 8, 0], [4, 8, 8], [4, 0, 8]]", "[[0, 4, 0], [8, 4, 0], [8, 4, 8], [0, 4, 8]]"},
                 kBolt),
      {.size = 3});
  using Names = std::vector<std::string>;
  for (const auto& [names, parts] : std::map<Names, std::size_t>{{{"f0"}, 2}, {{"f1"}, 2}, {{"f0", "f1"}, 4}}) {
    Mesh parted = through;
    split(parted, names, false);
    CHECK(bodies(parted) == parts);
    check_split(through, parted, names, false);
  }
  const Mesh tip = mesh_of(block_with({kTip}), {.size = 3});
  Mesh parted = tip;
  const SplitReport report = split(parted, {"f0"}, true);
  CHECK(bodies(parted) == 1);
  check_split(tip, parted, {"f0"}, true);
  CHECK(report.wedges == parted.wedges.size());
  std::size_t on_fault = 0;  // all but those at the tip have a twin
  for (const auto& p : tip.points) on_fault += p[0] == 4 && p[2] < 5;
  CHECK(report.twins == on_fault);
}

TEST_CASE("random faults are split as brute force says, of both orders", "[mesh][split][random]") {
  const unsigned seed = GENERATE(1U, 2U, 3U, 4U, 5U, 6U);
  INFO("seed " << seed);
  std::mt19937 random(seed);
  const auto number = [&] { return std::to_string(random() % 17) + "/2"; };
  std::vector<std::string> polygons, names;
  for (std::size_t i = 0; i < 1 + seed % 3; ++i) {
    std::string points;
    for (std::size_t k = 0; k < 3; ++k)
      points += (k == 0 ? "[" : ", [") + number() + ", " + number() + ", " + number() + "]";
    polygons.push_back("[" + points + "]");
    names.push_back("f" + std::to_string(i));
  }
  for (const int order : {1, 2}) {
    const Mesh whole = mesh_of(block_with(polygons, kBolt), {.order = order, .size = 4});
    Mesh parted = whole;
    split(parted, names, order == 1);
    check_split(whole, parted, names, order == 1);
  }
}

TEST_CASE("files tell sides, twins and wedges, and shells are none of the sides", "[mesh][split]") {
  const Result result = result_of(block_with({kTip}));
  const TetrahedralMesh made = tetrahedra(result, {.split = {"f0"}, .interfaces = true});
  REQUIRE(!made.mesh.wedges.empty());
  const std::string msh = msh_text(made.mesh);
  CHECK_THAT(msh, Contains("\"back of f0\"") && Contains("\"front of f0\"") && Contains("\"interface f0\""));
  CHECK_THAT(msh,
             Contains("$NodeData\n1\n\"twin\"\n1\n0\n3\n0\n1\n" + std::to_string(made.mesh.points.size()) + "\n"));
  const std::string inp = abaqus_text(made.mesh);
  CHECK_THAT(inp, Contains("TYPE=COH3D6") && Contains("*SURFACE, TYPE=ELEMENT, NAME=back_of_f0"));
  CHECK(inp.find("TYPE=S3") == std::string::npos);
  CHECK_THAT(vtu_text(result.data().view(), made.mesh), Contains("<DataArray type=\"UInt32\" Name=\"twin\""));
}

TEST_CASE("what cannot be split is an error before the mesh is made, or says why", "[mesh][split][errors]") {
  const Result result = result_of(block_with({kTip}));
  const auto no_mesh = [](const MeshForecast&) { FAIL("it was meshed before"); };
  CHECK_THROWS_WITH(tetrahedra(result, {.split = {"f9"}, .foretold = no_mesh}),
                    Contains("called `f9`") && Contains("`from f0`"));
  CHECK_THROWS_WITH(tetrahedra(result, {.split = {"boundary of block"}}),
                    Contains("no face of `boundary of block` lies between"));
  CHECK_THROWS_WITH(tetrahedra(result, {.order = 2, .split = {"f0"}, .interfaces = true}),
                    Contains("wedges are of first order"));
}
