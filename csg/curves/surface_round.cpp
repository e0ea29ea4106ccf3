// The true surfaces of sphere, cylinder, cone, torus and revolve: what each turns about its axis.
#include "csg/curves/surface_round.h"

#include "csg/curves/surface_forms.h"
#include "csg/curves/surface_spline.h"
#include "csg/leaves/prepare_shapes.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using namespace surface_math;

/// From radius `from` at 0 to radius `to` at height `length`.
struct SlantedLine {
  Constant from, growth, length;
  template <class N>
  MeridianJet<N> jet(const N& m) const {
    return {as<N>(from) + as<N>(growth) * m, as<N>(length) * m, as<N>(growth), as<N>(length)};
  }
  std::optional<std::array<Interval, 2>> bend(const Interval&) const {
    return std::array<Interval, 2>{Interval(0), Interval(0)};
  }
};

/// A circle of the given radius about a point at distance `out`, from `start` on, all by turns.
struct RoundLine {
  Constant radius, out, start, turns;
  template <class N>
  MeridianJet<N> jet(const N& m) const {
    const N at = as<N>(start) + as<N>(turns) * m;
    const N x = as<N>(radius) * cosine(at), y = as<N>(radius) * sine(at), speed = turn<N>() * as<N>(turns);
    return {as<N>(out) + x, y, -(speed * y), speed * x};
  }
  std::optional<std::array<Interval, 2>> bend(const Interval& m) const {
    const Interval at = start.range + turns.range * m, speed = turn<Interval>() * turns.range;
    const Interval factor = -(speed * speed * radius.range);
    return std::array<Interval, 2>{factor * cosine(at), factor * sine(at)};
  }
};

struct ProfileSegment {
  SplineCurve curve;  // (r, 0, z)
  template <class N>
  MeridianJet<N> jet(const N& m) const {
    const CurveJet<N> jet = curve.jet(m);
    return {jet.point[0], jet.point[2], jet.along[0], jet.along[2]};
  }
  static std::optional<std::array<Interval, 2>> bend(const Interval&) { return std::nullopt; }
};

template <class Meridian>
std::shared_ptr<const Surface> turned(const typename RoundSurface<Meridian>::Place& place, Meridian meridian) {
  return std::make_shared<const RoundSurface<Meridian>>(place, std::move(meridian));
}

template <class Meridian>
std::shared_ptr<const LeafSurfaces> one_patch(std::uint32_t number,
                                              const typename RoundSurface<Meridian>::Place& place,
                                              Meridian meridian, SurfaceForm form) {
  auto surfaces = std::make_shared<LeafSurfaces>();
  surfaces->add_patch(number, turned(place, std::move(meridian)));
  surfaces->add_form(number, std::move(form));
  return surfaces;
}

}  // namespace

std::shared_ptr<const LeafSurfaces> true_surfaces(const ConeShape& shape) {
  const RationalPoint along = shape.to - shape.from;
  return one_patch(
      2, {.center = shape.from, .frame = CircleFrame(along)},
      SlantedLine{constant(shape.radius), constant(Rational(shape.top - shape.radius)), length(along)},
      cone_form(shape));
}

std::shared_ptr<const LeafSurfaces> true_surfaces(const CylinderShape& shape) {
  return true_surfaces(ConeShape{shape.from, shape.to, shape.radius, shape.radius, shape.segments});
}

std::shared_ptr<const LeafSurfaces> sphere_surfaces(const RationalPoint& center, const Rational& radius,
                                                    const RationalPoint& axis) {
  return one_patch(
      0, {.center = center, .frame = CircleFrame(axis)},
      RoundLine{constant(radius), constant(Rational(0)), constant(Rational(-1, 4)), constant(Rational(1, 2))},
      sphere_form(center, radius, axis));
}

std::shared_ptr<const LeafSurfaces> true_surfaces(const SphereShape& shape) {
  return sphere_surfaces(shape.center, shape.radius, {0, 0, 1});
}

std::shared_ptr<const LeafSurfaces> true_surfaces(const TorusShape& shape) {
  return one_patch(
      0, {.center = shape.center, .frame = CircleFrame(shape.axis)},
      RoundLine{constant(shape.tube), constant(shape.radius), constant(Rational(0)), constant(Rational(1))},
      torus_form(shape));
}

std::shared_ptr<const LeafSurfaces> true_surfaces(const RevolveShape& shape) {
  auto surfaces = std::make_shared<LeafSurfaces>();
  std::uint32_t number = shape.profile.closed && shape.degrees != 360 ? 2 : 0;
  for (const ProfileLine& line : shape.profile.lines) {
    for (const CurveNet& net : line.segments) {
      const std::vector<BezierCurve> pieces = curve_pieces(net, "revolve");
      const std::uint32_t patch = number++;
      const bool flat = std::all_of(net.points.begin(), net.points.end(),
                                    [&](const RationalPoint& p) { return p[2] == net.points[0][2]; });
      const auto ends = [&](const CurveNet& at, const RationalPoint& p) {
        return !shape.profile.closed && &net == &at && p[0] > 0;
      };
      const bool rim =
          ends(line.segments.front(), net.points.front()) || ends(line.segments.back(), net.points.back());
      if (flat && !rim && runs_straight(net.points)) continue;
      surfaces->add_patch(patch, turned({.center = shape.center,
                                         .frame = CircleFrame(shape.axis),
                                         .degrees = shape.degrees,
                                         .angle_first = false},
                                        ProfileSegment{{pieces, curve_spans(net)}}));
      if (!flat) surfaces->add_form(patch, revolved_form(shape, net));
    }
  }
  return surfaces;
}

}  // namespace cnrg
