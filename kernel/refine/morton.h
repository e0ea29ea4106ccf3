// Boxes on an integer grid, and their order along a space-filling curve (Morton 1966).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/refine/box.h"

namespace cnrg {

/// A map from the coordinates of boxes to integers of 30 bits that never decreases.
class Grid {
 public:
  Grid() = default;
  /// `all`: what the boxes lie in.
  explicit Grid(const Box& all);
  std::int32_t operator()(double x, std::size_t axis) const {
    const double t = (x / 2 - origin_[axis]) * scale_[axis];
    if (!(t > 0)) return 0;
    return t < kLast ? static_cast<std::int32_t>(t) : static_cast<std::int32_t>(kLast);
  }

 private:
  static constexpr double kLast = 0x1p30 - 1;
  std::array<double, 3> origin_{}, scale_{};
};

/// The numbers of the boxes in the order of their middles along the curve; equal ones by number.
std::vector<std::uint32_t> morton_order(const std::vector<Box>& boxes, const Grid& grid);

}  // namespace cnrg
