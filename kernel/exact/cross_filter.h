// The sign of a cross product of two differences in the plane, as a filter.
//
// Bounds. Let u = 2^-53, mx and my the largest absolute rounded differences per axis. Two products of two
// differences each, every one rounded once, and their difference: (1 + u)^4 - 1 < 4.1 u each, error below 8.2 u mx
// my < 9.2e-16 mx my; we use 1.2e-15 mx my, which also covers the roundings of the bound. Coordinates that are
// known up to a `width`: see the head of predicates.cpp.
#pragma once

#include <algorithm>
#include <cmath>

namespace cnrg {

inline constexpr int kUndecided = 2;
/// Differences between these neither underflow nor overflow in a product of three.
inline constexpr double kSmallestFiltered = 1e-90, kLargestFiltered = 1e100;

/// The sign of ux vy - uy vx, or kUndecided. Each is the difference of two coordinates; each exact coordinate lies
/// between the one taken and `width` above it.
inline int filtered_cross(double ux, double uy, double vx, double vy, double width) {
  const double mx = std::max(std::fabs(ux), std::fabs(vx)), my = std::max(std::fabs(uy), std::fabs(vy));
  if (width == 0 && (mx == 0 || my == 0)) return 0;  // a difference of doubles is zero only if it is exactly
  if (!(std::min(mx, my) > kSmallestFiltered && std::max(mx, my) < kLargestFiltered)) return kUndecided;
  const double determinant = ux * vy - uy * vx, bound = 1.2e-15 * mx * my + 2.1 * width * (mx + my + width);
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  return kUndecided;
}

}  // namespace cnrg
