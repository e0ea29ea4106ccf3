// Pairs in general position: double, exact and the kernel, regularized, agree.
#include <cmath>
#include <iostream>

#include "bench/baseline/mantyla.h"
#include "bench/baseline/scene.h"
#include "bench/cases/shapes.h"
#include "tests/baseline/oracle.h"
#include "tests/baseline/shapes.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

namespace cnrg::bench::baseline_test {
namespace {

/// Coordinates are below 10 and volumes below 1000: 1e-9 is about a thousand roundings of either.
constexpr double kVolumeRounding = 1e-9;

bool same_counts(const Counts& counts, const Truth& truth) {
  return counts.vertices == truth.vertices && counts.edges == truth.edges && counts.faces == truth.faces &&
         counts.genus == truth.genus;
}

}  // namespace

TEST_CASE("random pairs in general position: double, exact and the kernel agree") {
  const auto [first, last] = scenes::seeds(1000);
  int meet = 0, rings = 0, handles = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    Random random(static_cast<unsigned>(seed));
    const Model a = random_solid(random), b = random_solid(random);
    for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract}) {
      INFO("seed " << seed << ", " << to_string(operation));
      const Model exact = mantyla::boolean_exact(a, b, operation);
      const Truth truth = truth_of(a, b, operation, exact);
      const Counts counts = counts_of(exact);
      CHECK(truth.same_set);
      CHECK(volume_of(exact) == truth.volume);
      CHECK(same_counts(counts, truth));
      const Model maximal = mantyla::evaluate<double>(a, b, operation, 1e-10);
      CHECK(counts_of(maximal) == counts);
      const Model rounded = mantyla::boolean_double(a, b, operation);
      CHECK(std::fabs(to_double(Rational(volume_of(rounded) - truth.volume))) < kVolumeRounding);
      const Counts triangles = counts_of(rounded);
      CHECK(triangles.vertices == counts.vertices);
      CHECK(triangles.genus == counts.genus);
      if (operation == Operation::intersect && truth.faces > 0) ++meet;
      if (counts.rings > 0) ++rings;
      if (counts.genus > 1) ++handles;
    }
  }
  std::cout << "general position: seeds " << first << " to " << last - 1 << ", " << meet << " pairs meet; "
            << rings << " results with rings, " << handles << " with two handles or more\n";
  if (last - first >= 1000) {
    CHECK(meet > 400);
    CHECK(rings > 100);
    CHECK(handles > 100);
  }
}

TEST_CASE("triangle meshes in general position") {
  const auto [first, last] = scenes::seeds(6);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const Model a = model_of(bumpy_sphere(200, static_cast<unsigned>(seed + 1)));
    const Model b = model_of(moved(bumpy_sphere(200, static_cast<unsigned>(seed + 1001)), {0.31, 0.22, 0.17}));
    for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract}) {
      INFO("seed " << seed << ", " << to_string(operation));
      const Model exact = mantyla::boolean_exact(a, b, operation);
      const Truth truth = truth_of(a, b, operation, exact);
      CHECK(truth.same_set);
      CHECK(same_counts(counts_of(exact), truth));
      const Model rounded = mantyla::boolean_double(a, b, operation);
      CHECK(std::fabs(to_double(Rational(volume_of(rounded) - truth.volume))) < kVolumeRounding);
    }
  }
}

}  // namespace cnrg::bench::baseline_test
