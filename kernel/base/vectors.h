// Vectors of doubles, for what only proposes points or draws; what decides is exact.
#pragma once

#include <array>
#include <cmath>

namespace cnrg {

using DoubleVector = std::array<double, 3>;

inline DoubleVector minus(const DoubleVector& a, const DoubleVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double dot(const DoubleVector& a, const DoubleVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline DoubleVector cross(const DoubleVector& a, const DoubleVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// a b - c d with an error of two units in the last place at most, however much of it cancels (jeannerod2013).
inline double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}
/// The cross product of vectors that may be nearly parallel.
inline DoubleVector accurate_cross(const DoubleVector& a, const DoubleVector& b) {
  return {difference_of_products(a[1], b[2], a[2], b[1]), difference_of_products(a[2], b[0], a[0], b[2]),
          difference_of_products(a[0], b[1], a[1], b[0])};
}

}  // namespace cnrg
