// Affine maps in doubles, by which files place what they hold.
#pragma once

#include <array>

#include "csg/leaves/mesh_data.h"

namespace cnrg {

using Affine = std::array<std::array<double, 4>, 3>;  ///< rows

inline constexpr Affine kInPlace{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

/// First `b`, then `a`.
inline Affine product(const Affine& a, const Affine& b) {
  Affine out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j)
      out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j] + (j == 3 ? a[i][3] : 0);
  }
  return out;
}

inline void add_point(MeshData& mesh, const Affine& place, const std::array<double, 3>& p) {
  for (const auto& row : place) mesh.xyz.push_back(row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3]);
}

}  // namespace cnrg
