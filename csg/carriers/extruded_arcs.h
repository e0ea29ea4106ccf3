// Arcs of circles in the profiles of extrusions, which sweep parts of cylinders.
//
// A profile has circles as rational Bézier curves, exactly. As surfaces they are cylinders like any others, and
// what touches them about their axis shares their rulings.
#pragma once

#include <vector>

#include "csg/carriers/axes.h"
#include "csg/curves/extrude.h"

namespace cnrg {

struct ExtrudedArc {
  std::uint32_t segment = 0;  ///< of the profile
  std::size_t piece = 0;      ///< of the segment
  BezierCurve curve;
  PlacedForm placed;  ///< one straight piece of a meridian
  Rational degrees;   ///< of the arc
  int segments = 0;   ///< of a whole turn that the leaf asks for
  /// The parameter of the curve at a fraction of the turn.
  Rational parameter(const Rational& turn) const;
};

/// The arcs of the extrusion under a transform.
std::vector<ExtrudedArc> arcs_of(const ExtrudeForm& form, const Transform& transform);

/// The extrusion under a transform with given points in its arcs.
std::unique_ptr<PreparedLeaf> extrude_anew(const ExtrudeForm& form, const Transform& transform,
                                           FixedSamples fixed);

/// True if two arcs of less than half a turn, about one axis, have more than ends in common.
bool overlap(const PlacedForm& a, const PlacedForm& b);
/// True if two arcs with the same ends are equal curves.
bool same_arc(const ExtrudedArc& a, const ExtrudedArc& b);

}  // namespace cnrg
