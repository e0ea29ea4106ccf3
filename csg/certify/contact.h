// Planes, quadrics and tori that touch and do not cross, decided exactly.
//
// A quadric is x' A x = 0 for x = (x, y, z, 1). If some A - l B has no negative eigenvalue, or no positive one,
// then all points of B's surface are on one side of A's, and both have in common what is in the kernel of A - l B
// alone: nothing, a point, a line, or a conic in a plane (or two points, which are not looked for) (the S-lemma:
// polik2007, Section 2). Where the surfaces touch so, l is a double root of det(A - l B), or of the same where
// both have no common kernel; where they are apart, it is between two roots. A plane and a quadric: the same of A
// on the plane.
//
// A torus is all points at the distance of its tube from a circle. The distances of that circle from a plane, from
// a point, from a line along its axis or at right angles to it, and from another circle about its axis or in its
// plane are square roots: signs of sums of them are signs of polynomials. Other lines and circles are not asked.
#pragma once

#include <array>
#include <optional>

#include "csg/carriers/surface_numbers.h"

namespace cnrg {

/// a x + b y + c z + d = 0.
using PlaneEquation = std::array<Rational, 4>;

struct Contact {
  enum class Kind : std::uint8_t { none, point, line, conic, circle };
  Kind kind = Kind::none;
  RationalPoint direction{0, 0, 0};  ///< of a line: along it; of others: at right angles to their plane
  RationalPoint point{0, 0, 0};      ///< on the line, in the plane, the centre, or the only point
  Rational radius = 0;               ///< of a circle
  /// Of points on one of the surfaces; those of a circle are rounded.
  bool has(const RationalPoint& p) const;
  /// True if all that the surfaces have in common lies in the plane.
  bool in(const PlaneEquation& plane) const;
};

/// A row of its matrix times (p, 1).
inline Rational row_times(const Quadric& q, std::size_t row, const RationalPoint& p) {
  return q[row][0] * p[0] + q[row][1] * p[1] + q[row][2] * p[2] + q[row][3];
}
/// Outwards, or inwards, at a point of it.
inline RationalPoint gradient_of(const Quadric& q, const RationalPoint& p) {
  return {row_times(q, 0, p), row_times(q, 1, p), row_times(q, 2, p)};
}

/// The axis of a cylinder, also a stretched one.
struct CylinderAxis {
  RationalPoint direction, middle;
};
std::optional<CylinderAxis> cylinder_axis(const Quadric& quadric);
/// True if x + sign sqrt(a) = other sqrt(b), for a, b from 0 and signs that are not 0.
bool equal_roots(const Rational& x, int sign, const Rational& a, int other, const Rational& b);

/// Nothing where they may cross: it is not proven that one is on one side of the other.
std::optional<Contact> contact(const Quadric& a, const Quadric& b);
std::optional<Contact> contact(const PlaneEquation& plane, const Quadric& quadric);
std::optional<Contact> contact(const PlaneEquation& plane, const Torus& torus);
std::optional<Contact> contact(const Quadric& quadric, const Torus& torus);
std::optional<Contact> contact(const Torus& a, const Torus& b);

}  // namespace cnrg
