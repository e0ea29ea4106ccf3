#include "kernel/exact/determinant_sum.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "kernel/exact/integers.h"

namespace cnrg {
namespace {

using u64 = std::uint64_t;
using u128 = unsigned __int128;
using i128 = __int128;

/// x = mantissa 2^exponent with an odd mantissa, or 0.
struct Decoded {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

/// Bits of a multiple that is narrow: three of them, two sums and 2^60 terms have less than 384.
constexpr int kNarrow = 106;

Decoded decode(double x) {
  if (x == 0) return {};
  int exponent = 0;
  auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  const int zeros = std::countr_zero(static_cast<u64>(mantissa));
  return {mantissa / (std::int64_t{1} << zeros), exponent - 53 + zeros};
}

/// high 2^128 + low.
struct Product {
  i128 high;
  u128 low;
};

Product product(i128 a, i128 b) {
  const auto a1 = static_cast<std::int64_t>(a >> 64), b1 = static_cast<std::int64_t>(b >> 64);
  const auto a0 = static_cast<u64>(a), b0 = static_cast<u64>(b);
  const i128 first = static_cast<i128>(a1) * b0, second = static_cast<i128>(b1) * a0;
  const u128 lowest = static_cast<u128>(a0) * b0;
  const u128 middle = lowest + (static_cast<u128>(first) << 64);
  const u128 low = middle + (static_cast<u128>(second) << 64);
  return {static_cast<i128>(a1) * b1 + (first >> 64) + (second >> 64) + (middle < lowest) + (low < middle), low};
}

Product product_difference(const Product& a, const Product& b) {
  return {a.high - b.high - (a.low < b.low ? 1 : 0), a.low - b.low};
}

}  // namespace

void ScaledPoints::add(const double* xyz) {
  xyz_.insert(xyz_.end(), xyz, xyz + 3);
  ++size_;
}

void ScaledPoints::scale() {
  bool any = false;
  int highest = 0;  // no multiple has bits from here on
  std::vector<Decoded> decoded;
  decoded.reserve(xyz_.size());
  for (const double x : xyz_) {
    const Decoded& d = decoded.emplace_back(decode(x));
    if (d.mantissa == 0) continue;
    const int high = d.exponent + std::bit_width(static_cast<u64>(std::abs(d.mantissa)));
    exponent_ = any ? std::min(exponent_, d.exponent) : d.exponent;
    highest = any ? std::max(highest, high) : high;
    any = true;
  }
  narrow_ = highest - exponent_ <= kNarrow;
  for (const Decoded& d : decoded) {
    const int shift = d.mantissa == 0 ? 0 : d.exponent - exponent_;
    if (narrow_) narrow_xyz_.push_back(static_cast<__int128>(d.mantissa) * (static_cast<__int128>(1) << shift));
    else large_xyz_.push_back(to_integer(d.mantissa) << static_cast<mp_bitcnt_t>(shift));
  }
  xyz_ = {};
}

void DeterminantSum::add(std::size_t r, std::size_t p, std::size_t q, bool plus) {
  if (!points_->narrow_) {
    const Integer* const x = points_->large_xyz_.data();
    Integer minor;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      mpz_mul(minor.get_mpz_t(), x[3 * p + i].get_mpz_t(), x[3 * q + j].get_mpz_t());
      mpz_submul(minor.get_mpz_t(), x[3 * p + j].get_mpz_t(), x[3 * q + i].get_mpz_t());
      if (plus) mpz_addmul(large_.get_mpz_t(), x[3 * r + k].get_mpz_t(), minor.get_mpz_t());
      else mpz_submul(large_.get_mpz_t(), x[3 * r + k].get_mpz_t(), minor.get_mpz_t());
    }
    return;
  }
  const i128* const x = points_->narrow_xyz_.data();
  const i128 *const a = x + 3 * r, *const b = x + 3 * p, *const c = x + 3 * q;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = k == 2 ? 0 : k + 1, j = k == 0 ? 2 : k - 1;
    const Product minor = product_difference(product(b[i], c[j]), product(b[j], c[i]));
    const i128 factor = plus ? a[k] : -a[k];
    const auto low_half = static_cast<i128>(minor.low);
    const Product high = product(factor, minor.high), low = product(factor, low_half);
    // What is read as negative is 2^128 too small.
    const i128 rest = low.high + (low_half < 0 ? factor : 0);
    const u128 middle = static_cast<u128>(rest) + high.low;
    sum_.add({low.low, middle, high.high + (rest < 0 ? -1 : 0) + (middle < high.low ? 1 : 0)});
  }
}

void DeterminantSum::Wide::add(const Wide& other) {
  low += other.low;
  const u128 carry = low < other.low ? 1 : 0;
  const u128 sum = middle + other.middle, carried = sum + carry;
  high += other.high + (sum < middle ? 1 : 0) + (carried < sum ? 1 : 0);
  middle = carried;
}

void DeterminantSum::add(const DeterminantSum& other) {
  sum_.add(other.sum_);
  large_ += other.large_;
}

Integer DeterminantSum::value() const {
  const auto integer = [](u128 x) {
    Integer out = to_integer(static_cast<u64>(x >> 64));
    out <<= 64;
    return Integer(out + to_integer(static_cast<u64>(x)));
  };
  Integer out =
      sum_.high < 0 ? Integer(-integer(-static_cast<u128>(sum_.high))) : integer(static_cast<u128>(sum_.high));
  out <<= 128;
  out += integer(sum_.middle);
  out <<= 128;
  out += integer(sum_.low);
  return out + large_;
}

}  // namespace cnrg
