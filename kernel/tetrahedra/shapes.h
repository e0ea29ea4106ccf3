// Measures of one tetrahedron, by its corners in any order.
#pragma once

#include <array>

namespace cnrg {

using CornerPoint = std::array<double, 3>;

/// Its volume.
double volume_of(const CornerPoint& a, const CornerPoint& b, const CornerPoint& c, const CornerPoint& d);

struct LongestEdge {
  double length;
  CornerPoint middle;
};
LongestEdge longest_edge_of(const CornerPoint& a, const CornerPoint& b, const CornerPoint& c,
                            const CornerPoint& d);

/// The ratio of circumradius to shortest edge: sqrt(6) / 4 of a regular tetrahedron, large where edges differ
/// much.
double radius_edge_of(const CornerPoint& a, const CornerPoint& b, const CornerPoint& c, const CornerPoint& d);

/// Is it flatter than 1/64 of its longest edge? Where walls are so near to each other, edges that are as short
/// would be many.
bool is_flat(const CornerPoint& a, const CornerPoint& b, const CornerPoint& c, const CornerPoint& d);

/// The shape of a tetrahedron: 12 (3 V)^(2/3) / (sum of squared edges) (liu1994): 1 of a regular one, 0 of a flat
/// one.
double shape_of(const CornerPoint& a, const CornerPoint& b, const CornerPoint& c, const CornerPoint& d);

}  // namespace cnrg
