// Surfaces of revolution: S = c + r(m) d(a) + z(m) n, a meridian (r, z) turned about an axis.
//
// With the unit vectors d(a) away from the axis, t = n x d and n, the derivatives are r t by the angle and
// r' d + z' n along the meridian, and (r t) x (r' d + z' n) = r (z' d - r' n). So the direction of the normal is
// that of z' d - r' n, whatever r > 0 is. Where r = 0 it is the limit along each meridian: at a pole of a sphere
// that is one direction, at the apex of a cone all that the cone has.
#pragma once

#include "csg/curves/surface_math.h"
#include "csg/geometry/circle.h"

namespace cnrg {

template <class N>
struct MeridianJet {
  N r, z, r_m, z_m;
};

/// `Meridian` has `jet(m)` for doubles and intervals, and `bend(m)`: the second derivatives of r and z, if known.
template <class Meridian>
class RoundSurface final : public surface_math::SurfaceByJet<RoundSurface<Meridian>> {
 public:
  struct Place {
    RationalPoint center;
    CircleFrame frame;
    Rational degrees = 360;   ///< of the whole range of the angle's parameter, which is from 0 to 1
    bool angle_first = true;  ///< u is the angle and v runs along the meridian, or the other way round
  };
  RoundSurface(const Place& place, Meridian meridian)
      : meridian_(std::move(meridian)),
        center_(surface_math::constants(place.center)),
        first_(surface_math::unit(place.frame.first())),
        second_(surface_math::unit(place.frame.second())),
        axis_(surface_math::unit(place.frame.axis())),
        turns_(surface_math::constant(Rational(place.degrees / 360))),
        angle_first_(place.angle_first) {}

  std::optional<SurfaceBend> bend_over(const Interval& u, const Interval& v) const override {
    using namespace surface_math;
    const enclosure::RoundOutward outward;
    const Interval& along = angle_first_ ? v : u;
    const std::optional<std::array<Interval, 2>> bent = meridian_.bend(along);
    if (!bent) return std::nullopt;
    const auto [away, around] = directions(Interval(turns_.range * (angle_first_ ? u : v)));
    const MeridianJet<Interval> m = meridian_.jet(along);
    const Interval speed = turn<Interval>() * turns_.range;
    const Vector3<Interval> by_angle = scaled(Interval(-(speed * speed * m.r)), away), by_both = mixed(m, around),
                            by_meridian = sum(scaled((*bent)[0], away), scaled((*bent)[1], as<Interval>(axis_)));
    if (angle_first_) return SurfaceBend{by_angle, by_both, by_meridian};
    return SurfaceBend{by_meridian, by_both, by_angle};
  }
  /// At any pole, and elsewhere: the derivative along the meridian of that by the angle.
  std::optional<Vector3<Interval>> fan_over(std::size_t /*around*/, double /*pole*/, const Interval& u,
                                            const Interval& v) const override {
    using namespace surface_math;
    const enclosure::RoundOutward outward;
    return mixed(meridian_.jet(angle_first_ ? v : u),
                 directions(Interval(turns_.range * (angle_first_ ? u : v)))[1]);
  }
  std::optional<Revolution> revolution() const override {
    using namespace surface_math;
    return Revolution{as<double>(center_), as<double>(axis_), angle_first_ ? 0u : 1u, turns_.value};
  }

 private:
  friend class surface_math::SurfaceByJet<RoundSurface<Meridian>>;
  /// Unit vectors at an angle: away from the axis, and where it grows.
  template <class N>
  std::array<Vector3<N>, 2> directions(const N& turns) const {
    using namespace surface_math;
    const N c = cosine(turns), s = sine(turns);
    const Vector3<N> e1 = as<N>(first_), e2 = as<N>(second_);
    return {sum(scaled(c, e1), scaled(s, e2)), difference(scaled(c, e2), scaled(s, e1))};
  }
  Vector3<Interval> mixed(const MeridianJet<Interval>& m, const Vector3<Interval>& around) const {
    return surface_math::scaled(Interval(surface_math::turn<Interval>() * turns_.range * m.r_m), around);
  }
  template <class N>
  SurfaceJet<N> jet(const N& u, const N& v) const {
    using namespace surface_math;
    const auto [away, around] = directions(N(as<N>(turns_) * (angle_first_ ? u : v)));
    const MeridianJet<N> m = meridian_.jet(angle_first_ ? v : u);
    const Vector3<N> n = as<N>(axis_);
    const Vector3<N> point = sum(as<N>(center_), sum(scaled(m.r, away), scaled(m.z, n)));
    const Vector3<N> by_angle = scaled(N(turn<N>() * as<N>(turns_) * m.r), around);
    const Vector3<N> by_meridian = sum(scaled(m.r_m, away), scaled(m.z_m, n));
    Vector3<N> normal = difference(scaled(m.z_m, away), scaled(m.r_m, n));
    if (!angle_first_) normal = scaled(N(-1), normal);
    if (angle_first_) return {point, by_angle, by_meridian, normal, around, by_meridian};
    return {point, by_meridian, by_angle, normal, by_meridian, around};
  }

  Meridian meridian_;
  Vector3<surface_math::Constant> center_, first_, second_, axis_;
  surface_math::Constant turns_;
  bool angle_first_;
};

}  // namespace cnrg
