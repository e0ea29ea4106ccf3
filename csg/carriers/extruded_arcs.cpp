// Finds the curves of a profile that are arcs of circles, and the parts of cylinders that they sweep.
#include "csg/carriers/extruded_arcs.h"

#include <cmath>
#include <numbers>

#include "csg/geometry/circle.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

ExtrudeShape shape_image(const ExtrudeShape& shape, const Transform& transform) {
  ExtrudeShape result = shape;
  result.vector = transform.apply_to_vector(shape.vector);
  result.center.reset();
  for (ProfileLine& line : result.profile.lines) {
    for (CurveNet& net : line.segments) {
      for (RationalPoint& p : net.points) p = transform.apply(p);
    }
  }
  return result;
}

/// The same steps of curves where a transform puts these.
std::shared_ptr<const AgreedSteps> steps_image(const AgreedSteps& steps, const Transform& transform) {
  auto result = std::make_shared<AgreedSteps>();
  for (const auto& [net, of] : steps) {
    BezierCurve curve{net};
    for (Homogeneous& h : curve.net) h = homogeneous(transform.apply(project(h)), h[3]);
    const CanonicalCurve there = canonical(curve);
    const std::vector<Rational> lines = CurveSteps{1, of.lines}.inside(there.reversed);
    (*result)[there.curve.net] = {of.even, {lines.begin(), lines.end()}};
  }
  return result;
}

/// The arc that a curve is, swept along `vector`: a curve in a plane across it.
std::optional<ExtrudedArc> arc_of(const BezierCurve& curve, const RationalPoint& vector) {
  const ControlRow row = reduced(curve.net);
  if (row.size() != 3) return std::nullopt;
  const RationalPoint p0 = project(row[0]), p1 = project(row[1]), p2 = project(row[2]);
  const RationalPoint middle = Rational(1, 2) * (p0 + p2), normal = cross(p1 - p0, p2 - p0);
  if (is_zero(normal) || !is_zero(cross(normal, vector))) return std::nullopt;
  const auto reach =
      center_of_arc(row, dot(p1 - p0, p1 - p0), dot(p1 - p2, p1 - p2), dot(p0 - middle, p0 - middle));
  if (!reach) return std::nullopt;
  const RationalPoint center = p1 + *reach * (middle - p1);
  const std::optional<Rational> radius = rational_root(dot(p0 - center, p0 - center));
  if (!radius) return std::nullopt;
  ExtrudedArc arc;
  arc.curve = curve;
  arc.placed.axis = axis_line(center, vector);
  arc.placed.along = dot(normal, arc.placed.axis.direction) > 0;
  arc.placed.start = (1 / *radius) * (p0 - center);
  arc.placed.end = (1 / *radius) * (p2 - center);
  MeridianPiece ruling;
  ruling.from = {*radius, arc.placed.axis.place_of(center)};
  ruling.to = {*radius, arc.placed.axis.place_of(center + vector)};
  arc.placed.lines = {{ruling}};
  const double half = rounded::arc_cosine(std::sqrt(to_double(1 - 1 / *reach)));
  arc.degrees = from_double(half * 360 / std::numbers::pi);
  return arc;
}

}  // namespace

Rational ExtrudedArc::parameter(const Rational& turn) const {
  MeridianPiece arc;
  arc.kind = MeridianPiece::Kind::arc;
  arc.sweep = degrees;
  arc.net = curve;
  return parameter_of(arc, turn * degrees);
}

std::vector<ExtrudedArc> arcs_of(const ExtrudeForm& form, const Transform& transform) {
  const ExtrudeShape placed = shape_image(form.shape, transform);
  BoundaryCurves boundary(form.fineness, form.steps.get());
  std::vector<ExtrudedArc> result;
  std::uint32_t number = 0;
  for (std::size_t l = 0; l < placed.profile.lines.size(); ++l) {
    for (std::size_t s = 0; s < placed.profile.lines[l].segments.size(); ++s, ++number) {
      const std::vector<BezierCurve> pieces = curve_pieces(placed.profile.lines[l].segments[s], "extrude");
      const std::vector<BezierCurve> given = curve_pieces(form.shape.profile.lines[l].segments[s], "extrude");
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        std::optional<ExtrudedArc> arc = arc_of(pieces[k], placed.vector);
        if (!arc) continue;
        arc->segment = number;
        arc->piece = k;
        arc->segments =
            static_cast<int>(std::ceil(boundary.steps(given[k]) * 360 / to_double(arc->degrees) - 1e-9));
        result.push_back(std::move(*arc));
      }
    }
  }
  return result;
}

std::unique_ptr<PreparedLeaf> extrude_anew(const ExtrudeForm& form, const Transform& transform,
                                           FixedSamples fixed) {
  const auto sweep = std::make_shared<CommonSweep>();
  sweep->shape = shape_image(form.shape, transform);
  sweep->mirrored = form.mirrored != (transform.determinant() < 0);
  if (form.steps) sweep->steps = transform == Transform() ? form.steps : steps_image(*form.steps, transform);
  sweep->heights = form.heights;
  sweep->fixed = std::move(fixed);
  return tessellate(sweep);
}

bool overlap(const PlacedForm& a, const PlacedForm& b) {
  const RationalPoint& axis = a.axis.direction;
  const auto inside = [&](const PlacedForm& arc, const RationalPoint& d) {
    const RationalPoint &from = arc.along ? arc.start : arc.end, &to = arc.along ? arc.end : arc.start;
    return dot(cross(from, d), axis) > 0 && dot(cross(d, to), axis) > 0;
  };
  return inside(a, b.start) || inside(a, b.end) || inside(b, a.start) || inside(b, a.end) ||
         (a.start == b.start && a.end == b.end) || (a.start == b.end && a.end == b.start);
}

bool same_arc(const ExtrudedArc& a, const ExtrudedArc& b) {
  const ControlRow p = reduced(a.curve.net), q = reduced(b.curve.net);
  const Rational one = p[2][3] / p[0][3], other = q[2][3] / q[0][3];
  if (a.placed.start == b.placed.start && a.placed.end == b.placed.end) return one == other;
  return a.placed.start == b.placed.end && a.placed.end == b.placed.start && one * other == 1;
}

}  // namespace cnrg
