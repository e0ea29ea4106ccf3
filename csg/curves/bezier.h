// Rational Bézier curves and patches, exactly.
//
// Notation: a net holds homogeneous control points (w x, w y, w z, w) with rational w > 0. Points are those of
// the Bernstein form, by de Casteljau in rationals. A patch has net[j][i]: i runs along u, j along v; its front
// is the side that S_u x S_v points to. Its sides in order go round it, counter-clockwise as seen from the front:
// v = 0, u = 1, v = 1 (backward), u = 0 (backward).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

using Homogeneous = std::array<Rational, 4>;
using ControlRow = std::vector<Homogeneous>;

inline Homogeneous operator+(const Homogeneous& a, const Homogeneous& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
}
inline Homogeneous operator-(const Homogeneous& a, const Homogeneous& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]};
}
inline Homogeneous operator*(const Rational& s, const Homogeneous& a) {
  return {s * a[0], s * a[1], s * a[2], s * a[3]};
}

/// A control point with its weight.
Homogeneous homogeneous(const RationalPoint& p, const Rational& weight = 1);
/// The point of space that homogeneous coordinates stand for.
RationalPoint project(const Homogeneous& h);

/// The control row of the same curve, of the least degree that it has in homogeneous coordinates.
ControlRow reduced(ControlRow row);
/// The control row of the same curve, of the given degree, not less than its own.
ControlRow elevated(ControlRow row, std::size_t degree);
/// The piece of a curve from t = low to t = high, as a curve of its own; low < high.
ControlRow part(ControlRow row, const Rational& low, const Rational& high);
/// The homogeneous point at t.
Homogeneous de_casteljau(ControlRow row, const Rational& t);

/// Is a coordinate zero somewhere between the ends of a curve, but not everywhere?
bool is_zero_inside(const ControlRow& row, std::size_t coordinate);

struct BezierCurve {
  ControlRow net;
  std::size_t degree() const { return net.size() - 1; }
  RationalPoint at(const Rational& t) const { return project(de_casteljau(net, t)); }
  /// All control points are one point.
  bool is_point() const;
};

struct BezierPatch {
  std::vector<ControlRow> net;
  std::size_t degree_u() const { return net[0].size() - 1; }
  std::size_t degree_v() const { return net.size() - 1; }
  RationalPoint at(const Rational& u, const Rational& v) const;
  BezierCurve side(std::size_t k) const;
};

/// The same patch with u and v exchanged; its front is the back of the given one.
BezierPatch transposed(const BezierPatch& patch);
/// The net of the same patch, of the least degrees that it has in homogeneous coordinates; if a weight were not
/// positive, both degrees are higher by as much as it takes.
BezierPatch reduced(const BezierPatch& patch);
/// The piece of a patch between two parameters along u and two along v, as a patch of its own.
BezierPatch part(const BezierPatch& patch, const std::array<Rational, 2>& u, const std::array<Rational, 2>& v);

/// The control points of a net.
std::vector<RationalPoint> points_of(const std::vector<ControlRow>& net);
/// The normal of a plane that holds the points and the direction, which may be zero; zero if many do.
std::optional<RationalPoint> plane_normal(const std::vector<RationalPoint>& points,
                                          RationalPoint along = {0, 0, 0});
bool on_one_line(const std::vector<RationalPoint>& points);
/// True for control points of a line that stays between its ends, or of a point.
bool runs_straight(const std::vector<RationalPoint>& points);

/// The form in which curves are compared: least degree, first weight 1, and of its two directions the one whose
/// net is smaller. Curves with equal nets, reversed or not, with weights in proportion, or of raised degree, have
/// equal canonical nets.
struct CanonicalCurve {
  BezierCurve curve;
  bool reversed = false;  ///< against the given direction
};
CanonicalCurve canonical(const BezierCurve& curve);

/// Of the eight ways to write the net of a patch (transposed, run backward) the smallest, its first weight 1.
/// `mirrored` if its front is the back of the given one.
struct CanonicalPatch {
  BezierPatch patch;
  bool mirrored = false;
  /// What was done to the given net: first transposed, then run backward along u, along v.
  bool transposed = false, backward_u = false, backward_v = false;
  /// The parameters of the given patch that name the same point as (u, v) of this one.
  std::array<Rational, 2> given(const Rational& u, const Rational& v) const;
};
CanonicalPatch canonical(const BezierPatch& patch);

/// The Bézier pieces of a B-spline curve, one for each knot span that is not empty, by its blossom (ramshaw1989).
/// knots: ascending, as many as points + degree + 1; the curve runs from knots[degree] to knots[points].
std::vector<ControlRow> bezier_pieces(const ControlRow& points, std::size_t degree,
                                      const std::vector<Rational>& knots);

/// The knots of a B-spline that begins and ends in its first and last point, its spans of equal length.
std::vector<Rational> clamped_knots(std::size_t points, std::size_t degree);

/// The Coons patch of four curves that go round: c0 (v = 0), c1 (u = 1), c2 (v = 1, backward), c3 (u = 0,
/// backward), each beginning where the one before it ends. Of least degree.
BezierPatch coons_patch(const std::array<BezierCurve, 4>& round);

}  // namespace cnrg
