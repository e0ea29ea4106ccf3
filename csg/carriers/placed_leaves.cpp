// Leaves before a motion: transforms, and equations of their surfaces.
#include "csg/carriers/placed_leaves.h"

#include "csg/carriers/axes.h"

namespace cnrg {
namespace {

/// M' Q M of the matrix of the motion: the equation in what comes before it.
Quadric equation_before(const Transform& motion, const Quadric& q) {
  Quadric matrix{}, half{}, out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) matrix[i][j] = motion.linear[i][j];
    matrix[i][3] = motion.offset[i];
  }
  matrix[3][3] = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) half[i][j] += q[i][k] * matrix[k][j];
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) out[i][j] += matrix[k][i] * half[k][j];
    }
  }
  return out;
}

}  // namespace

PlacedLeaves before(const Transform& motion, const PlacedLeaves& placed) {
  const Transform back = motion.inverse();
  const Rational scale = stretch(back).value();
  PlacedLeaves out{{}, placed.surfaces, placed.equations};
  for (const LeafInstance& instance : placed.instances)
    out.instances.push_back({instance.leaf, back * instance.transform});
  for (auto& [number, quadric] : out.equations.quadrics) quadric = equation_before(motion, quadric);
  for (auto& [number, torus] : out.equations.tori) {
    torus.center = back.apply(torus.center);
    torus.axis = back.apply_to_vector(torus.axis);
    torus.radius *= scale;
    torus.tube *= scale;
  }
  return out;
}

}  // namespace cnrg
