// Many solids: sponges, boxes, spheres, and Booleans one after the other.
#include <algorithm>

#include "bench/cases/case.h"
#include "bench/cases/family_makers.h"
#include "bench/cases/perturbation.h"

namespace cnrg::bench {
namespace {

/// Of the cube that `iterated` works in.
constexpr int kSide = 96;

Problem problem_of_case(const ProblemId& id, const Case& c) {
  const AffineMap place = placement(id);
  std::vector<Model> operands;
  for (const TriangleMesh& mesh : c.leaves) operands.push_back(mapped(model_of(mesh), place));
  return problem_of(id, std::move(operands));
}

Problem sponge(const ProblemId& id) { return problem_of_case(id, menger(static_cast<int>(id.size))); }

Problem boxes(const ProblemId& id) {
  std::vector<Model> operands;
  for (const IntegerBox& box : random_boxes(static_cast<int>(id.size), id.seed))
    operands.push_back(model_of(box_mesh(box)));
  return problem_of(id, std::move(operands));
}

/// Each of about 128 triangles, overlapping the next ones.
Problem spheres(const ProblemId& id) {
  std::vector<Model> operands;
  Random random = random_of(id);
  const Rational step(8, 5);
  for (int x = 0; x < id.size; ++x)
    for (int y = 0; y < id.size; ++y)
      for (int z = 0; z < id.size; ++z)
        operands.push_back(mapped(rough_sphere(128, static_cast<unsigned>(random.integer(1, 1 << 20))),
                                  translation({x * step, y * step, z * step})));
  return problem_of(id, std::move(operands));
}

/// A box or a tetrahedron, integer coordinates from 0 to kSide, about 12 wide.
Model small_solid(Random& random) {
  RationalPoint low;
  for (Rational& x : low) x = random.integer(0, kSide - 16);
  const auto corner = [&](bool x, bool y, bool z) {
    RationalPoint p = low;
    const std::array<bool, 3> far{x, y, z};
    for (int k = 0; k < 3; ++k) p[k] += far[k] ? random.integer(11, 16) : random.integer(0, 3);
    return p;
  };
  const RationalPoint first = corner(false, false, false);
  if (random.integer(0, 1) == 0) return box_between(first, corner(true, true, true));
  // Every other corner of a box, each moved a little: never in a plane.
  const RationalPoint a = corner(true, true, false), b = corner(true, false, true), c = corner(false, true, true);
  return tetrahedron({first, a, b, c});
}

/// All of [0, kSide]^3 but what a plane takes off one of its corners.
Model all_but_a_corner(Random& random) {
  // Three corners of the tetrahedron are far out, so that three of its planes are outside of the cube.
  const auto far = [&] { return random.integer(5 * kSide / 2, 11 * kSide / 4); };
  std::array<RationalPoint, 4> corners;
  corners.fill({-1, -1, -1});
  for (int k = 0; k < 3; ++k) corners[static_cast<std::size_t>(k)][k] = far();
  Model model = tetrahedron(corners);
  AffineMap mirror;
  for (int k = 0; k < 3; ++k) {
    if (random.integer(0, 1) == 0) continue;
    mirror.rows[k][k] = -1;
    mirror.move[k] = kSide;
  }
  return mapped(std::move(model), mirror);
}

/// Starts with a cube. Each step writes over a place in the same space, so that the result has a bounded number of
/// faces: half of the steps unite, two of five subtract, one of ten cuts a corner off.
Problem iterated(const ProblemId& id) {
  Random random = random_of(id);
  Problem problem;
  problem.operands.push_back(box_between({8, 8, 8}, {kSide - 8, kSide - 8, kSide - 8}));
  for (long i = 0; i < id.size; ++i) {
    const int choice = random.integer(0, 9);
    problem.steps.push_back(choice < 5   ? Operation::unite
                            : choice < 9 ? Operation::subtract
                                         : Operation::intersect);
    problem.operands.push_back(choice < 9 ? small_solid(random) : all_but_a_corner(random));
  }
  return problem;
}

}  // namespace

std::vector<FamilyMaker> fold_families() {
  return {{"menger", {"difference"}, 1, 4, false, sponge},
          {"boxes", {"union"}, 2, 10000, false, boxes},
          {"spheres", {"union"}, 2, 20, false, spheres},
          {"iterated", {"fold"}, 1, 100000, false, iterated}};
}

}  // namespace cnrg::bench
