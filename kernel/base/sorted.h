// Lists as sets: ascending, each element once.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cnrg {

template <class T>
void sort_unique(std::vector<T>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// The corners of a simplex in an order that all who have them agree on.
template <class T, std::size_t N>
std::array<T, N> sorted(std::array<T, N> corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// The two points of an edge in one number, in whichever order they come.
inline std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
}

}  // namespace cnrg
