// Control nets as the shapes have them, checked, as Bézier pieces.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "csg/curves/bezier.h"
#include "csg/leaves/shapes.h"

namespace cnrg {

/// The highest degree that is taken: bounds and vertices cost its square and more.
constexpr int kMostDegree = 32;

/// The Bézier pieces of a curve, in its direction. `what` begins messages, such as `bezier: curve 2`.
/// Throws InputError for what is wrong in the net: too few points, numbers that do not fit, weights, knots.
std::vector<BezierCurve> curve_pieces(const CurveNet& net, const std::string& what);

/// The Bézier pieces of a patch, spans of v from low to high, in each those of u.
std::vector<BezierPatch> patch_pieces(const PatchNet& net, const std::string& what);

/// The parameters of a curve between which a piece of it runs: two knots, or 0 and 1 without knots.
using Span = std::array<Rational, 2>;
/// The parameter at t of a piece, 0 <= t <= 1.
inline Rational in_span(const Span& span, const Rational& t) { return span[0] + t * (span[1] - span[0]); }
/// Those of all pieces of a curve that `curve_pieces` takes, in their order.
std::vector<Span> curve_spans(const CurveNet& net);
/// Those of all pieces of a patch that `patch_pieces` takes, along u and along v.
std::vector<std::array<Span, 2>> patch_spans(const PatchNet& net);

}  // namespace cnrg
