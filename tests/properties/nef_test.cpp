// Random trees against Nef polyhedra: equal point sets at every node (csg/SEMANTICS.md#identities).
#include <exception>
#include <iostream>

#include "tests/catch.h"
#include "tests/oracles/scene_nef.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {
namespace {

using scenes::Position;
using scenes::Scene;

/// A failed comparison: what and where, in words; empty when all is well.
using Failure = std::string;

/// Trees on which Nef itself failed.
int oracle_failures = 0;

Failure scene_failure(const Scene& scene) {
  try {
    return compare_with_nef(scene);
  } catch (const OracleFailure&) {
    ++oracle_failures;
    return {};
  } catch (const std::exception& error) {
    return std::string("thrown: ") + error.what();
  }
}

/// Drops operands and parts while the scene still fails; the failure found last is returned with its scene.
std::pair<Scene, Failure> shrink_scene(Scene scene, Failure failure) {
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (Scene& candidate : scenes::smaller(scene)) {
      Failure f = scene_failure(candidate);
      if (f.empty()) continue;
      scene = std::move(candidate);
      failure = std::move(f);
      smaller = true;
      break;
    }
  }
  return {std::move(scene), std::move(failure)};
}

void run_scenes(Position position, std::uint64_t usual) {
  const auto [first, last] = scenes::seeds(usual);
  oracle_failures = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const Scene scene = scenes::random_scene(seed, 2 + static_cast<int>(seed % 4), position);
    Failure failure = scene_failure(scene);
    if (!failure.empty()) {
      const auto [least, why] = shrink_scene(scene, failure);
      FAIL_CHECK("seed " << seed << ": " << failure << "\nshrunk: " << why << "\n" << scenes::tree_file(least));
    } else {
      SUCCEED();
    }
  }
  INFO(oracle_failures << " trees on which Nef itself failed");
  CHECK(static_cast<std::uint64_t>(oracle_failures) <= 1 + (last - first) / 100);
}

}  // namespace

TEST_CASE("The oracle knows what it should", "[nef]") {
  const NefSet cube = NefSet::solid(scenes::box_solid({0, 0, 0}, {2, 2, 2}));
  CHECK(cube.volume() == 8);
  CHECK(cube.contains({1, 1, 1}));
  CHECK(cube.contains({2, 1, 1}));
  CHECK_FALSE(cube.contains({3, 1, 1}));
  Skeleton s = cube.skeleton();
  CHECK(s.vertices.size() == 8);
  CHECK(s.edges.size() == 12);
  CHECK(s.facets.size() == 6);
  CHECK(s.volumes == 2);
  // The facet below the cube has it above, the facet above has it below.
  for (const auto& f : s.facets) CHECK(f.above == (f.boundary.front()[0] == 0));
  const NefSet half = NefSet::solid(scenes::box_solid({0, 0, 0}, {1, 2, 2}));
  CHECK(cube.subtract(half).unite(half) == cube);
  CHECK_FALSE(cube.subtract(half) == half);
  // A sheet that touches itself in a vertex, with a slit into its inside.
  const NefSet bow = NefSet::polygon({{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}}});
  CHECK(bow.skeleton().facets.size() == 2);
  CHECK(NefSet::polygon({{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}}) ==
        NefSet::polygon({{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}}));
  // Filling: the walls of a box become the box.
  std::vector<NefSet> walls;
  for (const scenes::Polygon& facet : scenes::box_solid({0, 0, 0}, {2, 2, 2}))
    walls.push_back(NefSet::polygon({facet}));
  const NefSet hollow = NefSet::unite_all(walls);
  CHECK_FALSE(hollow == cube);
  CHECK(hollow.fill({{1, 1, 1}}) == cube);
  CHECK_FALSE(difference(hollow.skeleton(), cube.skeleton()).empty());
}

TEST_CASE("Point sets of trees in general position equal Nef's", "[nef]") { run_scenes(Position::general, 120); }
TEST_CASE("Point sets of degenerate trees equal Nef's", "[nef]") { run_scenes(Position::degenerate, 160); }
TEST_CASE("Point sets of degenerate trees off the axes equal Nef's", "[nef]") {
  run_scenes(Position::tilted, 120);
}

}  // namespace cnrg::properties
