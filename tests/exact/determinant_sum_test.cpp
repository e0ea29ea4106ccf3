// Sums of determinants beside the same in fractions.
#include "kernel/exact/determinant_sum.h"

#include <array>
#include <cmath>
#include <random>

#include "tests/catch.h"

namespace cnrg {
namespace {

/// Coordinates of some bits below 2^(highest + 1) down to multiples of 2^lowest; also 0 and both signs.
double coordinate(std::mt19937_64& random, int lowest, int highest) {
  const auto exponent = std::uniform_int_distribution<int>(lowest, highest)(random);
  const int bits = std::min(53, exponent - lowest + 1);
  const auto mantissa = static_cast<double>(random() >> (64 - bits));
  return (random() % 2 == 0 ? 1 : -1) * (random() % 9 == 0 ? 0 : std::ldexp(mantissa, exponent - bits + 1));
}

Rational exact_determinant(const double* r, const double* p, const double* q) {
  Rational sum = 0;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    sum += from_double(r[k]) * (from_double(p[i]) * from_double(q[j]) - from_double(p[j]) * from_double(q[i]));
  }
  return sum;
}

Rational scaled(const Integer& sum, int exponent) {
  Rational out = sum;
  if (exponent < 0) out >>= static_cast<unsigned long>(-3 * exponent);
  else out <<= static_cast<unsigned long>(3 * exponent);
  return out;
}

TEST_CASE("sums of determinants of doubles are exact, however many bits they span", "[determinant_sum]") {
  std::mt19937_64 random(7);
  for (const auto& [lowest, highest] : {std::array{-52, 0},
                                        {-60, 3},
                                        {-105, 0},
                                        {-106, 0},
                                        {-107, 0},
                                        {-126, 0},
                                        {-200, 100},
                                        {-1074, -1000},
                                        {900, 1000},
                                        {0, 30},
                                        {-1074, 1023}}) {
    for (int run = 0; run < 40; ++run) {
      ScaledPoints points;
      std::vector<std::array<double, 3>> xyz(12);
      for (auto& p : xyz) {
        for (double& x : p) x = coordinate(random, lowest, highest);
        points.add(p.data());
      }
      points.scale();
      REQUIRE(points.size() == xyz.size());
      DeterminantSum first(points), second(points);
      Rational sum = 0;
      for (int term = 0; term < 30; ++term) {
        const std::size_t r = random() % 12, p = random() % 12, q = random() % 12;
        const bool plus = random() % 2 == 0;
        (term % 3 == 0 ? first : second).add(r, p, q, plus);
        const Rational one = exact_determinant(xyz[r].data(), xyz[p].data(), xyz[q].data());
        if (plus) sum += one;
        else sum -= one;
      }
      first.add(second);
      CAPTURE(lowest, highest, run);
      REQUIRE(scaled(first.value(), points.exponent()) == sum);
    }
  }
}

TEST_CASE("the largest numbers of fixed size add up without loss", "[determinant_sum]") {
  // det of 2^106 - 2^53 on the diagonal and its negative elsewhere, a million times.
  const double high = std::ldexp(1 - std::ldexp(1.0, -53), 106), one = 1;
  ScaledPoints points;
  const double xyz[4][3] = {{high, -high, -high}, {-high, high, -high}, {high, high, high}, {one, 0, 0}};
  for (const auto& p : xyz) points.add(p);
  points.scale();
  CHECK(points.exponent() == 0);
  DeterminantSum sum(points);
  for (int i = 0; i < 1000000; ++i) sum.add(0, 1, 2, true);
  CHECK(scaled(sum.value(), 0) == exact_determinant(xyz[0], xyz[1], xyz[2]) * 1000000);
  for (int i = 0; i < 2000000; ++i) sum.add(0, 1, 2, false);
  CHECK(scaled(sum.value(), 0) == -exact_determinant(xyz[0], xyz[1], xyz[2]) * 1000000);
}

}  // namespace
}  // namespace cnrg
