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
#pragma once

#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "csg/carriers/family.h"
#include "csg/carriers/point_lattice.h"

namespace cnrg {

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
