// How far a facet is from its curved patch, and a wire's segment from its curve: proven bounds.
//
// Let a triangle of parameters have the extents Hu and Hv, and let L be the linear map that agrees with S at its
// corners p_i. At p = sum l_i p_i, Taylor's formula along each p_i - p gives
//   |S(p) - L(p)| <= 1/2 sum l_i sup |D2 S [p_i - p, p_i - p]|
//                 <= 1/2 sum l_i (Muu du_i^2 + 2 Muv |du_i dv_i| + Mvv dv_i^2)
// with Muu, Muv, Mvv the largest lengths of the second derivatives. sum l_i du_i^2 is a variance of numbers in an
// interval of length Hu, at most Hu^2 / 4 (Popoviciu), and by Cauchy and Schwarz sum l_i |du_i dv_i| <= Hu Hv / 4:
//   |S(p) - L(p)| <= (Muu Hu^2 + 2 Muv Hu Hv + Mvv Hv^2) / 8                              (cf. filip1986)
// for any triangle, whatever its shape. For a curve: M H^2 / 8.
//
// Derivatives are bounded by control nets. For S = Q / w with positive weights, |S| <= R, w >= W and
//   |S_u| <= (|Q_u| + R |w_u|) / W
//   |S_uu| <= (|Q_uu| + R |w_uu| + 2 |S_u| |w_u|) / W
//   |S_uv| <= (|Q_uv| + R |w_uv| + |S_u| |w_v| + |S_v| |w_u|) / W,
// each term at most the largest control vector of its own Bernstein form. Nets are doubles here, taken about the
// middle of the control points; every rounding of a step is bounded and added, so the bounds hold, and they are
// the same on every machine (sums, products and roots of doubles, nothing contracted).
#pragma once

#include <array>
#include <vector>

#include "csg/curves/bezier.h"

namespace cnrg {

/// Bounds of the terms of the formula above, for one box of parameters of extents Hu and Hv: uu = Muu Hu^2 / 8,
/// uv = Muv Hu Hv / 8, vv = Mvv Hv^2 / 8.
struct ChordTerms {
  double uu = 0, uv = 0, vv = 0;
  /// The bound of the distance.
  double sum() const { return (uu + 2 * uv + vv) * (1 + 1e-12); }
};

class PatchChord {
 public:
  explicit PatchChord(const BezierPatch& patch);
  /// For 0 <= low < high <= 1 in u and v; parameters are fractions with at most 24 binary digits.
  ChordTerms terms(const std::array<double, 2>& low, const std::array<double, 2>& high) const;

 private:
  using Entry = std::array<double, 4>;
  using Net = std::vector<std::vector<Entry>>;
  Net part(const std::array<double, 2>& low, const std::array<double, 2>& high) const;

  Net net_;
  bool rational_ = false;
  double error_ = 0, weight_error_ = 0;  // of an entry of any part of the net
};

}  // namespace cnrg
