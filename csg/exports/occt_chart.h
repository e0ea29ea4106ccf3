// A surface as OpenCASCADE has it, with the search for places on it. Knows OpenCASCADE's types.
#pragma once

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <array>
#include <gp_Pnt.hxx>
#include <memory>
#include <optional>

#include "csg/curves/surface_placed.h"
#include "csg/exports/cad_parts.h"

namespace cnrg::occt {

inline gp_Pnt pnt(const CadPoint& p) { return {p[0], p[1], p[2]}; }
inline CadPoint numbers(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }

/// Throws Standard_Failure or InputError for what OpenCASCADE cannot hold.
Handle(Geom_Surface) surface_of(const SurfaceForm& form);
Handle(Geom_Curve) curve_of(const CurveForm& form);

class Chart {
 public:
  explicit Chart(const SurfaceForm& form, double size);
  explicit Chart(const CadParts::Plane& plane, double size);

  const Handle(Geom_Surface) & surface() const { return surface_; }
  bool flat() const { return flat_; }
  /// 0: none.
  const std::array<double, 2>& period() const { return period_; }
  /// What two parameters of one point may differ by.
  std::array<double, 2> slack() const;
  /// An axis about which the surface turns, if it has one.
  bool has_axis() const { return has_axis_; }
  const CadPoint& axis_point() const { return axis_point_; }
  const CadPoint& axis() const { return axis_; }

  CadPoint point(const CadParameters& at) const;
  /// Those of the place next to p, whole periods from `near` at most half a one; without it found from nothing.
  std::optional<CadParameters> place(const CadPoint& p, const std::optional<CadParameters>& near) const;
  /// True if the surface shrinks to a point along that parameter.
  bool is_free(std::size_t d, const CadParameters& at) const;
  /// For find_common.
  SurfaceSite site(const CadParameters& at) const;
  /// The surface of all normals along the line on which parameter d is that of `at`.
  class Strip {
   public:
    Strip(const Chart& chart, std::size_t d, const CadParameters& at);
    SurfaceSite site() const;

   private:
    double start_, reach_;
    std::shared_ptr<const PlacedSurface> placed_;
  };

 private:
  Handle(Geom_Surface) surface_;
  double size_;
  bool flat_ = false, has_axis_ = false;
  std::array<double, 2> period_{0, 0}, low_{0, 0}, high_{0, 0};
  CadPoint axis_point_{}, axis_{};
  CadParts::Plane plane_;
  std::shared_ptr<const PlacedSurface> placed_;

  void settle();
  /// By the formula of an elementary surface.
  std::optional<CadParameters> by_formula(const CadPoint& p) const;
  std::optional<CadParameters> by_steps(const CadPoint& p, CadParameters at) const;
};

}  // namespace cnrg::occt
