// Regions of a group: the connected sets of its 3-cells.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/complex/complex.h"

namespace cnrg {

/// Numbers the connected sets of 3-cells `inside` (ascending) that no face of `walls` parts, from 1 in the order
/// of their smallest cells.
std::vector<std::pair<RegionId, std::uint32_t>> detect_regions(const Complex& complex,
                                                               const std::vector<RegionId>& inside,
                                                               const std::vector<FaceId>& walls);

}  // namespace cnrg
