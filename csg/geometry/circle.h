// Points on circles about any axis, in an exact plane.
//
// An orthonormal rational frame does not exist for most axes. What exists is an orthogonal one of integer
// vectors: e1, e2 perpendicular to the axis and to each other exactly, of lengths that are square roots. A circle
// point is c + alpha e1 + beta e2 with alpha = r cos(t) / |e1| and beta = r sin(t) / |e2|, each rounded correctly
// to a grid of 52 significant bits of r / |e|. So the points lie in the plane exactly, their distance from the
// true circle is below 4e-16 r, opposite points are symmetric exactly, and no machine differs.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

/// The square root, where it is rational.
std::optional<Rational> rational_root(const Rational& square);
/// The square root of a number that is not negative, exact where it is rational, else to 60 bits.
Rational root(const Rational& square);

/// sqrt(square) cos(degrees) to 52 bits of the root, and exactly where the root is rational and the cosine 0 or
/// +-1.
Rational scaled_cosine(const Rational& degrees, const Rational& square);

class CircleFrame {
 public:
  /// `axis` is not zero. About the axes of coordinates e1 and e2 are unit vectors.
  explicit CircleFrame(const RationalPoint& axis);
  const RationalPoint& first() const { return e1_; }
  const RationalPoint& second() const { return e2_; }
  const RationalPoint& axis() const { return axis_; }
  /// The coordinate axis (0, 1, 2) that the frame's axis is parallel to, or 3.
  std::size_t parallel_to() const { return parallel_; }

  /// Offsets from the centre: `segments` points by equal angles, the first along e1, turning by the right-hand
  /// rule about the axis. radius > 0.
  std::vector<RationalPoint> offsets(const Rational& radius, int segments) const;
  /// The offset at one angle.
  RationalPoint offset(const Rational& radius, const Rational& degrees) const;
  /// The offset of radius 1 at angle 0, turned by Transform::rotation: what is turned by that fits there exactly.
  RationalPoint turned(const Rational& degrees) const;

 private:
  /// The parts of an offset along e1 and e2.
  std::pair<RationalPoint, RationalPoint> components(const Rational& radius, const Rational& degrees) const;

  RationalPoint axis_, e1_, e2_;
  std::size_t parallel_ = 3;
};

/// The double nearest to `value` where that moves it by less than 2^-36 of `size`, else the value itself: facets
/// with doubles as corners are much cheaper, but a small shape far from the origin must keep its form.
Rational rounded_for(const Rational& value, const Rational& size);

}  // namespace cnrg
