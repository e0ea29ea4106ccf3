// Curves and patches of Bézier pieces with the spans of their parameters, as values and enclosures.
//
// Over a box a net is cut to the box, by its blossom in intervals; what it then is a mean of, its control points,
// is what it can be. Derivatives are nets of their own, made of exact differences: to take differences of control
// points that are known to an interval would divide an error by the size of the box.
#pragma once

#include <vector>

#include "csg/curves/bezier.h"
#include "csg/curves/control_nets.h"
#include "csg/curves/surface_math.h"

namespace cnrg {

using ConstantRow = std::vector<std::array<surface_math::Constant, 4>>;

class SplineCurve final : public Curve {
 public:
  SplineCurve(const std::vector<BezierCurve>& pieces, const std::vector<Span>& spans);
  CurveJet<double> at(double t) const override { return jet(t); }
  CurveJet<Interval> over(const Interval& t) const override {
    const enclosure::RoundOutward outward;
    return jet(t);
  }
  template <class N>
  CurveJet<N> jet(const N& t) const;

 private:
  struct Piece {
    surface_math::Constant from, size;       // of the span
    Vector3<surface_math::Constant> origin;  // the net is relative to it, so that products stay small
    ConstantRow net, derivative;             // homogeneous; by the piece's own parameter
    bool polynomial = false;                 // all weights are 1
  };
  std::vector<Piece> pieces_;
};

class SplinePatch final : public surface_math::SurfaceByJet<SplinePatch> {
 public:
  SplinePatch(const std::vector<BezierPatch>& pieces, const std::vector<std::array<Span, 2>>& spans);
  /// Of polynomials.
  std::optional<Vector3<Interval>> fan_over(std::size_t around, double pole, const Interval& u,
                                            const Interval& v) const override;

 private:
  friend class surface_math::SurfaceByJet<SplinePatch>;
  template <class N>
  SurfaceJet<N> jet(const N& u, const N& v) const;
  /// Calls body(piece, its own parameters) for each piece that is there.
  template <class N, class Body>
  void for_each_piece(const N& u, const N& v, const Body& body) const;

  using Net = std::vector<ConstantRow>;
  struct Piece {
    std::array<surface_math::Constant, 2> from, size;
    Vector3<surface_math::Constant> origin;
    Net net, along_u, along_v, twist;  // twist: along u and v
    bool polynomial = false;
  };
  std::vector<Piece> pieces_;
  /// Values of u and of v at which the patch, all of polynomials, is one point.
  std::array<std::vector<double>, 2> poles_;
};

}  // namespace cnrg
