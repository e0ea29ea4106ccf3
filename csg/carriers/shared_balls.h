// Balls that share circles about several axes, and what is drawn as a hull with them.
//
// A ball in one family is drawn as any leaf about its axis. One in several is the hull of all its circles, whose
// chords must be edges of it: those that are not are halved, for all leaves about their axis.
//
// A ball that touches a hull from inside or outside of it cannot rely on rows and columns to stay apart from it.
// As with tubes (family.h) a similarity about the point of contact does it: the larger ball has the corners
// of the smaller one as that takes them to its own sphere, and a ring of points around the contact, nearer to it
// than any of these, so that the two hulls have this one point in common.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "csg/carriers/ball_hull.h"
#include "csg/carriers/family.h"
#include "csg/carriers/point_lattice.h"

namespace cnrg {

class SharedBalls {
 public:
  /// A member of a family that is this ball; `points`: further ones that it must have.
  void add(const Ball& ball, Family& family, std::size_t member, const std::vector<RationalPoint>& points);
  /// After all of these and `nest`, before `solve`: which balls are hulls.
  void choose();
  bool is_hull(const Ball& ball) const {
    return std::find(by_size_.begin(), by_size_.end(), ball) != by_size_.end();
  }
  /// Further meridians and parallels of a hull, about the z axis, as points where they cross.
  void add_lines(const Ball& ball, const ExtraLines& lines);
  /// The two touch in a point, `inner` from inside; both are in one family.
  void nest(const Ball& inner, const Ball& outer) { nested_.push_back({inner, outer}); }
  /// Calls `solve_turns`, which is to solve the directions of all families, as often as these grow.
  void solve(const std::function<void()>& solve_turns);
  /// Null for a ball that its only family draws; after `solve`.
  std::shared_ptr<const BallHull> hull(const Ball& ball) const;

 private:
  struct Place {
    Family* family;
    std::size_t member;
  };
  struct Shared {
    std::vector<Place> places;
    std::vector<RationalPoint> points;
    std::array<std::set<Rational>, 2> lines;
  };
  struct Nested {
    Ball inner, outer;
  };
  /// What a hull is made of.
  struct Parts {
    std::vector<SphereCircle> circles;
    std::vector<Family*> family;  ///< of each circle
    std::vector<RationalPoint> points, others;
    CurveSteps around, up;
  };

  void cross_circles(const std::vector<Place>& places, const Ball& ball) const;
  Parts parts_of(const Ball& ball) const;
  std::vector<RationalPoint> corners(const Ball& ball) const;

  std::map<Ball, Shared> balls_;
  std::vector<Nested> nested_;
  std::vector<Ball> by_size_;  ///< those drawn as hulls, the smallest first
  std::map<Ball, std::shared_ptr<const BallHull>> hulls_;
};

// Circles that are a meridian of one leaf and go around the axis of another: where an elbow goes on as a straight
// pipe or in another elbow, or a ball fills the tube of a torus.
//
// The one draws such a circle by the vertices of its arc, the other by its directions. Neither knows of the other,
// so the points of the circle are kept here, and go to and fro until all have the same ones. Of circles that are a
// little larger or smaller polygons would cross: they have the same points as seen from the centre.
//
// A ball touches the torus around it along the circle, from inside. Of a torus with circles of radius R and tube
// r, a chord over the angle h cuts off at most (R + r) h^2 / 8. In the half-plane where a point of the ball at the
// latitude f lies, counted from the circle, the section of the torus is larger than that of the ball by
// r (1 - cos f), less what the ball is farther out there, r^2 f^2 / 2 / (R + r), and less what the polygon cuts
// off of that: at its corners nothing, between two of them, g apart, a part of 1 - cos (g / 2). So the ball is
// inside as long as h <= k f with k = 2 sqrt(r ((R + r) cos (g / 2) - r)) / (R + r). The torus has directions
// beside the circle with half of these steps, from the ball's first row on; farther off, where f grows, they soon
// reach its own steps.

class CommonCircles {
 public:
  /// How one leaf has a circle: all around its axis, or as a meridian in the half-plane of a direction.
  struct Part {
    std::shared_ptr<Family> family;
    std::size_t member = 0;
    Rational radius;
    std::optional<RationalPoint> direction{};
  };
  void add(const CircleInSpace& circle, Part part);
  /// After all directions are solved: gives points to families that lack them, whose meridians are solved again.
  /// True if there were any; then directions are to be solved again.
  bool exchange();

 private:
  struct Circle {
    CircleInSpace place;
    std::vector<Part> parts;
    PointLattice known;
    double first_row = HUGE_VAL;  ///< of a ball, as the torus knows it, in radians from the circle
  };
  std::vector<RationalPoint> points(const Circle& circle, const Part& part, bool marks) const;
  bool exchange(Circle& circle, bool marks) const;
  bool grade(Circle& circle) const;

  std::map<CircleInSpace, Circle> circles_;
};

}  // namespace cnrg
