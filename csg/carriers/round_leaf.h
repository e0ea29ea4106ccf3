// Balls, cylinders, rings and planes of a revolved leaf, in doubles and exactly.
//
// Most pairs of leaves are far from a contact, and the numbers of nested rotations are long. So a leaf is asked in
// doubles first, generously, and has its exact form only once that is asked for.
#pragma once

#include <array>
#include <optional>
#include <tuple>
#include <vector>

#include "csg/carriers/axes.h"
#include "csg/carriers/tangency.h"
#include "kernel/exact/rational.h"

namespace cnrg {

// Parts of planes that round leaves may touch.

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

struct Ball3 {
  RationalPoint center;
  Rational radius;
};
struct Tube {
  RationalPoint foot, axis;
  Rational radius, low, high;  ///< from foot + low axis to foot + high axis
};
/// An arc: a plane across the axis may touch it in a circle, another leaf may have one of its meridians.
struct Ring {
  MeridianPoint middle;
  Rational radius;
};

/// A piece of a cone: along one of its lines a plane may touch it.
struct Slant {
  MeridianPoint from, to;
};

/// Nearly equal lengths, in doubles: what is not certainly is not exactly either.
bool nearly(double a, double b, double size);
/// Of radii of circles about one centre whose polygons may cross.
inline bool is_near(const Rational& a, const Rational& b) { return 16 * abs(a - b) <= b; }

class RoundLeaf {
 public:
  using Point3 = std::array<double, 3>;
  struct Exact {
    PlacedForm placed;
    std::vector<Ball3> balls;
    std::vector<Tube> tubes;
    std::vector<Ring> rings;
    std::vector<Slant> slants;
    std::vector<Flat> flats;  ///< its own planes across the axis
  };

  RoundLeaf(const RevolvedInstance& of, const RevolvedForm& form);

  /// False if a plane, with a normal of length 1, certainly touches nothing of the leaf.
  bool may_touch(const Point3& normal, double offset) const;
  bool may_touch(const RoundLeaf& other) const;

  /// False if it is stretched so that it has no radii, or none that are rational; else `exact` may be asked for.
  bool make_exact();
  const Exact& exact() const { return *exact_; }
  std::uint32_t instance() const { return of_->instance; }
  const Transform& transform() const { return of_->transform; }
  const Box& box() const { return of_->box; }
  bool is_sphere() const { return form_->is_sphere(); }
  /// True if its turn has the direction; of what is exact.
  bool covers(const RationalPoint& direction) const;
  /// The radius nearest to p.r of a circle about its axis, if one is near it.
  std::optional<Rational> radius_near(const MeridianPoint& p) const;
  /// True if one of its meridians has the point, in the half-plane of the direction.
  bool holds(const MeridianPoint& p, const RationalPoint& direction) const;

 private:
  bool may_share_circle(const RoundLeaf& other) const;
  /// Of its rings and slants with whatever the other one has.
  bool may_touch_beside(const RoundLeaf& other) const;
  /// Calls `flat(t, r, s)`, `arc(piece)`, `tube(piece)` and `slant(piece)` for the pieces of `lines` that are
  /// such.
  template <class Flats, class Arcs, class Tubes, class Slants>
  void each_piece(const std::vector<std::vector<MeridianPiece>>& lines, const Flats& flat, const Arcs& arc,
                  const Tubes& tube, const Slants& slant) const;

  const RevolvedInstance* of_;
  const RevolvedForm* form_;
  Point3 along_{};                                           ///< of length 1
  std::vector<std::pair<Point3, double>> balls_{};           ///< centres and radii; of arcs about the axis, too
  std::vector<std::pair<Point3, double>> tubes_{};           ///< points of the axis and radii
  std::vector<std::tuple<Point3, double, double>> rings_{};  ///< centres, and radii of circles and of their tubes
  /// Circles about the axis, of which a slant goes from the first to the second: centres and radii.
  std::vector<std::array<std::pair<Point3, double>, 2>> slants_{};
  std::vector<double> flats_{};  ///< offsets of its planes across the axis
  std::optional<Exact> exact_{};
};

}  // namespace cnrg
