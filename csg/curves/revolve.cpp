// Revolution: S(u, a) = c + r(u) d(a) + z(u) n, with directions d(a) that are off by less than 4e-16 (circle.h).
//
// The same directions serve every point of the profile, so the chords of two circles are parallel, and a facet is
// a planar quadrilateral, exactly. The profile's polygon is within chord / 2 of the profile, and the facets are
// within chord / 2 of the revolution of that polygon: through each of its points a facet has a chord from S(u, a)
// to S(u, a + h), which is within r h^2 / 8 of the arc.
//
// The end of a partial turn is the start under Transform::rotation, exactly: there it meets what is rotated.
//
// Of a partial turn the caps are faces 0 (start) and 1; each segment of the profile is one more. Without caps the
// segments are from 0. Segments on the axis sweep nothing.
//
// Parameters (parameters.h): u is that of the segment's own curve, from 0 to 1 (between its knots for a spline), v
// the fraction of the turn made, from 0 to 1. Caps have none.
#include <algorithm>

#include "csg/curves/profile.h"
#include "csg/curves/revolved.h"
#include "csg/geometry/circle.h"
#include "csg/geometry/planar_polygon.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

void check(const RevolveShape& shape) {
  if (is_zero(shape.axis)) throw LeafKeyError("axis", "revolve: the axis is [0, 0, 0]: give a direction");
  if (shape.degrees <= 0 || shape.degrees > 360) {
    throw LeafKeyError("degrees", "revolve: degrees is " + to_decimal(shape.degrees) +
                                      ": give more than 0 and at most 360" +
                                      (shape.degrees < 0 ? ", and turn the axis round" : ""));
  }
  for (const ProfileLine& line : shape.profile.lines) {
    for (const CurveNet& net : line.segments) {
      for (const RationalPoint& p : net.points) {
        if (p[1] != 0)
          throw LeafKeyError("profile", "revolve: a point of the profile has three coordinates: give [r, z]");
      }
    }
  }
}

std::string describe_rz(const RationalPoint& p) { return "[" + to_decimal(p[0]) + ", " + to_decimal(p[2]) + "]"; }

/// The largest distance from the axis; no point may lie beyond it.
Rational check_radii(const std::vector<SampledLine>& lines) {
  Rational largest = 0;
  for (const SampledLine& line : lines) {
    for (const RationalPoint& p : line.points) {
      if (p[0] < 0) {
        throw LeafKeyError("profile", "revolve: the profile crosses the axis, at " + describe_rz(p) +
                                          ": give a profile with r >= 0 everywhere");
      }
      if (p[0] > largest) largest = p[0];
    }
  }
  if (largest == 0) throw LeafKeyError("profile", "revolve: the profile lies on the axis: give points with r > 0");
  return largest;
}

/// Corners tell nothing of what is between them.
void check_between_corners(const Profile& profile) {
  std::size_t number = 0;
  for (const ProfileLine& line : profile.lines) {
    for (const CurveNet& net : line.segments) {
      ++number;
      for (const BezierCurve& piece : curve_pieces(net, "revolve")) {
        if (is_zero_inside(piece.net, 0))
          throw LeafKeyError("profile", "revolve: segment " + std::to_string(number) +
                                            " of the profile comes to the axis between its ends: part it there");
      }
    }
  }
}

/// The unit vector along the axis: exact where it is rational, else to 52 bits.
RationalPoint unit_axis(const CircleFrame& frame) {
  return scaled_cosine(0, 1 / dot(frame.axis(), frame.axis())) * frame.axis();
}

/// What carries the patches: the profile's pieces in its order, or against it where a line was turned round.
std::shared_ptr<RevolvedForm> form_of(const RevolveShape& shape, const RationalPoint& up, std::uint32_t first,
                                      const std::vector<bool>& turned, BoundaryCurves& boundary) {
  auto form = std::make_shared<RevolvedForm>();
  form->center = shape.center;
  form->axis = up;
  form->degrees = shape.degrees;
  form->closed_lines = form->solid = shape.profile.closed;
  std::uint32_t patch = first;
  for (std::size_t l = 0; l < shape.profile.lines.size(); ++l) {
    std::vector<MeridianPiece>& line = form->lines.emplace_back();
    for (const CurveNet& net : shape.profile.lines[l].segments) {
      const std::vector<Span> spans = curve_spans(net);
      const std::vector<BezierCurve> pieces = curve_pieces(net, "revolve");
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        line.push_back(meridian_piece(pieces[k], spans[k], dot(up, up)));
        line.back().patch = patch;
        line.back().steps = boundary.steps(pieces[k]);
      }
      ++patch;
    }
    if (!turned[l]) continue;
    std::reverse(line.begin(), line.end());
    for (MeridianPiece& piece : line) piece = reversed(std::move(piece));
  }
  return form;
}

}  // namespace

std::unique_ptr<PreparedLeaf> prepare_leaf(const RevolveShape& shape, LeafParameters* record) {
  check(shape);
  const Fineness fineness("revolve", shape.tessellation);
  BoundaryCurves boundary(fineness);
  std::vector<SampledLine> lines =
      sample(shape.profile, "revolve", [&](const BezierCurve& curve) { return boundary.inside(curve); });
  const Rational radius = check_radii(lines);
  check_between_corners(shape.profile);
  const int turns = fineness.steps_of_turn(to_double(radius) * (1 + 1e-12), to_double(shape.degrees));
  double points = 0;
  for (const SampledLine& line : lines) points += static_cast<double>(line.points.size());
  fineness.check_facets(points * turns);
  const bool closed = shape.profile.closed, full = shape.degrees == 360;
  std::vector<bool> turned(lines.size(), false);
  if (closed) {
    check_area(lines, "revolve");
    // The outer line counter-clockwise with r to the right and z up, holes clockwise.
    for (std::size_t l = 0; l < lines.size(); ++l) {
      if ((area_vector(lines[l].points)[1] < 0) == (l == 0)) continue;
      reverse(lines[l]);
      turned[l] = true;
    }
  }
  const CircleFrame frame(shape.axis);
  const RationalPoint up = unit_axis(frame);
  LeafBuilder builder(closed ? Fill::winding : Fill::none, record, true);
  std::vector<std::vector<PointId>> first;
  const auto section = [&](int k) {
    Rational degrees(k, turns);
    degrees.canonicalize();
    const RationalPoint direction =
        k == turns ? frame.turned(shape.degrees) : frame.offset(1, degrees * shape.degrees);
    std::vector<std::vector<PointId>> ids;
    for (std::size_t l = 0; l < lines.size(); ++l) {
      ids.emplace_back();
      for (std::size_t i = 0; i < lines[l].points.size(); ++i) {
        const RationalPoint& p = lines[l].points[i];
        const bool on_axis = p[0] == 0 && k > 0;
        ids.back().push_back(on_axis ? first[l][i] : builder.point(shape.center + p[0] * direction + p[2] * up));
      }
    }
    return ids;
  };
  first = section(0);
  std::vector<std::vector<PointId>> last = first;
  const std::uint32_t number = closed && !full ? 2 : 0;
  for (int k = 1; k <= turns; ++k) {
    const Rational v0 = fraction(k - 1, turns), v1 = fraction(k, turns);
    const std::vector<std::vector<PointId>> next = full && k == turns ? first : section(k);
    for (std::size_t l = 0; l < lines.size(); ++l) {
      const auto &from = last[l], &to = next[l];
      for (std::size_t i = 0; i < lines[l].segment.size(); ++i) {
        const std::size_t j = (i + 1) % from.size();
        if (from[i] == to[i] && from[j] == to[j]) continue;  // on the axis
        const auto& [u0, u1] = lines[l].parameters[i];
        builder.facet(from[i], to[i], to[j], from[j], number + lines[l].segment[i],
                      {{{&u0, &v0}, {&u0, &v1}, {&u1, &v1}, {&u1, &v0}}});
      }
    }
    last = next;
  }
  if (!closed && !full) builder.end_curves(first[0]), builder.end_curves(last[0]);
  if (record != nullptr) name_segments(*record, lines, "revolve", number);
  if (closed && !full) {
    builder.name_patch(0, "revolve start");
    builder.name_patch(1, "revolve end");
    builder.face(first, 0);
    for (auto& loop : last) std::reverse(loop.begin(), loop.end());
    builder.face(last, 1);
  }
  const auto form = form_of(shape, up, number, turned, boundary);
  form->segments = fineness.steps_of_turn(to_double(radius) * (1 + 1e-12), 360);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const std::uint32_t segment : lines[i].segment) {
      form->names.emplace_back(number + segment, "revolve segment " + std::to_string(segment + 1));
    }
  }
  if (closed && !full) {
    form->names.emplace_back(0, "revolve start");
    form->names.emplace_back(1, "revolve end");
  }
  for (const auto& line : form->lines) {
    for (const MeridianPiece& piece : line) {
      for (const MeridianPoint& end : {piece.from, piece.to}) {
        if (is_apex(piece, end))
          builder.soup().add_curve_end(builder.leaf(), builder.point(shape.center + end.t * up));
      }
    }
  }
  auto leaf = builder.finish();
  leaf->set_form(form);
  return leaf;
}

}  // namespace cnrg
