// Faces that are equal, as walls are that many leaves share.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/refine/input.h"

namespace cnrg {

/// Faces with the same sides are one point set: whatever the first of them meets, all meet.
struct EqualFaces {
  std::vector<std::pair<SourceId, SourceId>> pairs;  ///< the first of equal faces, and each other one
  /// By face: how many are equal to it, with itself; 0 for all but the first of them. Empty if no two are equal.
  std::vector<std::uint32_t> copies;
};

/// Leaves out two equal faces that no third face touches along a side.
EqualFaces equal_faces(const RefineInput& in);

}  // namespace cnrg
