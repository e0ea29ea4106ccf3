// Leaves of surfaces of revolution about one axis, by their meridians: sphere, cylinder, cone, torus, `revolve`.
//
// A point is center + r e(a) + t axis, with e(a) the unit vector at the angle a about the axis: r is a length, t a
// multiple of the axis as it is given, which need not be a unit vector (exact ones do not exist for most axes). In
// the half-plane of r and t a leaf is a few lines of pieces, straight, circular or Bézier, and all that two such
// leaves with one axis have in common is decided there, in the plane and exactly (csg/carriers).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "csg/curves/bezier.h"
#include "csg/curves/control_nets.h"
#include "csg/leaves/leaf.h"

namespace cnrg {

class LeafParameters;

/// A point of the half-plane through the axis; r >= 0.
struct MeridianPoint {
  Rational r, t;
  friend bool operator==(const MeridianPoint&, const MeridianPoint&) = default;
  friend bool operator<(const MeridianPoint& a, const MeridianPoint& b) {
    return a.r != b.r ? a.r < b.r : a.t < b.t;
  }
};
inline MeridianPoint operator-(const MeridianPoint& a, const MeridianPoint& b) { return {a.r - b.r, a.t - b.t}; }
inline MeridianPoint operator+(const MeridianPoint& a, const MeridianPoint& b) { return {a.r + b.r, a.t + b.t}; }
inline MeridianPoint operator*(const Rational& s, const MeridianPoint& a) { return {s * a.r, s * a.t}; }

/// A piece of a meridian, which sweeps (part of) one patch.
struct MeridianPiece {
  enum class Kind { line, arc, net };
  Kind kind = Kind::line;
  std::uint32_t patch = 0;
  MeridianPoint from{}, to{};
  Span parameters{0, 1};  ///< of the patch, at `from` and at `to`; see `parameter_of`
  int steps = 1;          ///< that the leaf asks for
  // Of an arc, which may be a whole circle: its points are (middle.r + radius cos a, middle.t + radius sin a /
  // |axis|), a from `start` to `start + sweep` degrees, a negative sweep running backward.
  MeridianPoint middle{};
  Rational radius{}, start{}, sweep{};
  // Of a net, and of an arc that is given by one: the points of the net are (r, 0, t).
  BezierCurve net{};
  bool flat() const { return kind == Kind::line && from.t == to.t; }
};

/// The piece that a Bézier curve in the half-plane is (its points are (r, 0, t)): straight, an arc of a circle
/// with a rational radius, or any other. `square` is that of the axis' length; `patch` and `steps` stay to be
/// given.
MeridianPiece meridian_piece(const BezierCurve& curve, const Span& span, const Rational& square);
/// For a rational Bézier curve of degree 2, by squares of lengths: from its inner control point to both ends, and
/// of half the way between the ends. If it is an arc of a circle, where its centre is: from the inner control
/// point so many times the way to the middle of the ends.
std::optional<Rational> center_of_arc(const ControlRow& net, const Rational& to_first, const Rational& to_last,
                                      const Rational& half_chord);
/// The same piece, run backward.
MeridianPiece reversed(MeridianPiece piece);
/// The parameter of an arc at an angle in degrees between its ends.
Rational parameter_of(const MeridianPiece& arc, const Rational& degrees);

struct RevolvedForm final : CurvedForm {
  RationalPoint center, axis;                     ///< e(0) is the first vector of CircleFrame(axis)
  std::vector<std::vector<MeridianPiece>> lines;  ///< each piece begins where the one before it ends
  bool closed_lines = false;                      ///< the last piece of a line ends where the first one begins
  bool discs = false;  ///< the ends of the only line carry discs: patch 0 at its beginning, 1 at its end
  bool turn_is_u =
      false;  ///< u is the fraction of the turn made, v the parameter of the meridian; or the other way
  Rational degrees = 360;  ///< of the turn; of less than a whole one closed lines have patches 0 and 1 at its ends
  int segments = 0;        ///< steps of a whole turn that the leaf asks for
  bool solid = true;       ///< Fill::winding; else none
  std::vector<std::pair<std::uint32_t, std::string>> names;  ///< of patches

  bool around() const { return degrees == 360; }
  /// A ball about `center`, the only form with more than one axis.
  bool is_sphere() const {
    return solid && around() && lines.size() == 1 && lines[0].size() == 1 &&
           lines[0][0].kind == MeridianPiece::Kind::arc && lines[0][0].middle == MeridianPoint{0, 0} &&
           abs(lines[0][0].sweep) == 180;
  }
};

/// Where a revolved leaf is tessellated, and on which lines.
struct RevolvedGrid {
  /// A half-plane through the axis, by the fraction of the leaf's turn.
  struct Column {
    RationalPoint direction;  ///< e(a), as near to a unit vector as can be
    Rational turn;
    bool mark = false;  ///< no even step: corners in it stay as they are
    friend bool operator==(const Column&, const Column&) = default;
  };
  struct Row {
    MeridianPoint at;
    Rational parameter;
    friend bool operator==(const Row&, const Row&) = default;
  };
  /// Counter-clockwise about the axis. Of a whole turn the last one is the first again, a turn later.
  std::vector<Column> columns;
  std::vector<std::vector<std::vector<Row>>> rows;  ///< of each line, each piece: from its beginning to its end
  bool mirrored = false;                            ///< columns run against the turn of the leaf
  friend bool operator==(const RevolvedGrid&, const RevolvedGrid&) = default;
};

/// True if the piece comes to the axis there, and not at a right angle: lines end in that point
/// (Soup::add_curve_end).
bool is_apex(const MeridianPiece& piece, const MeridianPoint& end);

/// The leaf on these lines. `point(r t, column)` says where a point is: always the same for equal arguments.
std::unique_ptr<PreparedLeaf> tessellate(
    const RevolvedForm& form, const RevolvedGrid& grid,
    const std::function<RationalPoint(const MeridianPoint&, std::size_t)>& point, LeafParameters* record);

}  // namespace cnrg
