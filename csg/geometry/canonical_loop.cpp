// A point may stand in a walk more than once: of the rotations that begin at the least one the least counts.
#include "csg/geometry/canonical_loop.h"

#include <algorithm>

namespace cnrg {

void rotate_to_least(PointLoop& loop) {
  if (loop.empty()) return;
  const std::uint32_t least = *std::min_element(loop.begin(), loop.end());
  std::size_t best = loop.size();
  const auto at = [&](std::size_t start, std::size_t i) { return loop[(start + i) % loop.size()]; };
  for (std::size_t s = 0; s < loop.size(); ++s) {
    if (loop[s] != least) continue;
    if (best == loop.size()) {
      best = s;
      continue;
    }
    for (std::size_t i = 1; i < loop.size(); ++i) {
      if (at(s, i) == at(best, i)) continue;
      if (at(s, i) < at(best, i)) best = s;
      break;
    }
  }
  std::rotate(loop.begin(), loop.begin() + std::ptrdiff_t(best), loop.end());
}

void put_in_order(std::vector<PointLoop>& loops) {
  for (PointLoop& loop : loops) rotate_to_least(loop);
  std::sort(loops.begin(), loops.end());
}

}  // namespace cnrg
