// Which crossings of curved patches are proven to be those of the surfaces, and what is said of the others.
#include "csg/evaluate/transversality.h"

#include <cmath>

#include "csg/curves/surface_placed.h"
#include "csg/evaluate/certify.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;

struct Examined {
  Tree tree;
  Evaluation evaluation;
  Transversality found;
  /// `leaves`: lines of a map of nodes a, b and perhaps c.
  explicit Examined(const std::string& leaves, int finer = 1, const std::string& operands = "a, b")
      : tree(
            parse_tree("cnrg: 1\nnodes:\n" + leaves + "  r: {union: [" + operands + "]}\nresult: r\n", "t.yaml")) {
    make_finer(tree, finer);
    evaluation = evaluate(tree);
    found = transversality(*evaluation.complex, *evaluation.parameters, 10);
  }
};

std::string pipe_over_slab(const std::string& height, const std::string& segments = "32") {
  return "  a: {cylinder: {from: [-4, 0, " + height + "], to: [4, 0, " + height +
         "], radius: 1, segments: " + segments + "}}\n  b: {box: {min: [-5, -5, -1], max: [5, 5, 0]}}\n";
}

TEST_CASE("surfaces that cross at a good angle are proven to", "[evaluate][certify]") {
  // A drill through a shaft; balls and a ring, oblique; a pipe half in a slab.
  for (const std::string& leaves :
       {std::string("  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 2}}\n"
                    "  b: {cylinder: {from: [-5, 0.3, 2], to: [5, 0.3, 2], radius: 0.7}}\n"),
        std::string("  a: {sphere: {center: [0, 0, 0], radius: 1}}\n"
                    "  b: {sphere: {center: [1.5, 0.1, 0.05], radius: 1}}\n"),
        std::string(
            "  a: {sphere: {center: [0, 0, 0], radius: 1}}\n"
            "  b: {torus: {center: [1, 0, 0], axis: [1, 2, 3], radius: 1, tube: 0.3}, scale: [1, 1.2, 1]}\n"),
        pipe_over_slab("0.3", "31")}) {
    INFO(leaves);
    const Examined e(leaves);
    CHECK(e.found.edges > 0);
    CHECK(e.found.places.empty());
    const Certificate certificate = certify(e.tree, e.evaluation);
    CHECK(certificate.places == 0);
    CHECK(certificate.notices.empty());
    CHECK(certificate.edges == e.found.edges);
  }
}

TEST_CASE("an uncertain crossing is told with the fineness that decides it, and decided there",
          "[evaluate][certify]") {
  const Examined coarse(pipe_over_slab("0.999"));
  REQUIRE(coarse.found.places.size() == 2);
  for (const UncertainPlace& place : coarse.found.places) {
    CHECK(place.edges.size() == 1);
    CHECK(place.patches[0] == 2);
    CHECK(std::abs(place.at[1]) < 0.1);
    CHECK(std::abs(place.at[2]) < 0.01);
    REQUIRE(place.finer == 8);
  }
  CHECK(Examined(pipe_over_slab("0.999"), 4).found.places.size() == 2);
  CHECK(Examined(pipe_over_slab("0.999"), 8).found.places.empty());

  const Certificate certificate = certify(coarse.tree, coarse.evaluation);
  CHECK(certificate.places == 2);
  REQUIRE(certificate.notices.size() == 2);
  const std::string text = certificate.notices[0].text();
  CHECK_THAT(text, Catch::StartsWith("t.yaml:3:7: notice: `a` (cylinder side) and `b` meet near ["));
  CHECK_THAT(text, Contains("--finer 8 would"));
  CHECK(certify(coarse.tree, coarse.evaluation, 1).notices.size() == 1);
  CHECK(certify(coarse.tree, coarse.evaluation, 1).places == 2);
}

TEST_CASE("where surfaces touch, no fineness decides", "[evaluate][certify]") {
  // Equal pipes at right angles touch in two points, in each of which their curves of crossing cross.
  const Examined pipes(
      "  a: {cylinder: {from: [0, 0, -4], to: [0, 0, 4], radius: 2}}\n"
      "  b: {cylinder: {from: [-5, 0, 0], to: [5, 0, 0], radius: 2}}\n");
  REQUIRE(pipes.found.places.size() == 2);
  for (const UncertainPlace& place : pipes.found.places) {
    CHECK(place.finer == 0);
    CHECK(std::abs(std::abs(place.at[1]) - 2) < 1e-3);
    CHECK(std::abs(place.at[0]) < 0.05);
    CHECK(std::abs(place.at[2]) < 0.05);
  }
  CHECK_THAT(certify(pipes.tree, pipes.evaluation).notices[0].message,
             Contains("they touch, or cross at an angle"));
}

TEST_CASE("of papers/keyser2004 all is certain but for the crossing cylinders, which touch",
          "[evaluate][certify]") {
  Tree tree = read_tree("papers/keyser2004/chords.yaml");
  for (const char* name : {"ring_10", "ring_60", "touch_10", "touch_60", "steinmetz_10", "steinmetz_60"}) {
    INFO(name);
    tree.result = tree.find(name);
    const Evaluation evaluation = evaluate(tree);
    const Transversality found = transversality(*evaluation.complex, *evaluation.parameters, 10);
    CHECK(found.edges > 0);
    CHECK(found.places.size() == (name[0] == 's' ? 8 : 0));
    for (const UncertainPlace& place : found.places) CHECK(place.finer == 0);
  }
}

TEST_CASE("transforms move normals as they move surfaces", "[evaluate][certify]") {
  // A ball scaled to a thin lens, cut by a slab near its rim and near its flat middle.
  const auto lens = [](const char* low, const char* more) {
    return std::string("  a: {sphere: {center: [0, 0, 0], radius: 1, segments: 48}, scale: [1, 1, 0.01]") + more +
           "}\n  b: {box: {min: [-5, -5, " + low + "], max: [5, 5, 5]}" + more + "}\n";
  };
  const char* const turned = ", rotate: {axis: [1, 2, 3], degrees: 20}";
  for (const char* more : {"", turned}) {
    CHECK(Examined(lens("1/300", more)).found.places.empty());
    const Examined flat(lens("0.00999", more));
    CHECK(!flat.found.places.empty());
  }
}

TEST_CASE("leaves that are drawn on common lines have their true surfaces", "[evaluate][certify]") {
  const std::string bored =
      "  a: {difference: [{box: {min: [-3, -3, 0], max: [3, 3, 2]}}, "
      "{cylinder: {from: [0, 0, -1], to: [0, 0, 3], radius: 1, segments: 24}}]}\n"
      "  b: {cylinder: {from: [0, 0, 2], to: [0, 0, 0], radius: 1}, rotate: {axis: [0, 0, 1], degrees: 10}}\n";
  const std::string balls =
      "  a: {sphere: {center: [1, 0, 0], radius: 1}}\n"
      "  b: {sphere: {center: [1, 0, 0], radius: 1, segments: 24}, rotate: {axis: [1, 2, 3], degrees: 10, "
      "center: [1, 0, 0]}}\n";
  const std::string capped =
      "  a: {sphere: {center: [0, 0, 0], radius: 5}, translate: [1, 2, 3]}\n"
      "  b: {cylinder: {from: [0, 0, 0], to: [3, 0, 6], radius: 5}, translate: [1, 2, 3]}\n";
  const std::string mirrored =
      "  a: {torus: {center: [0, 0, 0], axis: [1, 1, 1], radius: 3, tube: 1}}\n"
      "  b: {torus: {center: [0, 0, 0], axis: [1, 1, 1], radius: 3, tube: 1, segments: 20}, "
      "mirror: {normal: [1, 0, 0], point: [0, 0, 0]}, rotate: {axis: [0, 1, -1], degrees: 12}}\n";
  // A patch and a part of it, elevated and turned round; an extrusion of arcs around a shaft; two extrusions.
  const std::string patches =
      "  a: {bezier: {patch: [[[0, 0, 0], [1, 0, 2], [2, 0, 0]], [[0, 2, 1], [1, 2, 0], [2, 2, 3]]], segments: "
      "6}, "
      "translate: [1, 2, 3]}\n"
      "  b: {bezier: {patch: [[[2, 2, 3], [1, 2, 0], [0, 2, 1]], [[2, 0, 0], [1, 0, 2], [0, 0, 0]]], segments: "
      "8}, "
      "translate: [1, 2, 3]}\n";
  const std::string pipe =
      "  a: {extrude: {profile: [[1, 0, 0], {bezier: [[1, 1, 0]], weights: [1, 1, 2]}, [0, 1, 0], {bezier: [[-1, "
      "1, 0]], "
      "weights: [2, 1, 1]}, [-1, 0, 0], [0, -1, 0]], vector: [0, 0, 2]}, rotate: {axis: [0, 0, 1], degrees: 20}}\n"
      "  b: {cylinder: {from: [0, 0, 1], to: [0, 0, 4], radius: 1, segments: 20}}\n";
  const std::string walls =
      "  a: {extrude: {curve: [[0, 0, 0], {bezier: [[1, 2, 0], [3, -1, 0]]}, [4, 0, 0]], vector: [0, 0, 2]}}\n"
      "  b: {extrude: {curve: [[4, 0, 1], {bezier: [[3, -1, 1], [1, 2, 1]]}, [0, 0, 1]], vector: [0, 0, 2], "
      "segments: 9}}\n";
  for (const std::string& leaves : {bored, balls, capped, mirrored, patches, pipe, walls}) {
    INFO(leaves);
    const Examined e(leaves);
    const Complex& complex = *e.evaluation.complex;
    const SurfaceParameters& parameters = *e.evaluation.parameters;
    std::size_t corners = 0;
    for (const SourceId s : IdRange<SourceId>(complex.sources.size())) {
      const Soup::Face& face = complex.sources[s];
      const PlacedSurface surface(parameters.surfaces(face.leaf), face.patch, parameters.transform(face.leaf));
      if (surface.flat()) continue;
      for (const auto& cell : parameters.cells(s)) {
        for (const PatchCorner& corner : cell) {
          ++corners;
          const RationalPoint p = parameters.transform(face.leaf).apply(corner.point);
          const Vector3<double> q = surface.at(to_double(corner.at[0]), to_double(corner.at[1])).point;
          for (std::size_t k = 0; k < 3; ++k) REQUIRE(std::abs(q[k] - to_double(p[k])) < 1e-11);
        }
      }
    }
    CHECK(corners > 40);
  }
}

TEST_CASE("contacts that both tessellations contain are certain", "[evaluate][certify]") {
  // The same shaft twice, one longer: they share facets. A patch that is a plane. Two boxes have nothing curved.
  CHECK(Examined("  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 2}}\n"
                 "  b: {cylinder: {from: [0, 0, 1], to: [0, 0, 5], radius: 2}}\n")
            .found.places.empty());
  const Examined flat(
      "  a: {extrude: {profile: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], vector: [0, 0, 1]}}\n"
      "  b: {box: {min: [0, 0, 0], max: [2, 2, 1]}}\n");
  CHECK(flat.found.edges == 0);
  CHECK(Examined("  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n  b: {box: {min: [0, 0, 0], max: [2, 2, 1]}}\n")
            .found.edges == 0);
  // A pipe on a slab: the line of contact is an edge of its facets.
  CHECK(Examined(pipe_over_slab("1")).found.places.empty());
  // A ball in a pipe of its radius: the circle of contact is in both.
  const std::string contact =
      "  a: {sphere: {center: [0, 0, 0], radius: 2}}\n"
      "  b: {cylinder: {from: [0, 0, -3], to: [0, 0, 3], radius: 2, segments: 24}}\n";
  CHECK(Examined(contact).found.places.empty());
  // But a facet that happens to lie in a face is none of the surface.
  const Examined inscribed(
      "  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 1], radius: 5, segments: 4}}\n"
      "  b: {polygon: [[10, -5, 0], [-5, 10, 0], [-5, 10, 1], [10, -5, 1]]}\n");
  REQUIRE(inscribed.found.places.size() == 1);
  CHECK(inscribed.found.places[0].finer == 4);
}

}  // namespace
}  // namespace cnrg
