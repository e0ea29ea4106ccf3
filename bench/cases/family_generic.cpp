// Two random polyhedra in general position.
#include "bench/cases/family_makers.h"
#include "bench/cases/perturbation.h"

namespace cnrg::bench {
namespace {

/// Of radius about 1, turned at random.
Model random_polyhedron(std::size_t faces, unsigned kind, Random& random) {
  Model model;
  switch (kind) {
    case 0: model = random_hull(faces, random); break;
    case 1: model = rough_sphere(faces, static_cast<unsigned>(random.integer(1, 1 << 20))); break;
    case 2: model = star_prism(std::max<std::size_t>(3, faces / 6), random); break;
    default: {
      const std::size_t corners = static_cast<std::size_t>(random.integer(3, 4));
      model = ring(std::max<std::size_t>(3, faces / corners), corners, random);
    }
  }
  return mapped(std::move(model), random_rotation(random));
}

/// Seeds 1 to 10 go through all pairs of two kinds.
Problem generic(const ProblemId& id) {
  constexpr std::array<std::array<unsigned, 2>, 10> kKinds{
      {{0, 1}, {2, 3}, {1, 1}, {3, 3}, {0, 2}, {1, 3}, {0, 0}, {2, 2}, {0, 3}, {1, 2}}};
  Random random = random_of(id);
  const auto [first, second] = kKinds[(id.seed + 9) % kKinds.size()];
  const auto faces = static_cast<std::size_t>(id.size);
  Model a = random_polyhedron(faces, first, random), b = random_polyhedron(faces, second, random);
  RationalPoint move;
  for (Rational& x : move) x = Rational((random.integer(0, 1) == 0 ? 1 : -1) * random.integer(200, 400)) / 1024;
  return problem_of(id, {std::move(a), mapped(std::move(b), translation(move))});
}

}  // namespace

std::vector<FamilyMaker> generic_families() { return {{"generic", kOperations, 8, 20000, false, generic}}; }

}  // namespace cnrg::bench
