// Names to OpenCASCADE's objects, and places on these; see the header.
//
// An exact affine map keeps a similar surface what it is. Any other map makes something else of it: an elliptic
// cylinder has no name there, but as a rational B-spline every one of these surfaces is mapped exactly, by its
// control points.
#include "csg/exports/occt_chart.h"

#include <ElSLib.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <algorithm>
#include <cmath>

#include "kernel/base/error.h"

namespace cnrg::occt {
namespace {

gp_Dir dir(const CadPoint& d) { return {d[0], d[1], d[2]}; }

gp_Ax3 axes_of(const CadAxes& axes) {
  gp_Ax3 result(pnt(axes.origin), dir(axes.z), dir(axes.x));
  if (result.YDirection().Dot(dir(axes.y)) < 0) result.YReverse();
  return result;
}

TColStd_Array1OfReal array_of(const std::vector<double>& list) {
  TColStd_Array1OfReal result(1, static_cast<int>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) result.SetValue(static_cast<int>(i) + 1, list[i]);
  return result;
}
TColStd_Array1OfInteger array_of(const std::vector<int>& list) {
  TColStd_Array1OfInteger result(1, static_cast<int>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) result.SetValue(static_cast<int>(i) + 1, list[i]);
  return result;
}

Handle(Geom_Curve) basis_of(const CadCurve& curve) {
  const gp_Ax2 axes(pnt(curve.axes.origin), dir(curve.axes.z), dir(curve.axes.x));
  switch (curve.kind) {
    case CadCurve::Kind::line: return new Geom_Line(pnt(curve.axes.origin), dir(curve.axes.x));
    case CadCurve::Kind::circle: return new Geom_Circle(axes, curve.radius);
    case CadCurve::Kind::ellipse: return new Geom_Ellipse(axes, curve.radius, curve.minor_radius);
    case CadCurve::Kind::spline: break;
    default: throw InputError("its profile is a curve of another kind, " + curve.name);
  }
  TColgp_Array1OfPnt points(1, static_cast<int>(curve.points.size()));
  TColStd_Array1OfReal weights(1, points.Length());
  for (int i = 1; i <= points.Length(); ++i) {
    const auto k = static_cast<std::size_t>(i - 1);
    points.SetValue(i, pnt(curve.points[k]));
    weights.SetValue(i, curve.weights.empty() ? 1 : curve.weights[k]);
  }
  return new Geom_BSplineCurve(points, weights, array_of(curve.knots.values), array_of(curve.knots.counts),
                               curve.knots.degree, curve.knots.periodic);
}

Handle(Geom_Surface) basis_of(const CadSurface& surface) {
  const gp_Ax3 axes = axes_of(surface.axes);
  switch (surface.kind) {
    case CadSurface::Kind::plane: return new Geom_Plane(axes);
    case CadSurface::Kind::cylinder: return new Geom_CylindricalSurface(axes, surface.radius);
    case CadSurface::Kind::cone: return new Geom_ConicalSurface(axes, surface.half_angle, surface.radius);
    case CadSurface::Kind::sphere: return new Geom_SphericalSurface(axes, surface.radius);
    case CadSurface::Kind::torus: return new Geom_ToroidalSurface(axes, surface.radius, surface.minor_radius);
    case CadSurface::Kind::extrusion:
      return new Geom_SurfaceOfLinearExtrusion(basis_of(surface.profile), dir(surface.axes.z));
    case CadSurface::Kind::revolution:
      return new Geom_SurfaceOfRevolution(basis_of(surface.profile),
                                          gp_Ax1(pnt(surface.axes.origin), dir(surface.axes.z)));
    case CadSurface::Kind::spline: break;
    default: throw InputError("it is a surface of another kind, " + surface.name);
  }
  const int across = static_cast<int>(surface.rows[0]), up = static_cast<int>(surface.rows[1]);
  TColgp_Array2OfPnt points(1, across, 1, up);
  TColStd_Array2OfReal weights(1, across, 1, up);
  for (int i = 1; i <= across; ++i) {
    for (int j = 1; j <= up; ++j) {
      const auto k = static_cast<std::size_t>((i - 1) * up + j - 1);
      points.SetValue(i, j, pnt(surface.points[k]));
      weights.SetValue(i, j, surface.weights.empty() ? 1 : surface.weights[k]);
    }
  }
  const auto& [u, v] = surface.knots;
  return new Geom_BSplineSurface(points, weights, array_of(u.values), array_of(v.values), array_of(u.counts),
                                 array_of(v.counts), u.degree, v.degree, u.periodic, v.periodic);
}

/// The square of the factor by which a map stretches everything; nothing if it stretches ways differently.
std::optional<Rational> square_of_scale(const Transform& map) {
  Rational square;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      Rational product = 0;
      for (std::size_t k = 0; k < 3; ++k) product += map.linear[k][i] * map.linear[k][j];
      if (i == 0) square = product;
      else if (product != (i == j ? square : Rational(0))) return std::nullopt;
    }
  }
  return square;
}

gp_Pnt moved_pole(const gp_Pnt& p, const Transform& map) {
  CadPoint result{};
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = to_double(map.offset[i]);
    for (std::size_t j = 0; j < 3; ++j)
      result[i] += to_double(map.linear[i][j]) * p.Coord(static_cast<int>(j) + 1);
  }
  return pnt(result);
}

gp_Trsf similarity(const Transform& map) {
  gp_Trsf result;
  const auto& m = map.linear;
  result.SetValues(to_double(m[0][0]), to_double(m[0][1]), to_double(m[0][2]), to_double(map.offset[0]),
                   to_double(m[1][0]), to_double(m[1][1]), to_double(m[1][2]), to_double(map.offset[1]),
                   to_double(m[2][0]), to_double(m[2][1]), to_double(m[2][2]), to_double(map.offset[2]));
  return result;
}

/// Points of a surface, for Newton's method.
class GeomSurface final : public Surface {
 public:
  explicit GeomSurface(Handle(Geom_Surface) surface) : surface_(std::move(surface)) {}
  SurfaceJet<double> at(double u, double v) const override {
    SurfaceJet<double> jet = jet_at(u, v);
    const auto length = [](const Vector3<double>& n) { return std::hypot(n[0], n[1], n[2]); };
    // At a pole: the normal beside it.
    double step = 1e-7;
    for (int i = 0; i < 6 && !(length(jet.normal) > 1e-9 * length(jet.along_u) * length(jet.along_v) &&
                               length(jet.normal) > 0);
         ++i, step *= -4)
      jet.normal = jet_at(u + step, v + step).normal;
    return jet;
  }
  SurfaceJet<Interval> over(const Interval&, const Interval&) const override {
    throw InvariantError("exports: a surface of OpenCASCADE has no intervals");
  }

 private:
  Handle(Geom_Surface) surface_;
  SurfaceJet<double> jet_at(double u, double v) const {
    gp_Pnt p;
    gp_Vec du, dv;
    surface_->D1(u, v, p, du, dv);
    return {numbers(p.XYZ()), numbers(du.XYZ()), numbers(dv.XYZ()), numbers(du.Crossed(dv).XYZ())};
  }
};

/// S at a fixed parameter, and as far from there along the normal as the second parameter says. What the normal
/// changes along the line is left out of the derivatives: near to the surface that is little.
class NormalStrip final : public Surface {
 public:
  NormalStrip(Handle(Geom_Surface) surface, std::size_t d, double value)
      : surface_(std::move(surface)), d_(d), value_(value) {}
  SurfaceJet<double> at(double along, double out) const override {
    const GeomSurface surface(surface_);
    const SurfaceJet<double> jet = d_ == 0 ? surface.at(value_, along) : surface.at(along, value_);
    const Vector3<double> way = d_ == 0 ? jet.along_v : jet.along_u;
    const double size = std::hypot(jet.normal[0], jet.normal[1], jet.normal[2]);
    const Vector3<double> normal = surface_math::scaled(1 / size, jet.normal);
    return {surface_math::sum(jet.point, surface_math::scaled(out, normal)), way, normal,
            surface_math::cross(way, normal)};
  }
  SurfaceJet<Interval> over(const Interval&, const Interval&) const override {
    throw InvariantError("exports: a surface of OpenCASCADE has no intervals");
  }

 private:
  Handle(Geom_Surface) surface_;
  std::size_t d_;
  double value_;
};

std::shared_ptr<const PlacedSurface> in_place(std::shared_ptr<const Surface> surface) {
  auto surfaces = std::make_shared<LeafSurfaces>();
  surfaces->add_patch(0, std::move(surface));
  return std::make_shared<const PlacedSurface>(std::move(surfaces), 0, Transform());
}

}  // namespace

Handle(Geom_Surface) surface_of(const SurfaceForm& form) {
  Handle(Geom_Surface) surface = basis_of(form.surface);
  if (form.placed.identity()) return surface;
  if (square_of_scale(form.placed)) {
    surface->Transform(similarity(form.placed));
    return surface;
  }
  if (surface->IsKind(STANDARD_TYPE(Geom_Plane)))
    throw InputError("it is a plane under a map that is no similarity");
  Handle(Geom_BSplineSurface) spline = Handle(Geom_BSplineSurface)::DownCast(surface);
  if (spline.IsNull()) {
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    surface->Bounds(u0, u1, v0, v1);
    if (Precision::IsInfinite(v0) || Precision::IsInfinite(v1))
      surface = new Geom_RectangularTrimmedSurface(surface, form.low[1], form.high[1], false);
    spline = GeomConvert::SurfaceToBSplineSurface(surface);
  }
  for (int i = 1; i <= spline->NbUPoles(); ++i) {
    for (int j = 1; j <= spline->NbVPoles(); ++j)
      spline->SetPole(i, j, moved_pole(spline->Pole(i, j), form.placed));
  }
  return spline;
}

Handle(Geom_Curve) curve_of(const CurveForm& form) {
  const Handle(Geom_Curve) curve = basis_of(form.curve);
  const Handle(Geom_BSplineCurve) spline = Handle(Geom_BSplineCurve)::DownCast(curve);
  require(!spline.IsNull(), "exports: a curve that is no spline");
  for (int i = 1; i <= spline->NbPoles(); ++i) spline->SetPole(i, moved_pole(spline->Pole(i), form.placed));
  return curve;
}

Chart::Chart(const SurfaceForm& form, double size) : surface_(surface_of(form)), size_(size) {
  low_ = form.low, high_ = form.high;
  flat_ = surface_->IsKind(STANDARD_TYPE(Geom_Plane));
  if (flat_) {
    const gp_Pln plane = Handle(Geom_Plane)::DownCast(surface_)->Pln();
    plane_ = {numbers(plane.Location().XYZ()), numbers(plane.Axis().Direction().XYZ())};
  }
  if (const auto elementary = Handle(Geom_ElementarySurface)::DownCast(surface_); !elementary.IsNull() && !flat_) {
    has_axis_ = true;
    axis_point_ = numbers(elementary->Location().XYZ());
    axis_ = numbers(elementary->Axis().Direction().XYZ());
  }
  if (const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(surface_); !revolution.IsNull()) {
    has_axis_ = true;
    axis_point_ = numbers(revolution->Location().XYZ());
    axis_ = numbers(revolution->Direction().XYZ());
  }
  settle();
}

Chart::Chart(const CadParts::Plane& plane, double size)
    : surface_(new Geom_Plane(pnt(plane.point), dir(plane.normal))), size_(size), flat_(true), plane_(plane) {
  settle();
}

void Chart::settle() {
  if (flat_) return;
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface_); !spline.IsNull()) {
    if (spline->IsUClosed() && !spline->IsUPeriodic()) spline->SetUPeriodic();
    if (spline->IsVClosed() && !spline->IsVPeriodic()) spline->SetVPeriodic();
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    spline->Bounds(u0, u1, v0, v1);
    low_ = {u0, v0}, high_ = {u1, v1};
  }
  if (surface_->IsUPeriodic()) period_[0] = surface_->UPeriod();
  if (surface_->IsVPeriodic()) period_[1] = surface_->VPeriod();
  placed_ = in_place(std::make_shared<const GeomSurface>(surface_));
}

Chart::Strip::Strip(const Chart& chart, std::size_t d, const CadParameters& at)
    : start_(at[1 - d]),
      reach_((chart.period_[1 - d] > 0 ? chart.period_[1 - d] : chart.high_[1 - d] - chart.low_[1 - d]) / 4),
      placed_(in_place(std::make_shared<const NormalStrip>(chart.surface_, d, at[d]))) {}

SurfaceSite Chart::Strip::site() const { return {placed_.get(), {start_, 0}, {reach_, HUGE_VAL}, {}, {}}; }

std::array<double, 2> Chart::slack() const {
  if (flat_) return {1e-9 * size_, 1e-9 * size_};
  std::array<double, 2> result{};
  for (std::size_t d = 0; d < 2; ++d) result[d] = 1e-6 * (period_[d] > 0 ? period_[d] : high_[d] - low_[d]);
  return result;
}

CadPoint Chart::point(const CadParameters& at) const { return numbers(surface_->Value(at[0], at[1]).XYZ()); }

std::optional<CadParameters> Chart::by_formula(const CadPoint& p) const {
  CadParameters at{};
  const gp_Pnt q = pnt(p);
  if (const auto plane = Handle(Geom_Plane)::DownCast(surface_); !plane.IsNull())
    ElSLib::Parameters(plane->Pln(), q, at[0], at[1]);
  else if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface_); !cylinder.IsNull())
    ElSLib::Parameters(cylinder->Cylinder(), q, at[0], at[1]);
  else if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface_); !cone.IsNull())
    ElSLib::Parameters(cone->Cone(), q, at[0], at[1]);
  else if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface_); !sphere.IsNull())
    ElSLib::Parameters(sphere->Sphere(), q, at[0], at[1]);
  else if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface_); !torus.IsNull())
    ElSLib::Parameters(torus->Torus(), q, at[0], at[1]);
  else return std::nullopt;
  return at;
}

/// Gauss and Newton: p is near to the surface, so this is fast.
std::optional<CadParameters> Chart::by_steps(const CadPoint& p, CadParameters at) const {
  const std::array<double, 2> reach = site(at).reach;
  for (int i = 0; i < 60; ++i) {
    gp_Pnt s;
    gp_Vec du, dv;
    surface_->D1(at[0], at[1], s, du, dv);
    const gp_Vec way(s, pnt(p));
    const double uu = du.Dot(du), uv = du.Dot(dv), vv = dv.Dot(dv), u = du.Dot(way), v = dv.Dot(way);
    const double determinant = uu * vv - uv * uv;
    CadParameters step{uu > 0 ? u / uu : 0, vv > 0 ? v / vv : 0};  // at a pole, along what there is
    if (determinant > 1e-20 * uu * vv) step = {(u * vv - v * uv) / determinant, (v * uu - u * uv) / determinant};
    for (std::size_t d = 0; d < 2; ++d) at[d] += std::clamp(step[d], -reach[d], reach[d]);
    if (!std::isfinite(at[0]) || !std::isfinite(at[1])) return std::nullopt;
    if (std::abs(step[0]) * std::sqrt(uu) + std::abs(step[1]) * std::sqrt(vv) <= 1e-14 * size_) return at;
  }
  return std::nullopt;
}

std::optional<CadParameters> Chart::place(const CadPoint& p, const std::optional<CadParameters>& near) const {
  std::optional<CadParameters> found = by_formula(p);
  if (!found && near) found = by_steps(p, *near);
  if (!found) {
    const GeomAPI_ProjectPointOnSurf search(pnt(p), surface_);
    if (search.NbPoints() == 0) return std::nullopt;
    CadParameters at{};
    search.LowerDistanceParameters(at[0], at[1]);
    found = at;
  }
  for (std::size_t d = 0; d < 2 && near; ++d) {
    if (period_[d] > 0) (*found)[d] -= period_[d] * std::round(((*found)[d] - (*near)[d]) / period_[d]);
  }
  return found;
}

bool Chart::is_free(std::size_t d, const CadParameters& at) const {
  if (flat_) return false;
  gp_Pnt p;
  gp_Vec du, dv;
  surface_->D1(at[0], at[1], p, du, dv);
  const double range = period_[d] > 0 ? period_[d] : high_[d] - low_[d];
  if ((d == 0 ? du : dv).Magnitude() * range > 1e-8 * size_) return false;
  // Not where it only stands still: a point of the same parameter elsewhere is the same one.
  CadParameters other = at;
  other[d] += range / 3;
  if (period_[d] == 0 && other[d] > high_[d]) other[d] = at[d] - range / 3;
  return surface_->Value(other[0], other[1]).Distance(p) <= 1e-8 * size_;
}

SurfaceSite Chart::site(const CadParameters& at) const {
  if (flat_) return {nullptr, {}, {}, plane_.point, plane_.normal};
  SurfaceSite result{placed_.get(), at, {}, {}, {}};
  for (std::size_t d = 0; d < 2; ++d) result.reach[d] = (period_[d] > 0 ? period_[d] : high_[d] - low_[d]) / 4;
  return result;
}

}  // namespace cnrg::occt
