// A height field on fewer points: a surface that nowhere leaves the bound around the one over all points.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

/// Heights by rows along y, entries along x; at least 2 by 2. Cells are cut by the diagonal from the first corner
/// to the opposite one.
struct HeightTable {
  std::size_t columns = 0, rows = 0;
  std::vector<Rational> heights;  ///< of point (i, j) at j * columns + i
};

/// Triangles between points of the table, counter-clockwise, by places in it, and the largest deviation: how far
/// the surface is above or below that of the table at most, rounded up.
struct CoarseSurface {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  double deviation = 0;
};

/// A surface with no deviation above `within` (units, above 0), exactly.
CoarseSurface coarse_surface(const HeightTable& table, const Rational& within);

}  // namespace cnrg
