// Parts of planes that round leaves may touch.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

/// A part of a plane: a polygon, a ring about the axis of a revolved leaf, or all of it.
struct Flat {
  RationalPoint normal;
  Rational offset;
  std::vector<std::vector<RationalPoint>> loops{};   ///< of a polygon
  RationalPoint center{};                            ///< of a ring
  std::optional<std::array<Rational, 2>> squares{};  ///< of the radii of a ring, inside and outside

  /// True if the segment from p to q, in the plane, has a point in it; p and q may be one.
  bool meets(const RationalPoint& p, const RationalPoint& q) const;
  /// True if a circle in the plane has a point in it.
  bool meets_circle(const RationalPoint& middle, const Rational& radius) const;

 private:
  bool polygon_meets(const RationalPoint& p, const RationalPoint& q) const;
};

}  // namespace cnrg
