// Where vertices and edges of a CAD model lie: on the true surfaces of all that is around them. Knows
// OpenCASCADE's types.
//
// Vertices and edges of a result lie on facets. Here a vertex is moved to the common point of its surfaces, and an
// edge is the curve of points that its surfaces have in common near to its chain: a line or circle where it is
// one, else a spline through so many of its points that it is within the tolerance of all its surfaces, which is
// measured between them.
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>

#include "csg/exports/occt_layout.h"

namespace cnrg::occt {

struct EdgeCurve {
  Handle(Geom_Curve) curve;
  double first = 0, last = 0;
  double off = 0;  ///< farthest from one of its surfaces, as measured
  bool spline = false;
};
struct PlaneCurve {
  Handle(Geom2d_Curve) curve;  ///< with the same parameters as the edge's
  CadParameters first{}, last{};
  double off = 0;  ///< farthest from the edge's curve
};

class CadCurves {
 public:
  using Index = CadParts::Index;
  /// `tolerance`: of splines. Faces whose vertices or edges have no place on all of their surfaces are added to
  /// `failed`, and then nothing else counts.
  CadCurves(const CadParts& parts, const CadLayout& layout, double tolerance, Faceted& failed);

  const CadPoint& point(Index number) const { return points_[number]; }
  const EdgeCurve& curve(Index piece) const { return curves_[piece]; }
  /// Throws InputError if there is none.
  PlaneCurve in_plane(const LaidFace& face, const PieceUse& use) const;

  std::size_t moved() const { return moved_; }
  double farthest() const { return farthest_; }

 private:
  const CadParts& parts_;
  const CadLayout& layout_;
  const double tolerance_;
  std::vector<CadPoint> points_;
  std::vector<EdgeCurve> curves_;
  std::vector<std::set<Index>> faces_of_piece_;  // their sources
  std::size_t moved_ = 0;
  double farthest_ = 0;

  void place_points(Faceted& failed);
  /// The point near to p that is on all surfaces there.
  std::optional<CadPoint> on_charts(Index p, const std::vector<Chart::Strip>& strips) const;
  /// Of a seam that ends in p: so that it runs along a line of one parameter.
  void add_strip(Index piece, Index p, const std::vector<char>& of_result,
                 std::vector<Chart::Strip>& strips) const;
  EdgeCurve make(Index piece) const;
  EdgeCurve on_given_curve(const Piece& piece) const;
  EdgeCurve line(const CadPoint& a, const CadPoint& b) const;
  std::optional<EdgeCurve> circle(const Piece& piece, const std::vector<CadPoint>& samples) const;
  /// The point on all surfaces of the piece near to another one; `near` goes along.
  std::optional<CadPoint> common(const Piece& piece, const CadPoint& guess, Index corner,
                                 std::map<const Chart*, CadParameters>& near) const;
  /// Points of the curve, in their order, from one end to the other.
  std::vector<CadPoint> guide(const Piece& piece) const;
  /// n + 1 points of the curve, as even as that goes.
  std::vector<CadPoint> sample(Index piece, const std::vector<CadPoint>& guide, std::size_t n) const;
  /// Straight in the parameters of the surface.
  std::vector<CadPoint> sample_seam(Index piece, std::size_t n) const;
  double off(const Piece& piece, const CadPoint& p, std::map<const Chart*, CadParameters>& near) const;
  std::optional<PieceUse> some_use(Index piece) const;
};

}  // namespace cnrg::occt
