// Axis-parallel boxes.
#pragma once

#include <array>
#include <vector>

#include "kernel/base/limits.h"

namespace cnrg {

struct Box {
  std::array<double, 3> lo{kInfinity, kInfinity, kInfinity};
  std::array<double, 3> hi{-kInfinity, -kInfinity, -kInfinity};
  void extend(const Box& b) {
    for (int k = 0; k < 3; ++k) {
      lo[k] = b.lo[k] < lo[k] ? b.lo[k] : lo[k];
      hi[k] = b.hi[k] > hi[k] ? b.hi[k] : hi[k];
    }
  }
  void extend(const std::array<double, 3>& l, const std::array<double, 3>& h) {
    for (int k = 0; k < 3; ++k) {
      lo[k] = l[k] < lo[k] ? l[k] : lo[k];
      hi[k] = h[k] > hi[k] ? h[k] : hi[k];
    }
  }
  /// Closed boxes: a common boundary point counts.
  bool meets(const Box& b) const {
    return lo[0] <= b.hi[0] && b.lo[0] <= hi[0] && lo[1] <= b.hi[1] && b.lo[1] <= hi[1] && lo[2] <= b.hi[2] &&
           b.lo[2] <= hi[2];
  }
  /// Closed boxes, too.
  bool inside(const Box& b) const {
    return b.lo[0] <= lo[0] && hi[0] <= b.hi[0] && b.lo[1] <= lo[1] && hi[1] <= b.hi[1] && b.lo[2] <= lo[2] &&
           hi[2] <= b.hi[2];
  }
};

/// The smallest box around all.
inline Box bounds(const std::vector<Box>& boxes) {
  Box all;
  for (const Box& b : boxes) all.extend(b);
  return all;
}

}  // namespace cnrg
