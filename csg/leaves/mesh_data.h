// A mesh as it is given, in a file or by arrays: points, polygons, lines; nothing merged, nothing judged.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/base/counts.h"
#include "kernel/exact/rational.h"

namespace cnrg {

/// Indices count from 0 and are in range, coordinates are finite.
struct MeshData {
  std::vector<double> xyz;                                     ///< nearest doubles, three for each point
  std::vector<std::pair<std::uint32_t, RationalPoint>> exact;  ///< points that are no doubles, by rising index
  std::vector<std::uint32_t> corners, offsets{0};  ///< polygon i: corners[offsets[i] .. offsets[i + 1]]
  std::vector<std::uint32_t> groups;               ///< of each polygon; empty: the file has none
  std::vector<std::array<std::uint32_t, 2>> wires;
  std::vector<std::uint32_t> points;  ///< isolated ones

  std::size_t point_count() const { return xyz.size() / 3; }
  std::size_t face_count() const { return offsets.size() - 1; }
  void end_face() { offsets.push_back(place32(corners.size(), "corners of faces")); }
};

}  // namespace cnrg
