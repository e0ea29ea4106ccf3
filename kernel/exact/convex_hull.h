// The convex hull of points in space.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

/// Facets, one of each plane, ascending: their corners (places in `points`) from the least on, counter-clockwise
/// from outside. `points`: different ones, not all in one plane.
std::vector<std::vector<std::uint32_t>> convex_hull(std::span<const RationalPoint> points);

}  // namespace cnrg
