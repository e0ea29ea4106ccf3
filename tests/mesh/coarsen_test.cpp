// Larger facets of curved faces, held against those that were given, exactly.
#include "csg/mesh/coarsen.h"

#include "csg/mesh/planar_facets.h"
#include "csg/result/result_data.h"
#include "kernel/exact/distance.h"
#include "tests/catch.h"
#include "tests/mesh/result_of.h"
#include "tests/oracles/curved_trees.h"
#include "tests/scenes/seeds.h"

using namespace cnrg;
using Catch::Contains;

namespace {

using Index = FlatComplex::Index;

struct CurvedTriangles {
  std::vector<RationalPoint> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  explicit CurvedTriangles(const ResultView& view) {
    const FlatComplex flat = flatten(view);
    for (const VertexId v : flat.points) points.push_back(view.complex->points.rational(v));
    for (const auto& face : flat.faces)
      if (is_curved(face)) triangles.insert(triangles.end(), face.triangles.begin(), face.triangles.end());
  }
};

/// The square of the largest distance of corners and of some points between to what was given.
Rational farthest(const CurvedTriangles& from, const CurvedTriangles& given) {
  const DistanceTo distance(given.points, {}, {}, given.triangles);
  Rational most = 0;
  for (const auto& t : from.triangles) {
    for (int i = 0; i <= 3; ++i) {
      for (int j = 0; i + j <= 3; ++j) {
        RationalPoint p;
        for (std::size_t k = 0; k < 3; ++k)
          p[k] = (i * from.points[t[0]][k] + j * from.points[t[1]][k] + (3 - i - j) * from.points[t[2]][k]) / 3;
        most = std::max<Rational>(most, distance.squared(p));
      }
    }
  }
  return most;
}

}  // namespace

TEST_CASE("larger facets are within the distance of those that were given, and no cell is new or lost") {
  const auto [begin, end] = scenes::seeds(4);
  std::size_t before = 0, after = 0;
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    std::string nodes;
    for (const char* name : {"a", "b", "c"})
      nodes += std::string("  ") + name + ": {" + properties::random_curved_solid(8 * seed + nodes.size()) + "}\n";
    INFO("seed " << seed << "\n" << nodes);
    const Result given = result_of(nodes + "  model: {union: [a, b, c], dominance: left}\n");
    const CurvedTriangles then(given.data().view());
    for (const double within : {0.004, 0.05, 0.4}) {
      CoarsenReport report;
      const Result larger = coarsen(given, within, {.size = seed % 3 == 0 ? 0.5 : 0}, report);
      REQUIRE(active_counts(larger.cells()) == active_counts(given.cells()));
      REQUIRE(farthest(CurvedTriangles(larger.data().view()), then) <= from_double(within) * from_double(within));
      REQUIRE(report.after <= report.before);
      before += report.before, after += report.after;
    }
  }
  CHECK(5 * after < 4 * before);
}

TEST_CASE("facets stay where larger ones would cross, and where all is flat") {
  const auto coarser = [](const std::string& nodes, double within) {
    CoarsenReport report;
    const Result given = result_of(nodes), larger = coarsen(given, within, {}, report);
    CHECK(active_counts(larger.cells()) == active_counts(given.cells()));
    return report;
  };
  const CoarsenReport nested = coarser(
      "  a: {sphere: {center: [0, 0, 0], radius: 1, segments: 24}}\n"
      "  b: {sphere: {center: [0, 0, 0], radius: 1.001, segments: 24}}\n"
      "  c: {sphere: {center: [5, 0, 0], radius: 1, segments: 24}}\n"
      "  model: {union: [a, b, c], dominance: left}\n",
      0.1);
  CHECK(nested.after < nested.before);  // of c
  CHECK(coarser(kBlock, 1).after == 0);
  CHECK_THROWS_WITH(coarser("  model: {halfspace: {point: [0, 0, 0], normal: [0, 0, 1]}}\n", 1),
                    Contains("bounds"));
}
