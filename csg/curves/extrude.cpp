// Extrusion: S(u, t) = c + s(t) R(t) (p(u) - c) + t v with s from 1 to `scale` and R(t) the turn by t * twist
// about the axis along v through c. The turns are rational and exactly orthogonal, so sections are planar and
// similar to the profile, exactly, but for angles that are off by less than 1e-15. Only the two ends need be
// planar: points of turned sections between them are rounded to doubles.
//
// Without twist the facets of a step of the profile are planar quadrilaterals, and as far from the exact shape as
// the profile's chords are from the profile: at most chord / 2, scaled up where s > 1 (the curve's steps are then
// chosen for the larger one). With twist, the sweep of the chords' polygon P is as far from that of p. An edge of
// P of length l sweeps a surface with second derivatives 0 in u, at most l (|s'| + m a) mixed and at most
// r (2 |s'| a + m a^2) in t, with a the twist in radians, m the largest s and r the largest distance from the
// axis. So n sections in t and edges not longer than l are within (chord.h)
//   (2 l (|s'| + m a) / n + r (2 |s'| a + m a^2) / n^2) / 8
// of which each half is kept below chord / 4.
//
// Caps are faces 0 and 1, each segment of the profile is one more; of a curve the segments are from 0.
//
// Parameters (parameters.h): u is that of the segment's own curve, from 0 to 1 (between its knots for a spline), v
// is t. Caps have none.
#include "csg/curves/extrude.h"

#include <algorithm>
#include <cmath>

#include "csg/geometry/circle.h"
#include "csg/geometry/planar_polygon.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

double length_bound(const RationalPoint& v) { return std::sqrt(to_double(dot(v, v))) * (1 + 1e-12); }

class Extrusion {
 public:
  Extrusion(const ExtrudeShape& shape, LeafParameters* record, const CommonSweep* common = nullptr)
      : shape_(shape),
        record_(record),
        mirrored_(common != nullptr && common->mirrored),
        fixed_(common == nullptr ? FixedSamples() : common->fixed),
        heights_(common == nullptr ? std::set<Rational>() : common->heights),
        fineness_("extrude", shape.tessellation),
        boundary_(fineness_, common == nullptr ? nullptr : common->steps.get()) {
    if (is_zero(shape.vector)) throw LeafKeyError("vector", "extrude: the vector is zero: give the way to go");
    if (shape.scale < 0) {
      throw LeafKeyError("scale", "extrude: scale is " + to_decimal(shape.scale) + ": give 0 or more");
    }
    if (shape.profile.lines.empty() || shape.profile.lines[0].segments.empty() ||
        shape.profile.lines[0].segments[0].points.empty()) {
      throw LeafKeyError("profile", "extrude: the profile is empty: give its corners");
    }
    center_ = axis_point(shape);
    if (shape.twist != 0 || shape.scale != 1) check_right_angle(shape.profile.lines[0].segments[0].points[0]);
    choose_sections();
  }

  std::unique_ptr<PreparedLeaf> prepare() {
    std::vector<SampledLine> lines = sample(
        shape_.profile, "extrude", [&](const BezierCurve& c) { return steps(c); }, fixed_);
    double points = 0;
    for (const SampledLine& line : lines) points += static_cast<double>(line.points.size());
    fineness_.check_facets(2 * points * sections_);
    const bool closed = shape_.profile.closed;
    if (closed) {
      const RationalPoint normal = check_area(lines, "extrude");
      if (dot(normal, shape_.vector) == 0) {
        throw InputError(
            "extrude: the vector lies in the plane of the profile: give one that leaves it, or the line as "
            "`curve`");
      }
      for (std::size_t l = 0; l < lines.size(); ++l) {
        const bool along = dot(area_vector(lines[l].points), shape_.vector) > 0;
        if (along != (l == 0)) reverse(lines[l]);
      }
    }
    LeafBuilder builder(closed ? Fill::winding : Fill::none, record_, true);
    std::vector<std::vector<PointId>> lower = section(builder, lines, 0), bottom = lower;
    Rational from = 0;
    for (const Rational& to : heights()) {
      const std::vector<std::vector<PointId>> upper = section(builder, lines, to);
      for (std::size_t l = 0; l < lines.size(); ++l) add_band(builder, lines[l], lower[l], upper[l], from, to);
      lower = upper;
      from = to;
    }
    if (shape_.scale == 0)
      builder.soup().add_curve_end(builder.leaf(), lower[0][0]);  // lines meet there at angles
    if (!closed) builder.end_curves(bottom[0]), builder.end_curves(lower[0]);
    if (record_ != nullptr) name_segments(*record_, lines, "extrude", closed ? 2 : 0);
    if (closed) {
      builder.name_patch(0, "extrude start");
      builder.name_patch(1, "extrude end");
      if (shape_.scale != 0) builder.face(lower, 1);
      for (auto& loop : bottom) std::reverse(loop.begin(), loop.end());
      builder.face(bottom, 0);
    }
    return builder.finish();
  }

 private:
  void check_right_angle(const RationalPoint& first) {
    for (const ProfileLine& line : shape_.profile.lines) {
      for (const CurveNet& net : line.segments) {
        for (const RationalPoint& p : net.points) {
          radius_ = std::max(radius_, length_bound(p - center_));
          if (dot(p - first, shape_.vector) == 0) continue;
          throw InputError(
              "extrude: with twist or scale the profile must lie at right angles to the vector, but " +
              describe(p) + " does not lie in such a plane with " + describe(first) +
              ": move it, or extrude without");
        }
      }
    }
  }

  void choose_sections() {
    if (shape_.twist == 0) return;
    sections_ = fineness_.segments();
    if (!fineness_.by_chord()) return;
    const double a = std::abs(to_double(shape_.twist)) * 0.017453292519943296;
    const double growth = std::abs(to_double(shape_.scale) - 1), most = std::max(1.0, to_double(shape_.scale));
    // Not more than 45 degrees from one to the next, whatever the size.
    double bound = radius_ * (2 * growth * a + most * a * a) / 8 * (1 + 1e-12), turn = a;
    for (sections_ = 1; bound > fineness_.chord() / 4 || turn > 0.7854; sections_ *= 2) {
      if (sections_ >= Fineness::kMostSegments) fineness_.fail_too_fine();
      bound /= 4;
      turn /= 2;
    }
    longest_ = fineness_.chord() * sections_ / (growth + most * a) * (1 - 1e-12);
  }

  /// Steps of a segment: those of its curve at the largest scale of the sweep, more where twist needs short edges.
  std::vector<Rational> steps(const BezierCurve& curve) {
    if (shape_.twist == 0 && shape_.scale <= 1) return boundary_.inside(curve);
    return CurveSteps{even_steps(curve)}.inside();
  }
  int even_steps(const BezierCurve& curve) {
    int n = 0;
    if (shape_.scale > 1) {
      BezierCurve larger = curve;
      for (Homogeneous& h : larger.net) {
        for (std::size_t k = 0; k < 3; ++k) h[k] *= shape_.scale;
      }
      n = boundary_.steps(larger);
    } else {
      n = boundary_.steps(curve);
    }
    if (shape_.twist == 0) return n;
    if (!fineness_.by_chord()) return fineness_.segments();
    for (bool fine = false; !fine;) {
      fine = true;
      for (int i = 0; i < n && fine; ++i) {
        Rational low(i, n), high(i + 1, n);
        low.canonicalize();
        high.canonicalize();
        fine = length_bound(curve.at(high) - curve.at(low)) <= longest_;
      }
      if (!fine) n *= 2;
      if (n > Fineness::kMostSegments) fineness_.fail_too_fine();
    }
    return n;
  }

  /// Of all sections but the first one.
  std::vector<Rational> heights() const {
    std::vector<Rational> result = CurveSteps{sections_, heights_}.inside();
    result.push_back(1);
    return result;
  }

  std::vector<std::vector<PointId>> section(LeafBuilder& builder, const std::vector<SampledLine>& lines,
                                            const Rational& t) const {
    const Rational s = 1 + t * (shape_.scale - 1);
    Transform move = Transform::translation(t * shape_.vector);
    if (shape_.twist != 0) move = move * Transform::rotation(shape_.vector, t * shape_.twist, center_);
    const Rational size = from_double(radius_);
    std::vector<std::vector<PointId>> result;
    const PointId apex = s == 0 ? builder.point(move.apply(center_)) : PointId::none();
    for (const SampledLine& line : lines) {
      result.emplace_back();
      for (const RationalPoint& p : line.points) {
        if (s == 0) {
          result.back().push_back(apex);
          continue;
        }
        RationalPoint q = move.apply(center_ + s * (p - center_));
        if (shape_.twist != 0 && t > 0 && t < 1) {
          for (Rational& x : q) x = rounded_for(x, size);
        }
        result.back().push_back(builder.point(q));
      }
    }
    return result;
  }

  void add_band(LeafBuilder& builder, const SampledLine& line, const std::vector<PointId>& lower,
                const std::vector<PointId>& upper, const Rational& v0, const Rational& v1) const {
    const std::uint32_t first = shape_.profile.closed ? 2 : 0;
    for (std::size_t i = 0; i < line.segment.size(); ++i) {
      const std::size_t j = (i + 1) % line.points.size();
      if (!shape_.profile.closed && is_zero(cross(line.points[j] - line.points[i], shape_.vector)) &&
          shape_.scale == 1) {
        throw InputError("extrude: the curve runs along the vector at " + describe(line.points[i]) +
                         ", where it sweeps no area: move it or the vector");
      }
      const auto& [u0, u1] = line.parameters[i];
      // A solid's bands face outward as they are.
      if (mirrored_ && !shape_.profile.closed) {
        builder.facet(lower[j], lower[i], upper[i], upper[j], first + line.segment[i],
                      {{{&u1, &v0}, {&u0, &v0}, {&u0, &v1}, {&u1, &v1}}});
        continue;
      }
      builder.facet(lower[i], lower[j], upper[j], upper[i], first + line.segment[i],
                    {{{&u0, &v0}, {&u1, &v0}, {&u1, &v1}, {&u0, &v1}}});
    }
  }

  const ExtrudeShape& shape_;
  LeafParameters* record_;
  bool mirrored_;
  FixedSamples fixed_;
  std::set<Rational> heights_;
  Fineness fineness_;
  BoundaryCurves boundary_;
  RationalPoint center_;
  double radius_ = 0, longest_ = 0;
  int sections_ = 1;
};

}  // namespace

RationalPoint axis_point(const ExtrudeShape& shape) {
  const RationalPoint& first = shape.profile.lines[0].segments[0].points[0];
  const RationalPoint given = shape.center.value_or(first);
  return given + Rational(dot(first - given, shape.vector) / dot(shape.vector, shape.vector)) * shape.vector;
}

std::unique_ptr<PreparedLeaf> prepare_leaf(const ExtrudeShape& shape, LeafParameters* record) {
  std::unique_ptr<PreparedLeaf> leaf = Extrusion(shape, record).prepare();
  if (shape.twist == 0 && shape.scale == 1) leaf->set_form(std::make_shared<ExtrudeForm>(shape));
  return leaf;
}

std::unique_ptr<PreparedLeaf> tessellate(const std::shared_ptr<const CommonSweep>& sweep) {
  std::unique_ptr<PreparedLeaf> leaf = Extrusion(sweep->shape, nullptr, sweep.get()).prepare();
  leaf->set_parameters([sweep] {
    auto parameters = std::make_shared<LeafParameters>();
    Extrusion(sweep->shape, parameters.get(), sweep.get()).prepare();
    return parameters;
  });
  return leaf;
}

}  // namespace cnrg
