// Closed walks of numbered points in a form of their own: whoever has the same walks writes the same lists.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cnrg {

/// Rotates a cyclic list to its lexicographically least form. A point may stand in a walk more than once: of the
/// rotations that begin at the least one the least counts.
template <class Loop>
void rotate_to_least(Loop& loop) {
  if (loop.empty()) return;
  const auto least = *std::min_element(loop.begin(), loop.end());
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
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(best), loop.end());
}

/// Outer loop first (of a planar face it is the one with the least point), then the others in order.
template <class Loop>
void put_in_order(std::vector<Loop>& loops) {
  for (Loop& loop : loops) rotate_to_least(loop);
  if (loops.size() > 1) std::sort(loops.begin(), loops.end());
}

}  // namespace cnrg
