// Integers of GMP from machine integers and back, with the same values on every platform.
//
// GMP's own conversions take and return `long`. It has 32 bits on 64-bit Windows, on wasm and on 32-bit systems,
// where a cast to it cuts a number off without a word. Here numbers go by mpz_import and mpz_export, whose words
// have a stated size. No other file of the project names the type `long` or GMP's functions that end in `_si` and
// `_ui` (tests/pages/widths_test.cpp).
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "kernel/base/error.h"
#include "kernel/exact/rational.h"

namespace cnrg {

/// The integer n.
template <std::integral T>
Integer to_integer(T n) {
  static_assert(sizeof(T) <= sizeof(std::uint64_t));
  const bool negative = std::cmp_less(n, 0);
  std::uint64_t size = static_cast<std::uint64_t>(n);
  if (negative) size = 0 - size;
  Integer out;
  mpz_import(out.get_mpz_t(), 1, -1, sizeof size, 0, 0, &size);
  if (negative) mpz_neg(out.get_mpz_t(), out.get_mpz_t());
  return out;
}

/// True if T has the value n.
template <std::integral T>
bool fits(const Integer& n) {
  if (mpz_sizeinbase(n.get_mpz_t(), 2) > std::numeric_limits<T>::digits)
    return n == to_integer(std::numeric_limits<T>::min());
  return std::signed_integral<T> || sgn(n) >= 0;
}

/// The value n as a T. REQUIRES: fits<T>(n), or an InvariantError is thrown.
template <std::integral T>
T to_machine(const Integer& n) {
  require(fits<T>(n), "to_machine: too large");
  std::uint64_t size = 0;
  mpz_export(&size, nullptr, -1, sizeof size, 0, 0, n.get_mpz_t());
  return static_cast<T>(sgn(n) < 0 ? 0 - size : size);
}

/// `n` as functions of GMP take it; an InvariantError where it is too large for them.
inline unsigned long gmp_unsigned(std::size_t n) {
  require(std::in_range<unsigned long>(n), "a number that is too large for GMP");
  return static_cast<unsigned long>(n);
}

/// Binary digits.
inline std::size_t bits_of(const Integer& n) { return mpz_sizeinbase(n.get_mpz_t(), 2); }
/// Of numerator and denominator together.
inline std::size_t bits_of(const Rational& x) {
  return mpz_sizeinbase(x.get_num_mpz_t(), 2) + mpz_sizeinbase(x.get_den_mpz_t(), 2);
}
/// Of all three coordinates together.
inline std::size_t bits_of(const RationalPoint& p) { return bits_of(p[0]) + bits_of(p[1]) + bits_of(p[2]); }

/// 10^exponent.
inline Integer power_of_ten(std::size_t exponent) {
  Integer out;
  mpz_ui_pow_ui(out.get_mpz_t(), 10, gmp_unsigned(exponent));
  return out;
}

/// n choose k.
inline Integer binomial(std::size_t n, std::size_t k) {
  Integer out;
  mpz_bin_uiui(out.get_mpz_t(), gmp_unsigned(n), gmp_unsigned(k));
  return out;
}

/// a / b in lowest terms.
inline Rational fraction(std::int64_t a, std::int64_t b) {
  Rational result(to_integer(a), to_integer(b));
  result.canonicalize();
  return result;
}

}  // namespace cnrg
