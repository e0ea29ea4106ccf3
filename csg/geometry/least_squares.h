// The plane that fits points best, exactly.
#pragma once

#include <span>

#include "kernel/exact/rational.h"

namespace cnrg {

/// A normal of the plane through the mean of the points that has the least sum of squared distances, of all planes
/// that are near the one along `start`: distances are measured along `start`, which is off by the square of the
/// angle between both. A rotation of the points rotates it, their order is all the same. `start` where the points
/// lie on a line along it.
RationalPoint least_squares_normal(std::span<const RationalPoint> points, const RationalPoint& start);

}  // namespace cnrg
