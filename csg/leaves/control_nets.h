// Control nets as the shapes have them, checked, as Bézier pieces.
#pragma once

#include <string>
#include <vector>

#include "csg/leaves/bezier.h"
#include "csg/leaves/shapes.h"

namespace cnrg {

/// The highest degree that is taken: bounds and vertices cost its square and more.
constexpr int kMostDegree = 32;

/// The Bézier pieces of a curve, in its direction. `what` begins messages, such as `bezier: curve 2`.
/// Throws InputError for what is wrong in the net: too few points, numbers that do not fit, weights, knots.
std::vector<BezierCurve> curve_pieces(const CurveNet& net, const std::string& what);

/// The Bézier pieces of a patch, spans of v from low to high, in each those of u.
std::vector<BezierPatch> patch_pieces(const PatchNet& net, const std::string& what);

}  // namespace cnrg
