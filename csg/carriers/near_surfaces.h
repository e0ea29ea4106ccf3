// Surfaces of two leaves that are nearly one and are not: 1 and 1 + 1e-12 are different radii, and the result has
// a gap or an overlap as thin as that. It is exact, and mostly not what was meant, so it is worth a word.
#pragma once

#include <string>
#include <vector>

#include "csg/carriers/axes.h"
#include "csg/leaves/leaf.h"

namespace cnrg {

struct NearSurfaces {
  std::uint32_t first = 0, second = 0;  ///< instances, first < second
  std::string what;                     ///< `cylinders`, `cones`, `spheres`
  double apart = 0;                     ///< the largest distance, in the model's unit, greater than 0
};

/// True if meridians about the same axis have more than points of it in common.
bool touch(const PlacedForm& a, const PlacedForm& b);
/// True if a side of a cylinder or cone is beside one of the other, about the same axis, nearer than a part of its
/// radius.
bool sides_near(const PlacedForm& a, const PlacedForm& b, double near);

/// For pairs of instances, in the order of `pairs`: the farthest of their surfaces that are nearer to each other
/// than a millionth of their radius, and not one. Surfaces of leaves that are stretched otherwise than by one
/// number are not looked at.
std::vector<NearSurfaces> near_surfaces(const std::vector<LeafInstance>& instances,
                                        const std::vector<std::array<std::uint32_t, 2>>& pairs);

}  // namespace cnrg
