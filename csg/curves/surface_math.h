// Numbers for surfaces: one formula serves doubles and intervals.
//
// A formula is a template over its number. What it takes from the shape are constants: rationals, or lengths of
// rational vectors, which are kept as the double in the middle and as an interval that holds the exact value.
//
// Angles are counted in turns, in which parameters are rational and reduction to an eighth of a turn is exact.
// Sines and cosines of the library are neither correctly rounded nor the same on all machines: here they are
// Taylor polynomials, over intervals with a bound of the rest.
#pragma once

#include <cmath>
#include <numbers>

#include "csg/curves/surface.h"
#include "kernel/base/products.h"
#include "kernel/exact/rational.h"

namespace cnrg::surface_math {

struct Constant {
  double value = 0;
  Interval range = 0;
};

/// `value` to the nearest doubles.
Interval enclose(const Rational& value);
inline Constant constant(const Rational& value) { return {to_double(value), enclose(value)}; }
/// While a RoundOutward lives.
inline Constant constant(const Interval& range) { return {enclosure::middle_of(range), range}; }
Vector3<Constant> constants(const RationalPoint& p);
/// The unit vector along `v`, which is not zero.
Vector3<Constant> unit(const RationalPoint& v);
/// The length of `v`.
Constant length(const RationalPoint& v);

template <class N>
const N& as(const Constant& c) {
  if constexpr (std::is_same_v<N, double>) return c.value;
  else return c.range;
}
template <class N>
Vector3<N> as(const Vector3<Constant>& c) {
  return {as<N>(c[0]), as<N>(c[1]), as<N>(c[2])};
}

template <class N>
Vector3<N> sum(const Vector3<N>& a, const Vector3<N>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class N>
Vector3<N> difference(const Vector3<N>& a, const Vector3<N>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class N>
Vector3<N> scaled(const N& s, const Vector3<N>& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
using cnrg::cross, cnrg::dot;

/// Radians of a turn.
template <class N>
N turn() {
  constexpr double kBelow = 2 * std::numbers::pi;  // the double nearest to 2 pi is below it
  if constexpr (std::is_same_v<N, double>) return kBelow;
  else return Interval(kBelow, std::nextafter(kBelow, 7.0));
}

double cosine(double turns);
Interval cosine(const Interval& turns);
template <class N>
N sine(const N& turns) {
  return cosine(N(turns - N(0.25)));
}

/// A surface by a template of `Of`, `jet(u, v)`, for both kinds of numbers.
template <class Of>
class SurfaceByJet : public Surface {
 public:
  SurfaceJet<double> at(double u, double v) const final { return static_cast<const Of&>(*this).jet(u, v); }
  SurfaceJet<Interval> over(const Interval& u, const Interval& v) const final {
    const enclosure::RoundOutward outward;
    return static_cast<const Of&>(*this).jet(u, v);
  }
};

}  // namespace cnrg::surface_math
