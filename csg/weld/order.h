// Points and planes that depend on each other, each placed exactly.
//
// A point on four planes is one condition too many, and so is a plane through four points: which of them obeys? In
// a polyhedron some point is on three planes at most, or some plane has three points at most (its graph of
// incidences is planar and bipartite). Taken away, what remains is like it again. Placed in the opposite order,
// each has at most three partners to obey, which it always can: that is why every polyhedron can be drawn with
// rational numbers. Where many solids meet, there may be none with three; then one with few is taken away all the
// same, and what it cannot obey when its turn comes is broken.
//
// Each step makes numbers longer. A row of many steps, as over the quadrilaterals of a fine mesh, is broken where
// they get too long: a point is placed in doubles again, and what follows is short.
//
// Three planes that nearly have a line in common make no point that is worth having: they count as too many. So
// the ends of an edge at which many faces meet are placed before these faces.
#pragma once

#include "csg/weld/planes.h"

namespace cnrg::welding {

/// Points and planes, and which lie on which.
struct Incidence {
  struct Point {
    RationalPoint at;                           ///< where it would be without planes
    std::vector<const RationalPoint*> members;  ///< where what it stands for was: all within d of it in the end
    std::vector<Index> planes;
  };
  struct Through {
    Plane plane;                                ///< where it would be without points
    std::size_t parts = 1;                      ///< what matters more is obeyed first
    std::vector<const RationalPoint*> corners;  ///< of its faces, as they were: within d of it in the end
    std::vector<Index> points;
  };
  std::vector<Point> points;
  std::vector<Through> planes;
};

/// Places all of them; returns how many incidences are broken. Ties go by numbers.
std::size_t place(Incidence& incidence, const Rational& d);

}  // namespace cnrg::welding
