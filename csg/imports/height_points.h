// Heights at scattered points.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace cnrg {

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
