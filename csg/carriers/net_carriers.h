// The surface that carries a Bézier patch, and the curve that carries a Bézier curve: the whole of what its
// polynomials describe, of which the net shows one rectangle or one interval.
//
// Two nets, P and Q, lie on one carrier in the sense of this file if Q(u, v) = k P(a u + b, c v + d) in
// homogeneous coordinates, or the same with u and v exchanged, for rational a, b, c, d and k > 0. So a patch and
// its sub-patches have one carrier, also run backward, transposed, of raised degree, with weights in proportion.
// To compare control points would not do: those of a sub-patch are other points. Instead each net is brought to a
// form without a, b, c, d, k as far as rational numbers can, which is looked up in a table, and the rest is solved
// for:
//   * b and d: coefficients of the power basis next to the leading ones are made zero, as for a cubic equation;
//   * k: of each coefficient only its direction (a point of projective space) counts for the look-up;
//   * a and c: those of two nets with equal directions follow from the ratios of coefficients, which must be
//     k a^i c^j: roots of rational numbers. The equation is then checked for all coefficients.
// What this does not find: reparametrizations by fractions, u -> (a u + b) / (e u + f), which leave the surface of
// a rational patch but move its lines of parameters in another way; weights with a common polynomial factor; and
// surfaces that are equal as sets of points only, by other polynomials. Such patches have carriers of their own.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "csg/curves/bezier.h"

namespace cnrg {

/// Coefficients of u^i v^j, [i][j]; of a curve j = 0 only. No degree is higher than it has to be.
using PowerBasis = std::vector<std::vector<Homogeneous>>;
PowerBasis power_basis(const BezierPatch& patch);
PowerBasis power_basis(const ControlRow& row);

/// Where a curve lies on its carrier: the carrier's parameters at its beginning and its end.
struct OnCurve {
  std::size_t carrier;
  std::array<Rational, 2> at;
};

class CurveCarriers {
 public:
  /// Nothing for straight lines (the kernel sees where they overlap, wherever they have vertices) and points.
  /// `kind` parts curves that are not to be compared, such as the projections along different vectors.
  std::optional<OnCurve> place(const ControlRow& net, const RationalPoint& kind = {0, 0, 0});

 private:
  std::map<std::pair<RationalPoint, PowerBasis>, std::vector<std::size_t>> known_;  // by directions
  std::vector<PowerBasis> carriers_;
};

/// Where a patch lies on its carrier: along u, then along v, the carrier's parameters at 0 and at 1. `axis`: which
/// of the carrier's two parameters it is, 0 or 1.
struct OnSurface {
  std::size_t carrier;
  std::array<std::size_t, 2> axis{0, 1};
  std::array<std::array<Rational, 2>, 2> at;
};

class SurfaceCarriers {
 public:
  /// Nothing for parallelograms, which are flat and filled by any facets, and for what has no area.
  std::optional<OnSurface> place(const BezierPatch& patch);

 private:
  std::map<PowerBasis, std::vector<std::size_t>> known_;  // by directions
  std::vector<PowerBasis> carriers_;
};

}  // namespace cnrg
