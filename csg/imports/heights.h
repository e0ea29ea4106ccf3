// Heights in files: ESRI ASCII grids, and scattered points.
#pragma once

#include <array>
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

/// Heights at scattered points.
struct HeightPoints {
  std::vector<std::array<double, 3>> points;  ///< no two of them have the same x and y
  std::size_t repeated = 0;                   ///< lines that gave a point once more
};

/// True if the file's extension says that it holds points (.xyz, in any case).
bool holds_height_points(const std::string& path);

/// Reads a file of lines `x y z`: numbers with blanks between them, what follows in the line is skipped, `#`
/// begins a comment. Throws as `read_mesh` does; two heights at one place are a fault.
HeightPoints read_height_points(const std::string& path, const std::string& inside = {});

}  // namespace cnrg
