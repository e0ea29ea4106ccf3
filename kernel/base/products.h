// Products of vectors of any numbers.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace cnrg {

template <class N>
N dot(const std::array<N, 3>& a, const std::array<N, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class N>
std::array<N, 3> cross(const std::array<N, 3>& a, const std::array<N, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// The axis of the largest component, of equal ones the first.
template <class N>
std::size_t steepest_axis(const std::array<N, 3>& a) {
  using std::abs;
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (abs(a[k]) > abs(a[axis])) axis = k;
  }
  return axis;
}

}  // namespace cnrg
