// Sines, cosines and rotations of rational angles.
#include <cmath>
#include <numbers>
#include <random>

#include "kernel/base/hypotenuse.h"
#include "kernel/exact/integers.h"
#include "kernel/exact/trigonometry.h"
#include "tests/catch.h"

using namespace cnrg;

namespace {

constexpr long double kPi = std::numbers::pi_v<long double>;

Rational square(const Rational& x) { return x * x; }

/// Cosine and sine of the rational rotation about z.
std::array<Rational, 2> rational_cosine_sine(const Rational& degrees) {
  const auto [w, x, y, z] = rotation_quaternion({0, 0, 1}, degrees);
  const Rational length = square(w) + square(z);
  return {(square(w) - square(z)) / length, 2 * w * z / length};
}

}  // namespace

TEST_CASE("functions of doubles are correctly rounded") {
  static_assert(std::numeric_limits<long double>::digits == 64);  // the oracle has 11 bits more
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> any(-1, 1);
  int sure = 0, wrong = 0;
  const auto check = [&](double found, long double expected) {
    const long double unit = std::ldexp(1.0L, std::ilogb(expected) - 60);
    const double low = static_cast<double>(expected - unit), high = static_cast<double>(expected + unit);
    if (low != high) return;  // next to a tie
    ++sure;
    wrong += found != low;
  };
  for (int i = 0; i < 20000; ++i) {
    const double x = any(random), y = any(random) * std::ldexp(1.0, static_cast<int>(random() % 40) - 20);
    check(rounded::cosine(3 * x), cosl(3 * x));
    check(rounded::tangent(1.5 * x), tanl(1.5 * x));
    check(rounded::arc_sine(x), asinl(x));
    check(rounded::arc_cosine(x), acosl(x));
    check(rounded::arc_tangent(y, x), atan2l(y, x));
  }
  CHECK(wrong == 0);
  CHECK(sure > 98000);
  CHECK(rounded::arc_tangent(0, -1) == static_cast<double>(kPi));
  CHECK(rounded::arc_tangent(std::numeric_limits<double>::infinity(), 1) == static_cast<double>(kPi / 2));
}

TEST_CASE("lengths are right however large or small") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  int wrong = 0;
  for (int i = 0; i < 5000; ++i) {
    const int exponent = static_cast<int>(random() % 1900) - 950;
    const double x = std::ldexp(any(random), exponent), y = std::ldexp(any(random), exponent),
                 z = i % 2 == 0 ? 0 : std::ldexp(any(random), exponent), found = hypotenuse(x, y, z);
    const Rational exact = square(from_double(x)) + square(from_double(y)) + square(from_double(z)),
                   bound = square(fraction(1, 1) + fraction(1, std::int64_t{1} << 51)),
                   of_found = square(from_double(found));
    wrong += of_found > exact * bound || exact > of_found * bound;
  }
  CHECK(wrong == 0);
  CHECK(hypotenuse(0, 0) == 0);
  CHECK(hypotenuse(-3e300, 4e300) == 5e300);
  CHECK(hypotenuse(2, -3, 6) == 7);
}

TEST_CASE("sines of rational degrees are correctly rounded") {
  CHECK(sine_degrees(0) == 0);
  CHECK(sine_degrees(30) == 0.5);
  CHECK(sine_degrees(-30) == -0.5);
  CHECK(sine_degrees(150) == 0.5);
  CHECK(sine_degrees(210) == -0.5);
  CHECK(sine_degrees(90) == 1);
  CHECK(sine_degrees(720) == 0);
  CHECK(cosine_degrees(60) == 0.5);
  CHECK(cosine_degrees(120) == -0.5);
  CHECK(cosine_degrees(180) == -1);
  CHECK(cosine_degrees(90) == 0);
  CHECK(cosine_degrees(-270) == 0);
  CHECK(sine_degrees(45) == cosine_degrees(45));
  CHECK(sine_degrees(45) == std::sqrt(0.5));
  CHECK(sine_degrees(*parse_rational("1e-300")) == Approx(1.7453292519943295e-302L).epsilon(1e-14));
  CHECK(sine_degrees(*parse_rational("1e-400")) == 0);
  CHECK(cosine_degrees(*parse_rational("1e-400")) == 1);
  std::mt19937_64 random(3);
  for (int i = 0; i < 500; ++i) {
    const long p = static_cast<long>(random() % 2000000) - 1000000, q = static_cast<long>(random() % 997) + 1;
    const long double angle = static_cast<long double>(p % (360 * q)) / static_cast<long double>(q) * kPi / 180;
    const Rational degrees = fraction(p, q);
    CAPTURE(degrees);
    REQUIRE(std::fabs(sine_degrees(degrees) - std::sin(angle)) < 1.2e-16L);
    REQUIRE(std::fabs(cosine_degrees(degrees) - std::cos(angle)) < 1.2e-16L);
    REQUIRE(sine_degrees(-degrees) == -sine_degrees(degrees));
    REQUIRE(cosine_degrees(degrees + 360) == cosine_degrees(degrees));
  }
}

TEST_CASE("rounded multiples of a grid") {
  CHECK(round_cosine(0, 2, 0) == 1);
  CHECK(round_cosine(0, 9, -3) == 3);
  CHECK(round_cosine(0, 3, 0) == 2);
  CHECK(round_cosine(60, 9, -1) == Rational(3, 2));
  CHECK(round_cosine(60, 9, 0) == 2);  // 1.5: tie to even
  CHECK(round_cosine(45, 2, -10) == 1);
  CHECK(round_cosine(135, 2, -10) == -1);
  CHECK(round_cosine(90, 2, -10) == 0);
  CHECK(round_cosine(30, 12, -4) == 3);
  for (int degrees = 1; degrees < 360; degrees += 7) {
    const Rational value = round_cosine(degrees, 5, -60);
    const long double expected = std::sqrt(5.0L) * std::cos(degrees * kPi / 180);
    REQUIRE(std::fabs(static_cast<long double>(to_double(value)) - expected) < 5e-16L);
    REQUIRE(Rational(value * (Rational(1) << 60)).get_den() == 1);
  }
  CHECK(exponent_of_root(4) == 1);
  CHECK(exponent_of_root(3) == 0);
  CHECK(exponent_of_root(Rational(1, 4)) == -1);
  CHECK(exponent_of_root(Rational(1, 5)) == -2);
  CHECK(exponent_of_root(Rational(1, 2)) == -1);
}

TEST_CASE("rational rotations are exactly orthogonal and near the angle") {
  std::mt19937_64 random(5);
  for (int i = 0; i < 300; ++i) {
    const Rational degrees = fraction(static_cast<int>(random() % 1000000) - 500000, random() % 1000 + 1);
    const auto [c, s] = rational_cosine_sine(degrees);
    REQUIRE(c * c + s * s == 1);
    // The angle's error is the sine of the difference: c' s - s' c, with c', s' rounded to 2^-80.
    const Rational exact_c = round_cosine(degrees, 1, -80), exact_s = round_cosine(90 - degrees, 1, -80);
    REQUIRE(abs(Rational(s * exact_c - c * exact_s)) < *parse_rational("1e-15"));
    REQUIRE(c * exact_c + s * exact_s > 0);
    REQUIRE(rational_cosine_sine(-degrees) == std::array<Rational, 2>{c, -s});
    REQUIRE(mpz_sizeinbase(c.get_den_mpz_t(), 2) <= 60);
  }
  for (int quarter = -4; quarter <= 8; ++quarter) {
    const int cosine[] = {1, 0, -1, 0}, sine[] = {0, 1, 0, -1}, i = (quarter + 4) % 4;
    CHECK(rational_cosine_sine(90 * quarter) == std::array<Rational, 2>{cosine[i], sine[i]});
  }
}

TEST_CASE("the axis of a rotation is exact") {
  const std::array<Rational, 4> quarter = rotation_quaternion({0, Rational(-1, 10), 0}, 90);
  CHECK(quarter == std::array<Rational, 4>{1, 0, -1, 0});
  CHECK(rotation_quaternion({3, 4, 0}, 90) == std::array<Rational, 4>{1, Rational(3, 5), Rational(4, 5), 0});
  CHECK(rotation_quaternion({1, 1, 1}, 180) == std::array<Rational, 4>{0, 1, 1, 1});
  CHECK(rotation_quaternion({1, 1, 1}, -360) == std::array<Rational, 4>{1, 0, 0, 0});
  CHECK(primitive_direction({Rational(1, 2), Rational(-1, 3), 0}) == std::array<Integer, 3>{3, -2, 0});
}
