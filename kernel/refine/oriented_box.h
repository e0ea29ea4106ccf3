// Boxes with axes of their own, for what is long and lies obliquely.
//
// The axis-parallel boxes of a thousand narrow strips, side by side and turned, all meet each other. Boxes that
// are turned with the strips do not: they are as narrow as the strips, and a plane parts those of any two.
//
// Bounds. Let u = 2^-53. Axes are unit vectors, orthogonal up to 1e-15 (two rounds of Gram and Schmidt). Distances
// along an axis are rounded sums of three products with differences to the centre, which is exact as it stands:
// the error is below 8 u times the sum of the absolute differences, `half` has 1e-14 of it added. That the axes
// are not quite orthogonal costs as little. `apart` demands a gap of 1e-12 of all lengths that enter, far above
// both, and of 1e-300, above all that can underflow. What is not finite parts nothing.
#pragma once

#include <array>
#include <vector>

#include "kernel/refine/box.h"

namespace cnrg {

using Axes = std::array<std::array<double, 3>, 3>;

/// All points whose distance to the centre along each axis is at most `half`.
struct OrientedBox {
  std::array<double, 3> center{};
  Axes axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::array<double, 3> half{};
};

/// The box itself; never empty.
OrientedBox upright(const Box& box);
/// Holds all points, given by boxes around them, of which there is one at least; the first axis looks along their
/// longest extent, the second along the longest across it.
OrientedBox oriented_around(const std::vector<Box>& points);
/// Holds both; with the axes of the one that is longer along its first axis.
OrientedBox around(const OrientedBox& a, const OrientedBox& b);
/// True only if they have no point in common.
bool apart(const OrientedBox& a, const OrientedBox& b);

}  // namespace cnrg
