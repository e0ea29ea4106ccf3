// ESRI ASCII grids.
#pragma once

#include <string>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

/// Heights on a regular grid of points. Rows run along y upwards, entries of a row along x.
struct HeightGrid {
  Rational origin_x = 0, origin_y = 0, spacing_x = 1, spacing_y = 1;  ///< of the first point
  std::size_t columns = 0, rows = 0;
  std::vector<double> heights;  ///< of point (i, j) at j * columns + i
  std::vector<bool> missing;    ///< NODATA there; empty if nowhere
};

/// Reads an ESRI ASCII grid: ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize (or dx and
/// dy), NODATA_value, in any order and case, then the rows from north to south. A value belongs to the centre of
/// its cell: with xllcorner the first point lies half a cell inside. Throws as `read_mesh` does.
HeightGrid read_height_grid(const std::string& path, const std::string& inside = {});

}  // namespace cnrg
