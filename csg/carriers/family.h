// Leaves and parts of leaves that touch each other about one axis, and the points on which all of them are drawn.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "csg/carriers/axes.h"
#include "csg/carriers/ball_hull.h"
#include "csg/carriers/banded_leaves.h"
#include "csg/carriers/extra_lines.h"
#include "csg/carriers/extruded_arcs.h"
#include "csg/carriers/meridians.h"
#include "csg/carriers/revolved_families.h"
#include "csg/carriers/turns.h"

namespace cnrg {

/// A leaf or, for all leaves of one ball, the ball, on one axis.
struct Member {
  PlacedForm placed;
  std::vector<std::uint32_t> instances;
  int segments = 0;
  bool ball = false;
  std::shared_ptr<const ExtrudedArc> arc{};  ///< what it is of an extrusion, if it is of one
  std::optional<std::size_t> band{};         ///< which one it is of a banded leaf, if it is of one
  bool whole = true;                         ///< of a band
  std::vector<RationalPoint> marks{};        ///< directions that it must have
  std::optional<RationalPoint> even{};       ///< where even steps begin, if that is not the start of its turn
};

/// The part of the turn that a band covers.
Sector sector_of(const Member& member);

/// Members that touch each other about one axis. Contacts of meridians come first, then directions.
class Family {
 public:
  /// `may_round`: its space is that of the tree, and nothing touches it from inside or outside about another axis.
  Family(std::vector<Member> members, bool may_round);
  Family(const Family&) = delete;  // its plane refers to it
  Family& operator=(const Family&) = delete;

  /// Points and circles that `member` must have as vertices.
  void add_marks(std::size_t member, const TangencyMarks& marks);
  /// Further lines of `member`.
  void add_lines(std::size_t member, const RevolvedLines& lines);
  /// Contacts first, then directions: what must be one may be added between.
  void solve_meridians() { plane_.solve(); }
  /// With `others` (turns.h), which are not kept.
  void solve_turns(const std::vector<RationalPoint>& others = {});
  void add_direction(const RationalPoint& direction) { marks_.push_back(direction); }
  /// One that gives way to those next to it.
  void add_other_direction(const RationalPoint& direction) { others_.push_back(direction); }
  /// On each arc of the member that holds the point, or nearly.
  void add_circle(std::size_t member, const MeridianPoint& p);
  const Turns& turns() const { return *turns_; }

  /// The circles that the ball `member` shares, but for its poles.
  std::vector<MeridianPoint> shared_circles(std::size_t member) const;
  SphereCircle circle(const MeridianPoint& at) const;

  const std::vector<Member>& members() const { return members_; }
  const AxisLine& axis() const { return axis_; }

  /// The half-planes of a member that turns by `degrees`.
  std::vector<RevolvedGrid::Column> columns(std::size_t m, const Rational& degrees) const;

  RevolvedGrid grid(std::size_t m, const RevolvedForm& form) const;

  /// The points of a band, `back` takes them to the space of its leaf.
  BandGrid band_grid(std::size_t m, const Transform& back) const;

  /// The vertices of a circle of the half-plane, or only those that are no even steps.
  std::vector<MeridianPoint> vertices(const MeridianPoint& middle, const Rational& radius, bool only_marks) const {
    return plane_.vertices(middle, radius, only_marks);
  }

  /// Of a ball on its own.
  std::vector<RationalPoint> corners(std::size_t m) const;

  RationalPoint point(const MeridianPoint& at, const RevolvedGrid::Column& column) const;
  /// The size for which `point` rounds; nothing if it does not.
  std::optional<Rational> rounded() const { return rounds_ ? std::optional(size_) : std::nullopt; }

 private:
  /// Corners are doubles, which are cheaper, where that keeps planes plane: about axes of coordinates, without
  /// slanted lines, whose facets are coplanar with others only where nothing is rounded, and in whole turns.
  bool stays_plane() const;
  Rational smallest() const;
  /// Where even steps begin: where the turn of the finest member does, so that one alone keeps its own.
  RationalPoint first_direction() const;
  /// A sampled point of a meridian; only its place along the axis is rounded here.
  MeridianPoint rounded(const MeridianPoint& p) const;

  void add_point(std::size_t member, const RationalPoint& p);

  std::vector<Member> members_;
  AxisLine axis_;
  bool rounds_;
  Rational size_;
  MeridianPlane plane_;
  std::vector<RationalPoint> marks_, others_;
  std::set<RationalPoint> lines_;   // directions that give way to all of these
  std::vector<std::size_t> first_;  // piece of each member
  std::size_t pieces_ = 0;
  int segments_ = 0;
  std::unique_ptr<Turns> turns_;
};

// Directions about axes that are parallel but not one, for surfaces of which one touches the other from inside.
//
// A pin of radius r in a bore of radius R, R - r off its axis, touches it along a line. The line alone does not
// keep them apart: chords of the bore beside it cut into the pin. What does is a similarity. About the point of
// contact, in a plane across the axes, it takes the circle of the pin to that of the bore, and the corner of the
// pin in some direction from its axis to that of the bore in the same direction from its own. So if the bore has
// all directions of the pin, the polygon of the pin made larger by R / r about one of its corners is inscribed in
// that of the bore. A convex polygon lies in its image, so the pin is in the bore, exactly and at any fineness.
// Sides next to the contact lie on their images, though, and two strips of the surfaces would be one. So the bore
// has one direction more between that of the contact and each of its neighbours: its corner there lies outside of
// the image, and what the two have in common is the line.
//
// The same holds for a ball in a tube: about the axis through its centre that is parallel to that of the tube, and
// with a circle across it through its centre, it is in its shadow along the axis, which is a polygon as above.
// A tube that touches a larger ball is inside of it in the plane across, and leaves it above and below.
//
// A ball beside the inner half of a torus or in a cone is inside of the cone that touches both. About its own axis
// it has such a cone, too, moved along the line in which they touch; with the same directions the one is in the
// other.

/// By their places in a list; `direction`: of the contact, from either axis, exactly a unit vector.
struct NestedFamilies {
  std::size_t inner = 0, outer = 0;
  RationalPoint direction;
};

/// Solves the directions of all families, what is inside before what is around it. Families in a circle, of which
/// each touches the next one from inside, cannot all be finer than the next: one of them, always the same, is not.
void solve_turns(const std::vector<std::shared_ptr<Family>>& families, const std::vector<NestedFamilies>& nested);

}  // namespace cnrg
