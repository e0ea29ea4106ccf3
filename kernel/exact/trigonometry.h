// Sines, cosines and rotations by rational angles, the same on every machine.
//
// Angles are exact numbers of degrees. By Niven's theorem the sine of a rational number of degrees is rational
// only for multiples of 30 degrees, where it is 0, +-1/2 or +-1; everywhere else a value is never exactly between
// two doubles, so evaluating with growing precision until both bounds round alike (Ziv 1991) ends, and the
// result is the correctly rounded one.
#pragma once

#include "kernel/exact/rational.h"

namespace cnrg {

/// The doubles nearest to the sine and the cosine of an angle in degrees (ties cannot occur).
double sine_degrees(const Rational& degrees);
double cosine_degrees(const Rational& degrees);

/// The doubles nearest to functions of doubles, angles in radians. Those of the C library differ from machine to
/// machine.
namespace rounded {
double cosine(double angle);
double tangent(double angle);
double arc_sine(double x);
double arc_cosine(double x);
/// Of y / x, in the quadrant of (x, y).
double arc_tangent(double y, double x);
}  // namespace rounded

/// The multiple of 2^exponent nearest to sqrt(square) * cos(degrees), a tie going to the even multiple.
/// `square` >= 0. The sine is the cosine of 90 - degrees.
Rational round_cosine(const Rational& degrees, const Rational& square, int exponent);

/// floor(log2(sqrt(square))) for square > 0: the binary exponent of a length, exactly.
int exponent_of_root(const Rational& square);

/// A positive multiple of the vector in whole numbers: signs and angles stay, and no sum or product of such
/// vectors has to be reduced, which costs more than these.
RationalPoint whole(const RationalPoint& v);
/// The primitive integer vector (gcd 1) with the direction of `direction`, which is not zero.
std::array<Integer, 3> primitive_direction(const RationalPoint& direction);

/// A quaternion (w, x, y, z), w >= 0, whose rotation has exactly the given axis and an angle that differs from
/// `degrees` by less than 1e-15 radians: the fraction with the smallest denominator that is near enough. Every
/// rational quaternion gives an exactly orthogonal rational matrix after division by its square. Exact for
/// multiples of 180 degrees about any axis, and of 90 degrees about axes of rational length. `axis` is not zero.
std::array<Rational, 4> rotation_quaternion(const RationalPoint& axis, const Rational& degrees);

}  // namespace cnrg
