// Tetrahedra in doubles that conform to planes and lines: the mesh that meshers return and that is improved.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace cnrg {

struct ConformingTetrahedra {
  using Index = std::uint32_t;
  using Point = std::array<double, 3>;
  std::vector<Point> points;
  std::vector<std::array<Index, 4>> tetrahedra;  ///< det(b - a, c - a, d - a) > 0
  std::vector<std::int32_t> region;  ///< of each tetrahedron; negative: none, its shape is nobody's care
  /// Faces of tetrahedra that are pieces of planar facets, and the number of the facet, from 0: where two
  /// triangles of one facet share a side that is no segment, the side may give way to another one.
  std::vector<std::array<Index, 3>> triangles;
  std::vector<std::int32_t> facet;
  /// Edges of tetrahedra that are pieces of lines, and the number of the line, from 0.
  std::vector<std::array<Index, 2>> segments;
  std::vector<std::int32_t> line;
};

}  // namespace cnrg
