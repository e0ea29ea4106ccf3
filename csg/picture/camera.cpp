#include "csg/picture/camera.h"

#include <cmath>
#include <cstdint>

#include "kernel/exact/integers.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

/// Cosine and sine of an angle as fractions over one denominator: `c`, `s`, `size` with c^2 + s^2 = size^2.
struct Turn {
  Integer c, s, size;
};

Turn turn_by(double degrees) {
  const double quarters = std::nearbyint(degrees / 90);
  const std::int64_t p = std::llround(rounded::tangent((degrees - 90 * quarters) * M_PI / 360) * 512);
  Turn turn{to_integer(512 * 512 - p * p), to_integer(2 * 512 * p), to_integer(512 * 512 + p * p)};
  if (p == 0) turn = {1, 0, 1};
  for (int k = static_cast<int>(std::fmod(quarters, 4)); k != 0; k += k < 0 ? 1 : -1) {
    const Integer c = turn.c;
    turn.c = k < 0 ? turn.s : Integer(-turn.s);
    turn.s = k < 0 ? Integer(-c) : c;
  }
  return turn;
}

}  // namespace

Camera::Camera(const DrawOptions::Camera& angles) {
  const Turn a = turn_by(angles.azimuth), e = turn_by(angles.elevation);
  // Right is (cos a, sin a, 0); the way to who looks is (sin a cos e, -cos a cos e, sin e); up is at right angles.
  turn_.linear = {{{Rational(a.c * e.size), Rational(a.s * e.size), Rational(0)},
                   {Rational(-a.s * e.s), Rational(a.c * e.s), Rational(a.size * e.c)},
                   {Rational(a.s * e.c), Rational(-a.c * e.c), Rational(a.size * e.s)}}};
  towards_ = turn_.linear[2];
  scale_ = Rational(a.size * e.size);
}

}  // namespace cnrg
