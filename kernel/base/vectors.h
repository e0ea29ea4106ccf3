// Vectors of doubles, for what only proposes points or draws; what decides is exact.
#pragma once

#include <array>
#include <cmath>

#include "kernel/base/products.h"

namespace cnrg {

using DoubleVector = std::array<double, 3>;

inline DoubleVector minus(const DoubleVector& a, const DoubleVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double length(const DoubleVector& a) { return std::sqrt(dot(a, a)); }
inline double distance(const DoubleVector& a, const DoubleVector& b) { return length(minus(a, b)); }
inline DoubleVector unit(const DoubleVector& a) {
  const double size = length(a);
  return {a[0] / size, a[1] / size, a[2] / size};
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
