// Six times a volume is a determinant of differences of coordinates. With all coordinates as integers in one unit,
// a sum of many needs no fractions until its end.
#include "csg/mesh/exact_volume.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace cnrg {

ExactVolume::ExactVolume(const std::vector<std::array<double, 3>>& points) {
  // A double is an odd integer times a power of two; the least of these powers is the unit.
  const auto lowest_bit = [](double x) {
    int exponent;
    const auto mantissa = std::int64_t(std::ldexp(std::frexp(std::abs(x), &exponent), 53));
    return std::int64_t(exponent) - 53 + __builtin_ctzll(std::uint64_t(mantissa));
  };
  bool any = false;
  for (const auto& p : points) {
    for (const double x : p) {
      if (x == 0) continue;
      exponent_ = any ? std::min(exponent_, lowest_bit(x)) : lowest_bit(x);
      any = true;
    }
  }
  scaled_.reserve(3 * points.size());
  for (const auto& p : points) {
    for (const double x : p) {
      const Rational exact = from_double(x);
      Integer n = exact.get_num();
      // x / 2^exponent is an integer: the denominator is a power of two that divides the unit's.
      const auto shift = std::int64_t(mpz_sizeinbase(exact.get_den().get_mpz_t(), 2)) - 1 + exponent_;
      if (shift <= 0) n <<= static_cast<mp_bitcnt_t>(-shift);
      else n >>= static_cast<mp_bitcnt_t>(shift);
      scaled_.push_back(std::move(n));
    }
  }
}

void ExactVolume::add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  const std::uint32_t ends[3] = {b, c, d};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      mpz_sub(edges_[i][k].get_mpz_t(), scaled_[3 * ends[i] + k].get_mpz_t(), scaled_[3 * a + k].get_mpz_t());
  }
  const auto& [u, v, w] = edges_;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    mpz_mul(minor_.get_mpz_t(), v[i].get_mpz_t(), w[j].get_mpz_t());
    mpz_submul(minor_.get_mpz_t(), v[j].get_mpz_t(), w[i].get_mpz_t());
    mpz_addmul(six_.get_mpz_t(), u[k].get_mpz_t(), minor_.get_mpz_t());
  }
}

Rational ExactVolume::value() const {
  Rational result(six_, 6);
  result.canonicalize();
  const auto bits = 3 * static_cast<mp_bitcnt_t>(std::abs(exponent_));
  if (exponent_ >= 0) mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), bits);
  else mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), bits);
  return result;
}

}  // namespace cnrg
