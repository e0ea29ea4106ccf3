// Quadrilaterals of surface meshes beside Boost's greatest matching, which shares no code with ours, and
// tetrahedra on the triangles of surfaces.
#include "csg/mesh/quads.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "csg/formats/formats.h"
#include "csg/mesh/surface_triangles.h"
#include "csg/mesh/tetrahedra.h"
#include "kernel/base/error.h"
#include "tests/catch.h"
#include "tests/mesh/mesh_cases.h"
#include "tests/scenes/scene.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

using Index = Mesh::Index;
using Vector = std::array<double, 3>;
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;

std::size_t most_pairs(std::size_t count, const std::vector<TrianglePair>& pairs) {
  Graph graph(count);
  for (const TrianglePair& p : pairs) boost::add_edge(p.first, p.second, graph);
  std::vector<boost::graph_traits<Graph>::vertex_descriptor> mate(count);
  boost::edmonds_maximum_cardinality_matching(graph, &mate[0]);
  return boost::matching_size(graph, &mate[0]);
}

/// Of all pairs that share no triangle: the greatest sum of 1 + quality, by trying all.
double greatest(const std::vector<TrianglePair>& pairs, std::size_t at, std::uint32_t used) {
  if (at == pairs.size()) return 0;
  const double without = greatest(pairs, at + 1, used);
  const std::uint32_t both = 1u << pairs[at].first | 1u << pairs[at].second;
  if ((used & both) != 0) return without;
  return std::max(without, 1 + pairs[at].quality + greatest(pairs, at + 1, used | both));
}

double angle_at(const Vector& a, const Vector& b, const Vector& c) {  // at b, degrees, by the law of cosines
  const auto square = [](const Vector& p, const Vector& q) {
    return std::pow(p[0] - q[0], 2) + std::pow(p[1] - q[1], 2) + std::pow(p[2] - q[2], 2);
  };
  const double p = square(a, b), q = square(b, c), r = square(a, c);
  return std::acos(std::clamp((p + q - r) / (2 * std::sqrt(p * q)), -1.0, 1.0)) * 180 / 3.14159265358979323846;
}

/// Sides of triangles and quadrilaterals, each with how often and the sum of entities.
template <class... Lists>
std::map<std::array<Index, 2>, std::pair<int, Index>> sides_of(const Lists&... lists) {
  std::map<std::array<Index, 2>, std::pair<int, Index>> sides;
  const auto add = [&](const auto& list) {
    for (const auto& s : list) {
      for (std::size_t k = 0; k < s.points.size(); ++k) {
        const auto [a, b] = std::minmax(s.points[k], s.points[(k + 1) % s.points.size()]);
        auto& [count, sum] = sides[{a, b}];
        ++count, sum += s.entity;
      }
    }
  };
  (add(lists), ...);
  return sides;
}

}  // namespace

TEST_CASE("quads: matchings are nearly the greatest", "[mesh][quads]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> quality(0.34, 1);
  for (int run = 0; run < 40; ++run) {  // small: all ways are tried
    std::vector<TrianglePair> pairs;
    std::array<int, 12> degree{};
    for (std::uint32_t i = 0; i < 12; ++i) {
      for (std::uint32_t j = i + 1; j < 12; ++j) {
        if (random() % 3 != 0 || degree[i] == 3 || degree[j] == 3) continue;
        ++degree[i], ++degree[j];
        pairs.push_back({i, j, quality(random)});
      }
    }
    double sum = 0;
    std::set<std::uint32_t> used;
    for (const std::uint32_t p : match(12, pairs)) {
      CHECK(used.insert(pairs[p].first).second);
      CHECK(used.insert(pairs[p].second).second);
      sum += 1 + pairs[p].quality;
    }
    CHECK(sum == Approx(greatest(pairs, 0, 0)));  // paths are longer than any that 12 triangles need
  }
  std::vector<TrianglePair> pairs;  // a strip of hexagons: 3 neighbours each
  constexpr std::uint32_t kCount = 3000;
  for (std::uint32_t i = 0; i + 1 < kCount; ++i) pairs.push_back({i, i + 1, quality(random)});
  for (std::uint32_t i = 0; i + 31 < kCount; i += 2) pairs.push_back({i, i + 31, quality(random)});
  CHECK(double(match(kCount, pairs).size()) >= 0.99 * double(most_pairs(kCount, pairs)));
  CHECK(match(4, {{0, 1, 0.5}, {1, 2, 1}, {2, 3, 0.5}}).size() == 2);
  CHECK(match(3, {{0, 1, 0.5}, {1, 2, 0.75}}) == std::vector<std::uint32_t>{1});
}

TEST_CASE("quads: conforming, convex, of the same area and with the same sides on edges", "[mesh][quads]") {
  for (Case (*make)() : {two_regions, ring, nested, hinge, pierced, oblique}) {
    const Case c = make();
    const auto size = [](const Vector&) { return 0.5; };
    const SurfaceTriangles plain = surface_triangles(c.view(), {.size = size});
    const SurfaceTriangles made = surface_triangles(c.view(), {.size = size, .quads = true});
    const Mesh& mesh = made.mesh;
    CHECK(mesh.points == plain.mesh.points);
    CHECK(mesh.triangles.size() + 2 * mesh.quads.size() == plain.mesh.triangles.size());
    CHECK(mesh.quads.size() > mesh.triangles.size());
    double least = 180, most = 0;
    for (const auto& q : mesh.quads) {
      for (std::size_t k = 0; k < 4; ++k) {
        const double at = angle_at(mesh.points[q.points[(k + 3) % 4]], mesh.points[q.points[k]],
                                   mesh.points[q.points[(k + 1) % 4]]);
        least = std::min(least, at), most = std::max(most, at);
      }
    }
    CHECK(least > 29.999);
    CHECK(most < 150.001);
    // What is left of the sides of triangles are those of both, but one inside of each quadrilateral.
    const auto before = sides_of(plain.mesh.triangles), after = sides_of(mesh.triangles, mesh.quads);
    CHECK(before.size() == after.size() + mesh.quads.size());
    for (const auto& [side, entry] : after) CHECK(before.at(side) == entry);
    for (const auto& s : mesh.segments) {
      const auto [a, b] = std::minmax(s.points[0], s.points[1]);
      CHECK(before.count({a, b}) == after.count({a, b}));
    }
    std::size_t quads = 0;
    double area = 0, plain_area = 0;
    for (const FaceTriangles& of : made.groups) quads += of.quads, area += of.area;
    for (const FaceTriangles& of : plain.groups) plain_area += of.area;
    CHECK(quads == mesh.quads.size());
    CHECK(area == Approx(plain_area).epsilon(1e-14));
  }
  const Case c = two_regions();
  CHECK_THROWS_WITH(surface_triangles(c.view(), {.order = 2, .quads = true}), Catch::Contains("second order"));
}

TEST_CASE("surface first: the boundary of tetrahedra is the surface mesh", "[mesh][surface][tetrahedra]") {
  for (Case (*make)() : {two_regions, ring, nested, hinge, pierced, oblique}) {
    const Case c = make();
    for (const double size : {0.0, 0.7}) {
      TetrahedraOptions options;
      options.surface_first = true;
      options.size = size;
      options.quality = 2;
      SurfaceOptions surface;
      surface.overall = size;
      const Mesh mesh = tetrahedra(c.view(), options).mesh, faces = surface_triangles(c.view(), surface).mesh;
      const auto places = [](const Mesh& of, const auto& list) {
        std::multiset<std::pair<Index, std::vector<Vector>>> result;
        for (const auto& s : list) {
          std::vector<Vector> corners;
          for (const Index p : s.points) corners.push_back(of.points[p]);
          std::sort(corners.begin(), corners.end());
          result.insert({s.entity, corners});
        }
        return result;
      };
      CHECK(!mesh.tetrahedra.empty());
      CHECK(places(mesh, mesh.triangles) == places(faces, faces.triangles));
      CHECK(places(mesh, mesh.segments) == places(faces, faces.segments));
    }
  }
  const Case c = two_regions();
  TetrahedraOptions both;
  both.surface_first = both.keep_boundary = true;
  CHECK_THROWS_WITH(tetrahedra(c.view(), both), Catch::Contains("neither that of --keep-boundary"));
}

TEST_CASE("surface first: plates that are thinner than their triangles are wide", "[mesh][surface][tetrahedra]") {
  // TetGen, asked for sizes, would refine without an end between triangles that stay.
  Soup soup;
  add_box(soup, {0, 0, 0}, {4, 4, Rational(1, 100)});
  for (const Rational& lean : {Rational(1, 50), Rational(-1, 100)})
    add_sheet(soup, {{2 + lean, -1, -1}, {2 - lean, 5, -1}, {2 - lean, 5, 1}, {2 + lean, -1, 1}});
  Case c(soup);
  c.show(boolean_operation(
             *c.complex, BooleanOp::intersect, Dominance::equal, c.leaves[0],
             boolean_operation(
                 *c.complex, BooleanOp::unite, Dominance::equal,
                 boolean_operation(*c.complex, BooleanOp::unite, Dominance::equal, c.leaves[0], c.leaves[1]).group,
                 c.leaves[2])
                 .group)
             .group);
  TetrahedraOptions options;
  options.surface_first = true;
  options.size = 1;
  const TetrahedralMesh made = tetrahedra(c.view(), options);
  CHECK_THAT(made.notice, Catch::Contains("thinner than the triangles around them are wide"));
  Rational volume = 0;
  for (const RegionTetrahedra& region : made.regions) volume += region.volume;
  CHECK(to_double(volume) == Approx(0.16).epsilon(1e-12));
  CHECK(made.mesh.tetrahedra.size() < 5 * made.mesh.triangles.size());
}

TEST_CASE("surface first: a bolt through a plate that is thinner than triangles are wide", "[mesh][surface]") {
  // One region: in the bolt there is room for sizes, in the plate there is none.
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, Rational(1, 200)});
  add_box(soup, {Rational(1, 4), Rational(1, 4), -1}, {Rational(1, 2), Rational(1, 2), 1});
  Case c(soup);
  c.show(c.unite());
  TetrahedraOptions options;
  options.surface_first = true;
  options.size = 0.5;
  const TetrahedralMesh made = tetrahedra(c.view(), options);
  Rational volume = 0;
  for (const RegionTetrahedra& region : made.regions) volume += region.volume;
  CHECK(to_double(volume) == Approx(1.0 / 200 + 1.0 / 8 - 1.0 / 3200).epsilon(1e-12));
  CHECK(made.mesh.tetrahedra.size() < 5 * made.mesh.triangles.size());
}

TEST_CASE("surface: very many triangles have the area of their faces", "[mesh][surface]") {
  Soup soup;
  add_sheet(soup, {{0, 0, 2}, {6, 0, 2}, {6, 4, 2}, {0, 4, 2}});
  const Case c = [&] {
    Case made(soup);
    made.show(made.unite());
    return made;
  }();
  const SurfaceTriangles made = surface_triangles(c.view(), {.size = [](const Vector&) { return 0.028; }});
  CHECK(made.mesh.triangles.size() > 30'000);
  CHECK(made.groups[0].area == Approx(24).epsilon(1e-9));
}
