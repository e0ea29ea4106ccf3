// A shaft of 32 facets is one of 32 facets for a mesh, whatever has cut or snapped it: counted, and by the angles
// of the surface mesh, which a line that is none would spoil.
#include "csg/mesh/planar_facets.h"

#include <set>

#include "csg/evaluate/evaluate.h"
#include "csg/mesh/surface_triangles.h"
#include "csg/result/join.h"
#include "csg/result/result_data.h"
#include "csg/result/snap.h"
#include "csg/tree/tree.h"
#include "tests/catch.h"

using namespace cnrg;

namespace {

Result shaft(const std::string& nodes) {
  return evaluate(
             parse_tree("cnrg: 1\nnodes:\n"
                        "  ground: {box: {min: [0, 0, 0], max: [30, 30, 30]}}\n"
                        "  tunnel: {cylinder: {from: [15, -1, 12], to: [15, 31, 12], radius: 4, segments: 32}}\n" +
                            nodes + "result: model\n",
                        "t.yaml"))
      .result();
}

/// Facets of curved faces.
std::size_t facets(const FlatComplex& flat) {
  std::size_t n = 0;
  for (const auto& face : flat.faces) n += face.facets.size();
  return n;
}

/// Loops and triangles of each facet have the same boundary: sides without one on their other side.
void check_loops(const FlatComplex& flat) {
  using Side = std::array<FlatComplex::Index, 2>;
  for (const auto& face : flat.faces) {
    FlatComplex::Index t = 0;
    REQUIRE(face.facet_ends.size() == face.facets.size());
    for (std::size_t k = 0; k < face.facets.size(); ++k) {
      std::multiset<Side> of_triangles, of_loops;
      const auto add = [](std::multiset<Side>& sides, const Side& side) {
        const auto opposite = sides.find({side[1], side[0]});
        if (opposite == sides.end()) sides.insert(side);
        else sides.erase(opposite);
      };
      for (; t < face.facet_ends[k]; ++t) {
        for (std::size_t i = 0; i < 3; ++i)
          add(of_triangles, {face.triangles[t][i], face.triangles[t][(i + 1) % 3]});
      }
      for (const auto& loop : face.facets[k].loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) add(of_loops, {loop[i], loop[(i + 1) % loop.size()]});
      }
      CHECK(of_triangles == of_loops);
    }
    if (!face.facets.empty()) CHECK(t == face.triangles.size());
  }
}

void check_angles(const Result& result) {
  for (const FaceTriangles& group : surface_triangles(result.data().view()).groups)
    CHECK(group.least_angle >= kLeastAngle);
}

}  // namespace

TEST_CASE("a snapped shaft keeps its facets in a mesh", "[mesh][facets]") {
  // The bolt begins in the shaft and passes its ridge by 1e-15. Of a turned shaft that is snapped no four corners
  // stay in one plane.
  const std::string turn = GENERATE("", ", rotate: {axis: [1, 2, 5], degrees: 89}");
  const Result result = shaft(
      "  bolt: {polyline: [[17.8284, 5, 14.8284], [20.6569, 5, 17.6569]]}\n"
      "  rock: {difference: [ground, tunnel]}\n"
      "  model: {union: [bolt, rock], dominance: left" +
      turn + "}\n");
  const Result joined = join(result, Rational(1, 1000)), snapped = snap(result);
  for (const Result* moved : {&joined, &snapped}) {
    const ResultView view = moved->data().view();
    REQUIRE(view.region_parts != nullptr);
    const FlatComplex flat = flatten_for_mesh(view);
    if (moved == &joined || turn.empty()) {
      CHECK(facets(flat) == 32);
    } else {
      CHECK(facets(flatten(view)) >= 64);  // triangles
      CHECK(facets(flat) < 40);            // those beside the bolt have moved farther
    }
    check_loops(flat);
    check_angles(*moved);
  }
}

TEST_CASE("edges of a joined result part facets in one plane", "[mesh][facets]") {
  // A wire runs along a facet, from its rim to its middle, and a sheet ends on others.
  const Result result = shaft(
      "  line: {polyline: [[19, 0, 12], [19, 25, 12]]}\n"
      "  across: {polygon: [[19, 13, 12], [25, 13, 12], [25, 13, 20], [15, 13, 20]]}\n"
      "  near: {polyline: [[10, 10, 25], [10, 10, 29.9999]]}\n"
      "  rock: {difference: [ground, tunnel]}\n"
      "  model: {union: [line, near, across, rock], dominance: left}\n");
  const Result joined = join(result, Rational(1, 1000));
  REQUIRE(joined.data().view().region_parts != nullptr);
  const FlatComplex whole = flatten(result.data().view()), flat = flatten_for_mesh(joined.data().view());
  CHECK(facets(flat) == facets(whole));
  CHECK(flat.edges.size() == whole.edges.size());
  check_loops(flat);
}
