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
#include <functional>
#include <map>
#include <memory>
#include <set>

#include "csg/carriers/ball_hull.h"
#include "csg/carriers/family.h"

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

}  // namespace cnrg
