// The convex hull of points in space.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

/// Facets, each as its corners (places in `points`), counter-clockwise from outside. The order of facets, and
/// where a facet's corners begin, are CGAL's. `points`: different ones, not all in one plane.
std::vector<std::vector<std::uint32_t>> convex_hull(std::span<const RationalPoint> points);

}  // namespace cnrg
