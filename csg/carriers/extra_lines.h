// Lines that the facets of a leaf are to have besides those that its fineness gives them.
//
// To make a whole leaf finer because its facets are too coarse in one place costs as much everywhere. A few lines
// of parameters next to the place cost only what they add.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "csg/carriers/extruded_arcs.h"
#include "csg/curves/revolved.h"

namespace cnrg {

/// By patch: values of u and values of v (csg/leaves/parameters.h), in any order, as the leaf has them when it is
/// drawn without extra lines; with them it has the same ones, but for 1e-12 and less. A whole turn goes on
/// above 1. A line of a patch without parameters, and one beyond its patch, is none; of lines nearer to each other
/// than 1e-12 the leaf has one. A ball that shares circles about several axes has points where its lines cross
/// each other and its even ones, but none next to these circles.
struct ExtraLines {
  std::map<std::uint32_t, std::array<std::vector<Rational>, 2>> of;
  friend bool operator==(const ExtraLines&, const ExtraLines&) = default;
  friend bool operator<(const ExtraLines& a, const ExtraLines& b) { return a.of < b.of; }
};

/// By instance.
using ExtraOfInstances = std::map<std::uint32_t, ExtraLines>;

/// Calls `add` with where on the way from one parameter to another those values are that lie between.
template <class Add>
void each_between(const std::vector<Rational>& values, const Span& span, const Add& add) {
  for (const Rational& value : values) {
    const Rational way = (value - span[0]) / (span[1] - span[0]);
    if (sgn(way) > 0 && way < 1) add(way);
  }
}

/// The same lines about the axis of a leaf of revolution.
struct RevolvedLines {
  struct Row {
    std::size_t piece;  ///< through all lines of the meridian
    Rational way;       ///< between 0 and 1, of its parameter
  };
  std::vector<RationalPoint> directions;  ///< nearly unit vectors, at right angles to the axis
  std::vector<Row> rows;
};
/// `transform` stretches by `scale`.
RevolvedLines revolved_lines(const ExtraLines& lines, const RevolvedForm& form, const Transform& transform,
                             const Rational& scale);
/// Those that cross an arc of an extrusion.
RevolvedLines revolved_lines(const ExtraLines& lines, const ExtrudeForm& form, const ExtrudedArc& arc);

}  // namespace cnrg
