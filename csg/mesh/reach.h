// How far points reach.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "kernel/refine/box.h"

namespace cnrg {

struct Reach {
  Box box;
  double largest = 0;  ///< of all coordinates, without signs

  explicit Reach(const std::vector<std::array<double, 3>>& points) {
    for (const auto& p : points) {
      box.extend(p, p);
      for (const double x : p) largest = std::max(largest, std::abs(x));
    }
  }
  /// Of the box; 0 where there are no points.
  double longest_side() const {
    return std::max({0.0, box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]});
  }
};

}  // namespace cnrg
