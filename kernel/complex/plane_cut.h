// Exact planes, and the polygons in which they cut boxes.
#pragma once

#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

/// The plane { p : normal . p = offset }, and what is behind its normal.
struct ExactHalfspace {
  RationalPoint normal;
  Rational offset;
};

/// An axis-parallel box.
struct ExactBox {
  RationalPoint low, high;
  /// Bit k of `corner` is set where coordinate k is the larger one.
  RationalPoint corner(std::size_t corner) const {
    return {(corner & 1 ? high : low)[0], (corner & 2 ? high : low)[1], (corner & 4 ? high : low)[2]};
  }
};

/// The polygon plane ∩ box, counter-clockwise as seen from the side of the normal; the plane meets the inside.
std::vector<RationalPoint> cut(const ExactHalfspace& plane, const ExactBox& box);

}  // namespace cnrg
