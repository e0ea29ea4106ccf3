// Where the axis of a revolved leaf lies under the transform of its instance, in a form that is equal for equal
// axes.
#pragma once

#include <optional>

#include "csg/curves/revolved.h"
#include "csg/geometry/transform.h"
#include "kernel/exact/rational.h"

namespace cnrg {

/// A line of space: its primitive direction, the first number that is not 0 being positive, and its point nearest
/// to the origin.
struct AxisLine {
  RationalPoint direction, foot;
  /// Of the point on it that is nearest to p: foot + t direction.
  Rational place_of(const RationalPoint& p) const;
  bool holds(const RationalPoint& p) const;
  friend bool operator==(const AxisLine&, const AxisLine&) = default;
  friend bool operator<(const AxisLine& a, const AxisLine& b) {
    return a.direction != b.direction ? a.direction < b.direction : a.foot < b.foot;
  }
};
AxisLine axis_line(const RationalPoint& point, const RationalPoint& direction);

/// By how much a transform stretches every length, where it does so by one rational number.
std::optional<Rational> stretch(const Transform& transform);
/// Its square; nothing for one that changes angles.
std::optional<Rational> squared_stretch(const Transform& transform);

/// A revolved leaf in the space of those that it is compared with, its meridians in the half-plane of its axis
/// line.
struct PlacedForm {
  AxisLine axis;
  bool along = true;  ///< the leaf's own axis runs along the line
  bool mirrored = false;
  std::vector<std::vector<MeridianPiece>> lines;
  RationalPoint start, end;  ///< where its turn begins and ends
  Rational square() const;   ///< of the length of the line's direction
};
/// `transform` stretches by `scale`.
PlacedForm place(const RevolvedForm& form, const Transform& transform, const Rational& scale);

/// A ball by what it is.
struct Ball {
  RationalPoint center;
  Rational radius;
  friend bool operator==(const Ball&, const Ball&) = default;
  friend bool operator<(const Ball& a, const Ball& b) {
    return a.center != b.center ? a.center < b.center : a.radius < b.radius;
  }
};
/// A sphere about `axis`, its poles on it.
RevolvedForm sphere_about(const Ball& ball, const RationalPoint& axis, const RevolvedForm& like);

// Parts of a turn, between two directions across an axis, compared exactly.

/// Counter-clockwise about the axis, its ends included; a whole turn has no ends.
struct Sector {
  RationalPoint from, to;
  bool whole = true;
};
bool same_ray(const RationalPoint& a, const RationalPoint& b);
bool meet(const Sector& a, const Sector& b, const RationalPoint& axis);
/// True if they have more than ends in common.
bool overlap(const Sector& a, const Sector& b, const RationalPoint& axis);

}  // namespace cnrg
