// Bounds from MPFR with directed rounding, decided when both ends round alike.
//
// A rotation about the axis a (integers) by the angle t is the quaternion (1, m a) with m = tan(t/2) / |a|, or
// (k, a) with k = |a| cot(t/2) when t is beyond a right angle, so that the number stays bounded. Any rational
// m or k gives an exactly orthogonal matrix with exactly that axis; only the angle moves. Walking down the
// Stern-Brocot tree finds the simplest fraction in the allowed interval: right angles come out exact, and
// others have denominators of some 25 bits, not the 53 of a rounded double.
#include "kernel/exact/trigonometry.h"

#include <mpfr.h>

#include "kernel/base/error.h"
#include "kernel/exact/integers.h"

namespace cnrg {
namespace {

/// An MPFR number that frees itself.
class Real {
 public:
  explicit Real(mpfr_prec_t precision) { mpfr_init2(value_, precision); }
  ~Real() { mpfr_clear(value_); }
  Real(const Real&) = delete;
  Real& operator=(const Real&) = delete;
  operator mpfr_ptr() { return value_; }
  Rational rational() const {
    Rational result;
    mpfr_get_q(result.get_mpq_t(), value_);
    return result;
  }

 private:
  mpfr_t value_;
};

Integer floor_of(const Rational& value) {
  Integer q;
  mpz_fdiv_q(q.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
  return q;
}

/// `degrees` modulo 360, in [0, 360).
Rational reduced(const Rational& degrees) { return degrees - 360 * floor_of(degrees / 360); }

/// Bounds of `degrees` in radians, degrees >= 0.
void radians(Real& low, Real& high, const Rational& degrees) {
  mpfr_const_pi(low, MPFR_RNDD);
  mpfr_const_pi(high, MPFR_RNDU);
  const Rational turn = degrees / 180;
  mpfr_mul_q(low, low, turn.get_mpq_t(), MPFR_RNDD);
  mpfr_mul_q(high, high, turn.get_mpq_t(), MPFR_RNDU);
}

/// The sign of cos(degrees) and the angle in [0, 90] with the same cosine but for the sign.
int fold(Rational& degrees) {
  degrees = reduced(degrees);
  if (degrees > 180) degrees = 360 - degrees;
  if (degrees <= 90) return degrees == 90 ? 0 : 1;
  degrees = 180 - degrees;
  return -1;
}

/// Bounds of cos(degrees) for 0 < degrees < 90; small ones with full relative precision, as sines.
void cosine_bounds(Real& low, Real& high, const Rational& degrees) {
  if (degrees > 45) {
    radians(low, high, 90 - degrees);
    mpfr_sin(low, low, MPFR_RNDD);
    mpfr_sin(high, high, MPFR_RNDU);
  } else {
    radians(low, high, degrees);
    mpfr_cos(low, low, MPFR_RNDU);  // cosine falls: the bounds change places
    mpfr_cos(high, high, MPFR_RNDD);
    mpfr_swap(low, high);
  }
}

Integer nearest_integer(const Rational& value) {
  Integer q = floor_of(value);
  const int side = cmp(Rational(value - q), Rational(1, 2));
  if (side > 0 || (side == 0 && mpz_odd_p(q.get_mpz_t()))) q += 1;
  return q;
}

Rational power_of_two(std::int64_t exponent) {
  const Rational one = 1;
  return exponent >= 0 ? Rational(one << static_cast<mp_bitcnt_t>(exponent))
                       : Rational(one >> static_cast<mp_bitcnt_t>(-exponent));
}

/// The integer nearest to sqrt(square), exactly.
Integer nearest_integer_root(const Rational& square) {
  Integer root = sqrt(floor_of(square));  // floor(sqrt(square))
  const Rational middle = Rational(root) + Rational(1, 2);
  const int side = cmp(square, Rational(middle * middle));
  if (side > 0 || (side == 0 && mpz_odd_p(root.get_mpz_t()))) root += 1;
  return root;
}

/// The fraction with the smallest denominator in [low, high], 0 <= low <= high.
Rational simplest_between(const Rational& low, const Rational& high) {
  // Continued fraction: common partial quotients of both ends, then one step further.
  const Integer whole = floor_of(low);
  if (whole == low) return low;
  if (whole + 1 <= high) return Rational(Integer(whole + 1));
  return whole + 1 / simplest_between(1 / (high - whole), 1 / (low - whole));
}

const Rational& angle_tolerance() {
  static const Rational tolerance = fraction(4, 10'000'000'000'000'000);  // of a half angle's tangent
  return tolerance;
}

}  // namespace

double cosine_degrees(const Rational& degrees) {
  Rational angle = degrees;
  const int sign = fold(angle);
  if (sign == 0) return 0;
  if (angle == 0) return sign;
  if (angle == 60) return sign * 0.5;
  for (mpfr_prec_t precision = 128;; precision *= 2) {
    Real low(precision), high(precision);
    cosine_bounds(low, high, angle);
    const double a = mpfr_get_d(low, MPFR_RNDN), b = mpfr_get_d(high, MPFR_RNDN);
    if (a == b) return sign * a;
  }
}

double sine_degrees(const Rational& degrees) { return cosine_degrees(90 - degrees); }

namespace {

constexpr mpfr_prec_t kDoublePrecision = 53;
double of_double(int (*function)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t), double x) {
  Real value(kDoublePrecision);
  mpfr_set_d(value, x, MPFR_RNDN);
  function(value, value, MPFR_RNDN);
  return mpfr_get_d(value, MPFR_RNDN);
}

}  // namespace

double rounded::cosine(double angle) { return of_double(mpfr_cos, angle); }
double rounded::tangent(double angle) { return of_double(mpfr_tan, angle); }
double rounded::arc_sine(double x) { return of_double(mpfr_asin, x); }
double rounded::arc_cosine(double x) { return of_double(mpfr_acos, x); }
double rounded::arc_tangent(double y, double x) {
  Real value(kDoublePrecision), other(kDoublePrecision);
  mpfr_set_d(value, y, MPFR_RNDN);
  mpfr_set_d(other, x, MPFR_RNDN);
  mpfr_atan2(value, value, other, MPFR_RNDN);
  return mpfr_get_d(value, MPFR_RNDN);
}

Rational round_cosine(const Rational& degrees, const Rational& square, int exponent) {
  require(square >= 0, "round_cosine: negative square");
  Rational angle = degrees;
  const int sign = fold(angle);
  if (sign == 0 || square == 0) return 0;
  const Rational unit = power_of_two(exponent);
  const Rational scaled = square / (unit * unit);
  // The product is the root of a rational where cos(2 angle) is rational; elsewhere it is irrational.
  Integer multiple;
  if (angle == 0) multiple = nearest_integer_root(scaled);
  else if (angle == 30) multiple = nearest_integer_root(scaled * 3 / 4);
  else if (angle == 45) multiple = nearest_integer_root(scaled / 2);
  else if (angle == 60) multiple = nearest_integer_root(scaled / 4);
  else {
    const auto size = static_cast<std::int64_t>(mpz_sizeinbase(scaled.get_num_mpz_t(), 2)) -
                      static_cast<std::int64_t>(mpz_sizeinbase(scaled.get_den_mpz_t(), 2));
    for (mpfr_prec_t precision = 128 + static_cast<mpfr_prec_t>(std::max<std::int64_t>(0, size / 2));;
         precision *= 2) {
      Real low(precision), high(precision), root(precision);
      cosine_bounds(low, high, angle);
      mpfr_set_q(root, scaled.get_mpq_t(), MPFR_RNDD);
      mpfr_sqrt(root, root, MPFR_RNDD);
      mpfr_mul(low, low, root, MPFR_RNDD);
      mpfr_set_q(root, scaled.get_mpq_t(), MPFR_RNDU);
      mpfr_sqrt(root, root, MPFR_RNDU);
      mpfr_mul(high, high, root, MPFR_RNDU);
      multiple = nearest_integer(low.rational());
      if (multiple == nearest_integer(high.rational())) break;
    }
  }
  return sign * multiple * unit;
}

int exponent_of_root(const Rational& square) {
  require(square > 0, "exponent_of_root: not positive");
  auto e = static_cast<std::int64_t>(mpz_sizeinbase(square.get_num_mpz_t(), 2)) -
           static_cast<std::int64_t>(mpz_sizeinbase(square.get_den_mpz_t(), 2));
  if (square < power_of_two(e)) --e;  // 2^e <= square < 2^(e+1)
  return static_cast<int>(e >= 0 ? e / 2 : -((-e + 1) / 2));
}

RationalPoint whole(const RationalPoint& v) {
  const Integer denominator = lcm(lcm(v[0].get_den(), v[1].get_den()), v[2].get_den());
  RationalPoint out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = v[k].get_num() * (denominator / v[k].get_den());
  return out;
}

std::array<Integer, 3> primitive_direction(const RationalPoint& direction) {
  std::array<Integer, 3> result;
  Integer common = 0;
  const RationalPoint numbers = whole(direction);
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = numbers[k].get_num();
    common = gcd(common, result[k]);
  }
  require(common != 0, "primitive_direction: zero vector");
  for (Integer& x : result) x /= common;
  return result;
}

std::array<Rational, 4> rotation_quaternion(const RationalPoint& axis, const Rational& degrees) {
  std::array<Integer, 3> a = primitive_direction(axis);
  Rational angle = reduced(degrees);
  if (angle > 180) {  // turn the other way, so that opposite angles are exact inverses
    angle = 360 - angle;
    for (Integer& x : a) x = -x;
  }
  if (angle == 0) return {1, 0, 0, 0};
  if (angle == 180) return {0, a[0], a[1], a[2]};
  const Integer square = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
  const mpfr_prec_t precision = 256 + static_cast<mpfr_prec_t>(mpz_sizeinbase(square.get_mpz_t(), 2));
  Real low(precision), high(precision), length(precision), number(precision);
  radians(low, high, angle / 2);
  mpfr_set_z(length, square.get_mpz_t(), MPFR_RNDN);
  mpfr_sqrt(length, length, MPFR_RNDN);
  const bool small = angle <= 90;
  if (small) {
    mpfr_tan(number, low, MPFR_RNDN);
    mpfr_div(number, number, length, MPFR_RNDN);
  } else {
    mpfr_cot(number, low, MPFR_RNDN);
    mpfr_mul(number, number, length, MPFR_RNDN);
  }
  const Rational slack =
      small ? Rational(angle_tolerance() / length.rational()) : Rational(angle_tolerance() * length.rational());
  const Rational middle = number.rational();
  const Rational bottom = middle > slack ? Rational(middle - slack) : Rational(0);
  const Rational best = simplest_between(bottom, middle + slack);
  if (small) return {1, best * a[0], best * a[1], best * a[2]};
  return {best, a[0], a[1], a[2]};
}

}  // namespace cnrg
