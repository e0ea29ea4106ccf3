// Vectors of doubles, for what only proposes points or draws; what decides is exact.
#pragma once

#include <array>

namespace cnrg {

using DoubleVector = std::array<double, 3>;

inline DoubleVector minus(const DoubleVector& a, const DoubleVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double dot(const DoubleVector& a, const DoubleVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline DoubleVector cross(const DoubleVector& a, const DoubleVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace cnrg
