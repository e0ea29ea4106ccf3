// Shapes to names and numbers; see the header.
#include "csg/curves/surface_forms.h"

#include <numbers>

#include "csg/curves/control_nets.h"
#include "csg/curves/revolved.h"
#include "csg/geometry/circle.h"
#include "kernel/base/hypotenuse.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

constexpr double kPi = std::numbers::pi;
using Point = std::array<double, 3>;

Point rounded_unit(const RationalPoint& v) {
  const Point d = to_doubles(v);
  const double length = hypotenuse(d[0], d[1], d[2]);
  return {d[0] / length, d[1] / length, d[2] / length};
}

CadAxes axes_of(const RationalPoint& origin, const RationalPoint& axis) {
  const CircleFrame frame(axis);
  return {to_doubles(origin), rounded_unit(frame.first()), rounded_unit(frame.second()),
          rounded_unit(frame.axis())};
}

Point along(const Point& p, double s, const Point& direction) {
  return {p[0] + s * direction[0], p[1] + s * direction[1], p[2] + s * direction[2]};
}

/// The domain of a surface is what parameters from 0 to 1 have.
void cover_unit_square(SurfaceForm& form) {
  for (std::size_t d = 0; d < 2; ++d) {
    form.low[d] = std::min(form.zero[d], form.one[d]);
    form.high[d] = std::max(form.zero[d], form.one[d]);
  }
}

/// A cone, or with equal radii a cylinder, from one circle about the axis through its origin to another, which is
/// `height` farther along it.
SurfaceForm slanted(CadAxes axes, double from, double to, double height) {
  SurfaceForm form;
  form.surface.axes = axes;
  form.surface.radius = from;
  const bool straight = from == to;
  form.surface.kind = straight ? CadSurface::Kind::cylinder : CadSurface::Kind::cone;
  if (!straight) form.surface.half_angle = rounded::arc_tangent(to - from, height);
  form.one = {2 * kPi, straight ? height : hypotenuse(to - from, height)};
  cover_unit_square(form);
  return form;
}

CadKnots cad_knots(int degree, const std::vector<Rational>& given, std::size_t points) {
  CadKnots knots;
  if (degree == 0) {
    knots.degree = static_cast<int>(points) - 1;
    knots.values = {0, 1};
    knots.counts = {knots.degree + 1, knots.degree + 1};
    return knots;
  }
  knots.degree = degree;
  for (const Rational& knot : given.empty() ? clamped_knots(points, static_cast<std::size_t>(degree)) : given) {
    const double value = to_double(knot);
    if (!knots.values.empty() && knots.values.back() == value) ++knots.counts.back();
    else knots.values.push_back(value), knots.counts.push_back(1);
  }
  return knots;
}

/// Where a spline begins and ends.
std::array<double, 2> domain(const CadKnots& knots) {
  std::vector<double> all;
  for (std::size_t i = 0; i < knots.values.size(); ++i)
    all.insert(all.end(), static_cast<std::size_t>(knots.counts[i]), knots.values[i]);
  const auto degree = static_cast<std::size_t>(knots.degree);
  return {all[degree], all[all.size() - 1 - degree]};
}

std::vector<double> weights_of(const std::vector<Rational>& weights) {
  std::vector<double> result;
  for (const Rational& w : weights) result.push_back(to_double(w));
  return result;
}

CadCurve spline_of(const CurveNet& net, const std::function<Point(const RationalPoint&)>& place) {
  CadCurve curve;
  curve.kind = CadCurve::Kind::spline;
  for (const RationalPoint& p : net.points) curve.points.push_back(place(p));
  curve.weights = weights_of(net.weights);
  curve.knots = cad_knots(net.degree, net.knots, net.points.size());
  const auto [first, last] = domain(curve.knots);
  curve.first = first, curve.last = last;
  return curve;
}

}  // namespace

SurfaceForm cone_form(const ConeShape& shape) {
  const RationalPoint way = shape.to - shape.from;
  const Point d = to_doubles(way);
  return slanted(axes_of(shape.from, way), to_double(shape.radius), to_double(shape.top),
                 hypotenuse(d[0], d[1], d[2]));
}

SurfaceForm sphere_form(const RationalPoint& center, const Rational& radius, const RationalPoint& axis) {
  SurfaceForm form;
  form.surface.kind = CadSurface::Kind::sphere;
  form.surface.axes = axes_of(center, axis);
  form.surface.radius = to_double(radius);
  form.zero = {0, -kPi / 2};
  form.one = {2 * kPi, kPi / 2};
  cover_unit_square(form);
  return form;
}

SurfaceForm torus_form(const TorusShape& shape) {
  SurfaceForm form;
  form.surface.kind = CadSurface::Kind::torus;
  form.surface.axes = axes_of(shape.center, shape.axis);
  form.surface.radius = to_double(shape.radius);
  form.surface.minor_radius = to_double(shape.tube);
  form.one = {2 * kPi, 2 * kPi};
  cover_unit_square(form);
  return form;
}

SurfaceForm revolved_form(const RevolveShape& shape, const CurveNet& segment) {
  const CadAxes axes = axes_of(shape.center, shape.axis);
  const double turn = to_double(shape.degrees) / 180 * kPi;
  const auto above = [&](const Rational& z) {
    CadAxes moved = axes;
    moved.origin = along(axes.origin, to_double(z), axes.z);
    return moved;
  };
  SurfaceForm form;
  const std::vector<BezierCurve> pieces = curve_pieces(segment, "revolve");
  if (pieces.size() == 1) {
    const MeridianPiece piece = meridian_piece(pieces[0], {0, 1}, 1);
    const MeridianPoint &from = piece.from, &to = piece.to;
    if (piece.kind == MeridianPiece::Kind::line) {
      const bool up = from.t < to.t;
      const MeridianPoint &low = up ? from : to, &high = up ? to : from;
      form = slanted(above(low.t), to_double(low.r), to_double(high.r), to_double(Rational(high.t - low.t)));
      if (!up) std::swap(form.zero[1], form.one[1]);
      form.one[0] = form.high[0] = turn;
      form.swapped = true;
      return form;
    }
    if (piece.kind == MeridianPiece::Kind::arc && piece.middle.r >= 0) {
      const bool sphere = piece.middle.r == 0;
      form.surface.kind = sphere ? CadSurface::Kind::sphere : CadSurface::Kind::torus;
      form.surface.axes = above(piece.middle.t);
      form.surface.radius = to_double(sphere ? piece.radius : piece.middle.r);
      if (!sphere) form.surface.minor_radius = to_double(piece.radius);
      form.zero[1] = to_double(piece.start) / 180 * kPi;
      form.one = {turn, to_double(Rational(piece.start + piece.sweep)) / 180 * kPi};
      form.swapped = true;
      cover_unit_square(form);
      return form;
    }
  }
  form.surface.kind = CadSurface::Kind::revolution;
  form.surface.axes = axes;
  form.surface.profile = spline_of(segment, [&](const RationalPoint& p) {
    return along(along(axes.origin, to_double(p[0]), axes.x), to_double(p[2]), axes.z);
  });
  form.swapped = true;
  form.one = {turn, 1};
  cover_unit_square(form);
  form.low[1] = form.surface.profile.first, form.high[1] = form.surface.profile.last;
  return form;
}

std::optional<SurfaceForm> extruded_form(const ExtrudeShape& shape, const RationalPoint& center,
                                         const CurveNet& segment) {
  if (shape.twist != 0) return std::nullopt;
  if (shape.scale == 1) {
    SurfaceForm form;
    form.surface.kind = CadSurface::Kind::extrusion;
    form.surface.axes.z = rounded_unit(shape.vector);
    form.surface.profile = spline_of(segment, [](const RationalPoint& p) { return to_doubles(p); });
    const Point way = to_doubles(shape.vector);
    form.one = {1, hypotenuse(way[0], way[1], way[2])};
    cover_unit_square(form);
    form.low[0] = form.surface.profile.first, form.high[0] = form.surface.profile.last;
    return form;
  }
  // Straight from each point of the profile to its image.
  PatchNet net{.points = {segment.points, {}},
               .weights = {},
               .degree = {segment.degree, segment.degree == 0 ? 0 : 1},
               .knots = {segment.knots, {}}};
  for (const RationalPoint& p : segment.points)
    net.points[1].push_back(center + shape.scale * (p - center) + shape.vector);
  if (!segment.weights.empty()) net.weights = {segment.weights, segment.weights};
  return net_form(net);
}

SurfaceForm net_form(const PatchNet& net) {
  SurfaceForm form;
  CadSurface& surface = form.surface;
  surface.kind = CadSurface::Kind::spline;
  const std::size_t across = net.points[0].size(), up = net.points.size();
  surface.rows = {static_cast<std::uint32_t>(across), static_cast<std::uint32_t>(up)};
  for (std::size_t i = 0; i < across; ++i) {
    for (std::size_t j = 0; j < up; ++j) {
      surface.points.push_back(to_doubles(net.points[j][i]));
      if (!net.weights.empty()) surface.weights.push_back(to_double(net.weights[j][i]));
    }
  }
  surface.knots = {cad_knots(net.degree[0], net.knots[0], across), cad_knots(net.degree[1], net.knots[1], up)};
  for (std::size_t d = 0; d < 2; ++d) {
    const auto [low, high] = domain(surface.knots[d]);
    form.low[d] = low, form.high[d] = high;
  }
  return form;
}

CurveForm curve_form(const CurveNet& net) {
  return {spline_of(net, [](const RationalPoint& p) { return to_doubles(p); }), {}};
}

}  // namespace cnrg
