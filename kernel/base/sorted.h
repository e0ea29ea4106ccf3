// Lists as sets: ascending, each element once.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace cnrg {

template <class T>
void sort_unique(std::vector<T>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// What is in both of two such lists, in one of them at least, in the first one alone.
template <class A, class B>
auto in_common(const A& a, const B& b) {
  std::vector<std::ranges::range_value_t<A>> out;
  std::ranges::set_intersection(a, b, std::back_inserter(out));
  return out;
}
template <class A, class B>
auto in_either(const A& a, const B& b) {
  std::vector<std::ranges::range_value_t<A>> out;
  std::ranges::set_union(a, b, std::back_inserter(out));
  return out;
}
template <class A, class B>
auto in_first_alone(const A& a, const B& b) {
  std::vector<std::ranges::range_value_t<A>> out;
  std::ranges::set_difference(a, b, std::back_inserter(out));
  return out;
}

/// The value of a key in a list of pairs that ascends by keys; nullptr: it has none.
template <class Key, class T>
const T* value_of_key(const std::vector<std::pair<Key, T>>& list, const std::type_identity_t<Key>& key) {
  const auto it = std::ranges::lower_bound(list, key, {}, &std::pair<Key, T>::first);
  return it != list.end() && it->first == key ? &it->second : nullptr;
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
