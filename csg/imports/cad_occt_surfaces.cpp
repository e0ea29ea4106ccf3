// The surface of a face and the curve of an edge, from OpenCASCADE's objects to plain numbers.
//
// Nothing is computed but the place in an assembly, which OpenCASCADE applies. Trimmed surfaces and curves are
// those that they are cut from: the edges of a face, and the range of an edge, cut them anyway.
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
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
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "csg/imports/cad_occt.h"

namespace cnrg::occt {
namespace {

std::array<double, 3> numbers(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }

/// Of gp_Ax2 and gp_Ax3.
template <class Placement>
CadAxes axes_of(const Placement& at) {
  return {numbers(at.Location().XYZ()), numbers(at.XDirection().XYZ()), numbers(at.YDirection().XYZ()),
          numbers(at.Direction().XYZ())};
}

template <class Spline>
CadKnots curve_knots(const Spline& spline) {
  CadKnots knots{spline->Degree(), spline->IsPeriodic(), {}, {}};
  for (int i = 1; i <= spline->NbKnots(); ++i) {
    knots.values.push_back(spline->Knot(i));
    knots.counts.push_back(spline->Multiplicity(i));
  }
  return knots;
}

CadKnots bezier_knots(int degree) { return {degree, false, {0, 1}, {degree + 1, degree + 1}}; }

/// Points and weights of a B-spline or Bézier curve.
template <class Spline>
void take_points(const Spline& spline, CadCurve& curve) {
  curve.kind = CadCurve::Kind::spline;
  for (int i = 1; i <= spline->NbPoles(); ++i) {
    curve.points.push_back(numbers(spline->Pole(i).XYZ()));
    if (spline->IsRational()) curve.weights.push_back(spline->Weight(i));
  }
}

CadCurve part_of_curve(Handle(Geom_Curve) geometry, double first, double last) {
  CadCurve curve;
  curve.first = first;
  curve.last = last;
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(geometry)) geometry = trimmed->BasisCurve();
  curve.name = geometry->DynamicType()->Name();
  if (const auto line = Handle(Geom_Line)::DownCast(geometry)) {
    curve.kind = CadCurve::Kind::line;
    curve.axes.origin = numbers(line->Position().Location().XYZ());
    curve.axes.x = numbers(line->Position().Direction().XYZ());
  } else if (const auto circle = Handle(Geom_Circle)::DownCast(geometry)) {
    curve.kind = CadCurve::Kind::circle;
    curve.axes = axes_of(circle->Position());
    curve.radius = circle->Radius();
  } else if (const auto ellipse = Handle(Geom_Ellipse)::DownCast(geometry)) {
    curve.kind = CadCurve::Kind::ellipse;
    curve.axes = axes_of(ellipse->Position());
    curve.radius = ellipse->MajorRadius();
    curve.minor_radius = ellipse->MinorRadius();
  } else if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(geometry)) {
    take_points(spline, curve);
    curve.knots = curve_knots(spline);
  } else if (const auto bezier = Handle(Geom_BezierCurve)::DownCast(geometry)) {
    take_points(bezier, curve);
    curve.knots = bezier_knots(bezier->Degree());
  } else {
    curve.kind = CadCurve::Kind::other;
  }
  return curve;
}

CadCurve profile_of(const Handle(Geom_Curve) & geometry) {
  return part_of_curve(geometry, geometry->FirstParameter(), geometry->LastParameter());
}

/// Points and weights of a B-spline or Bézier surface.
template <class Spline>
void take_net(const Spline& spline, CadSurface& surface) {
  surface.kind = CadSurface::Kind::spline;
  surface.rows = {static_cast<std::uint32_t>(spline->NbUPoles()), static_cast<std::uint32_t>(spline->NbVPoles())};
  const bool weighted = spline->IsURational() || spline->IsVRational();
  for (int i = 1; i <= spline->NbUPoles(); ++i) {
    for (int j = 1; j <= spline->NbVPoles(); ++j) {
      surface.points.push_back(numbers(spline->Pole(i, j).XYZ()));
      if (weighted) surface.weights.push_back(spline->Weight(i, j));
    }
  }
}

std::array<CadKnots, 2> surface_knots(const Handle(Geom_BSplineSurface) & spline) {
  std::array<CadKnots, 2> knots{CadKnots{spline->UDegree(), spline->IsUPeriodic(), {}, {}},
                                CadKnots{spline->VDegree(), spline->IsVPeriodic(), {}, {}}};
  for (int i = 1; i <= spline->NbUKnots(); ++i) {
    knots[0].values.push_back(spline->UKnot(i));
    knots[0].counts.push_back(spline->UMultiplicity(i));
  }
  for (int i = 1; i <= spline->NbVKnots(); ++i) {
    knots[1].values.push_back(spline->VKnot(i));
    knots[1].counts.push_back(spline->VMultiplicity(i));
  }
  return knots;
}

/// Plane, cylinder, cone, sphere, torus; false for others.
bool take_elementary(const Handle(Geom_Surface) & geometry, CadSurface& surface) {
  const auto elementary = Handle(Geom_ElementarySurface)::DownCast(geometry);
  if (elementary.IsNull()) return false;
  surface.axes = axes_of(elementary->Position());
  if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(geometry)) {
    surface.kind = CadSurface::Kind::cylinder;
    surface.radius = cylinder->Radius();
  } else if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(geometry)) {
    surface.kind = CadSurface::Kind::cone;
    surface.radius = cone->RefRadius();
    surface.half_angle = cone->SemiAngle();
  } else if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(geometry)) {
    surface.kind = CadSurface::Kind::sphere;
    surface.radius = sphere->Radius();
  } else if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(geometry)) {
    surface.kind = CadSurface::Kind::torus;
    surface.radius = torus->MajorRadius();
    surface.minor_radius = torus->MinorRadius();
  } else if (geometry->IsKind(STANDARD_TYPE(Geom_Plane))) {
    surface.kind = CadSurface::Kind::plane;
  }
  return true;
}

}  // namespace

CadSurface surface_of(const TopoDS_Face& face) {
  CadSurface surface;
  surface.turned = face.Orientation() == TopAbs_REVERSED;
  Handle(Geom_Surface) geometry = BRep_Tool::Surface(face);
  while (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(geometry))
    geometry = trimmed->BasisSurface();
  if (geometry.IsNull()) return surface;
  surface.name = geometry->DynamicType()->Name();
  if (take_elementary(geometry, surface)) return surface;
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(geometry)) {
    take_net(spline, surface);
    surface.knots = surface_knots(spline);
  } else if (const auto bezier = Handle(Geom_BezierSurface)::DownCast(geometry)) {
    take_net(bezier, surface);
    surface.knots = {bezier_knots(bezier->UDegree()), bezier_knots(bezier->VDegree())};
  } else if (const auto extrusion = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(geometry)) {
    surface.kind = CadSurface::Kind::extrusion;
    surface.axes.z = numbers(extrusion->Direction().XYZ());
    surface.profile = profile_of(extrusion->BasisCurve());
  } else if (const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(geometry)) {
    surface.kind = CadSurface::Kind::revolution;
    surface.axes.origin = numbers(revolution->Location().XYZ());
    surface.axes.z = numbers(revolution->Direction().XYZ());
    surface.profile = profile_of(revolution->BasisCurve());
  }
  return surface;
}

CadCurve curve_of(const TopoDS_Edge& edge) {
  double first = 0, last = 0;
  const Handle(Geom_Curve) geometry = BRep_Tool::Curve(edge, first, last);
  return geometry.IsNull() ? CadCurve() : part_of_curve(geometry, first, last);
}

}  // namespace cnrg::occt
