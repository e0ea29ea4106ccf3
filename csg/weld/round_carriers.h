// Axes, centres, radii and places along axes that are meant to be one, and what they become.
//
// To move points does not make one cylinder of two: their facets are drawn apart, at other angles, and no corner
// of one is near a corner of the other. What is near are the numbers that make the surfaces: an axis, a radius. So
// these are joined, before anything is drawn, and surfaces that have equal numbers then are one surface, exactly.
//
// Axes come first, of surfaces whose boxes are within d of each other, then centres of balls, which are put on the
// axis that they are near; where several axes come near to a centre they are made to meet in it; then radii and
// places of surfaces that hang together. The rule is that of weld.h: from the nearest pair on, two sets become one
// if all of both are within d of each other. They take the value of that member whose numbers are the shortest (1
// and not 1.000000000001): so nothing is new, and what is a member already does not move. Axes count as far apart
// as they are where their surfaces are, with what a tilt does at the radius. Ties are decided by the values
// themselves.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "csg/carriers/axes.h"

namespace cnrg::welding {

/// A surface of revolution, or several that have one axis and belong together; all in one space.
struct RoundPart {
  bool ball = false;             ///< it has a centre, and every axis through that
  RationalPoint center{};        ///< of a ball
  AxisLine axis{};               ///< of any other
  std::array<Rational, 2> ends;  ///< how far it goes along its axis
  Rational reach = 0;            ///< and away from it, or from the centre, at most
  std::vector<Rational> radii;   ///< lengths across the axis and of arcs, all greater than 0
  std::vector<Rational> places;  ///< along the axis
};

struct RoundPlace {
  RationalPoint center{};
  AxisLine axis{};
  std::map<Rational, Rational> radii;   ///< as it was: as it is
  std::map<Rational, Rational> places;  ///< on the axis as it was: on the axis as it is
  Rational moved = 0;                   ///< no point of the part farther than that
};

struct RoundWeld {
  std::vector<RoundPlace> parts;
  std::vector<std::array<std::uint32_t, 2>> left;  ///< near and not joined; one twice: it stays as it is
};

RoundWeld weld_round(const std::vector<RoundPart>& parts, const Rational& d);

/// Not less than the square root, and more by less than a millionth of it.
Rational root_above(const Rational& square);

}  // namespace cnrg::welding
