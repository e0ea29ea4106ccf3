// A cube and the same cube turned about an axis through its middle by less and less.
#include "bench/cases/family_makers.h"
#include "bench/cases/perturbation.h"

namespace cnrg::bench {
namespace {

/// Of length 1 exactly; a coordinate axis for seed 1.
RationalPoint axis_of(unsigned seed) {
  if (seed == 1) return {0, 0, 1};
  constexpr std::array<std::array<int, 4>, 6> kAxes{
      // the last number is the length of the first three
      {{2, 3, 6, 7}, {1, 4, 8, 9}, {2, 6, 9, 11}, {6, 10, 15, 19}, {3, 4, 12, 13}, {2, 5, 14, 15}}};
  const auto& quadruple = kAxes[seed % kAxes.size()];
  Random random(seed);
  RationalPoint axis;
  const int first = random.integer(0, 2);
  for (int k = 0; k < 3; ++k) {
    axis[k] = Rational(quadruple[(first + k) % 3]) / quadruple[3];
    if (random.integer(0, 1) == 0) axis[k] = -axis[k];
  }
  return axis;
}

/// By 2 atan(10^-k / 2), which is 10^-k but for a part of 10^-2k / 12.
Problem turned_cube(const ProblemId& id) {
  const Rational half(1, 2);
  const Model cube = box_between({-half, -half, -half}, {half, half, half});
  Model other = cube;
  if (id.distance) {
    const RationalPoint axis = axis_of(id.seed);
    other = mapped(other, rotation({2 / power_of_tenth(*id.distance), axis[0], axis[1], axis[2]}));
  }
  const AffineMap place = placement(id);
  return problem_of(id, {mapped(cube, place), mapped(std::move(other), place)});
}

Problem turned_mesh(const ProblemId& id) {
  Problem problem = turned_cube(id);
  for (Model& model : problem.operands) {
    TriangleMesh mesh = rounded_mesh(model);
    mesh.polygons.clear();
    model = model_of(mesh);
  }
  return problem;
}

}  // namespace

std::vector<FamilyMaker> turned_families() {
  return {{"turned", kOperations, 1, 1, true, turned_cube}, {"turned-mesh", kOperations, 1, 1, true, turned_mesh}};
}

}  // namespace cnrg::bench
