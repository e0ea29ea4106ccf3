// Vectors of exact numbers.
#pragma once

#include "kernel/base/products.h"
#include "kernel/exact/integers.h"

namespace cnrg {

inline RationalPoint operator+(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline RationalPoint operator-(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline RationalPoint operator*(const Rational& s, const RationalPoint& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline bool is_zero(const RationalPoint& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }
inline bool collinear(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return is_zero(cross(b - a, c - a));
}
/// Six times the volume of the tetrahedron a b c d: positive when d sees a, b, c counter-clockwise.
inline Rational volume6(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
                        const RationalPoint& d) {
  return dot(cross(b - a, c - a), d - a);
}

/// The doubles nearest to the coordinates.
inline std::array<double, 3> to_doubles(const RationalPoint& p) {
  return {to_double(p[0]), to_double(p[1]), to_double(p[2])};
}

inline RationalPoint from_doubles(const std::array<double, 3>& p) {
  return {from_double(p[0]), from_double(p[1]), from_double(p[2])};
}

/// `(x, y, z)` in decimals, for messages.
inline std::string describe(const RationalPoint& p) {
  return "(" + to_decimal(p[0]) + ", " + to_decimal(p[1]) + ", " + to_decimal(p[2]) + ")";
}

}  // namespace cnrg
