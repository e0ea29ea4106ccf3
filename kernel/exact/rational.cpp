// Text, doubles and sums of exact fractions.
//
// Each conversion rounds once, from the exact value: a quotient of shifted integers with its remainder says
// both the digits and the side of the tie, so no intermediate precision has to be chosen.
#include "kernel/exact/rational.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/base/error.h"
#include "kernel/exact/integers.h"

namespace cnrg {
namespace {

constexpr std::int64_t kExponentLimit = 100000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// One unsigned decimal at the front of `text`, which is advanced behind it.
std::optional<Rational> take_decimal(std::string_view& text) {
  std::string digits;
  std::int64_t exponent = 0;
  std::size_t i = 0;
  while (i < text.size() && is_digit(text[i])) digits += text[i++];
  if (i < text.size() && text[i] == '.') {
    ++i;
    while (i < text.size() && is_digit(text[i])) {
      digits += text[i++];
      --exponent;
    }
  }
  if (digits.empty()) return std::nullopt;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    bool negative = false;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) negative = text[i++] == '-';
    if (i == text.size() || !is_digit(text[i])) return std::nullopt;
    std::int64_t written = 0;
    while (i < text.size() && is_digit(text[i]))
      written = std::min(written * 10 + (text[i++] - '0'), kExponentLimit + 1);
    if (written > kExponentLimit) return std::nullopt;
    exponent += negative ? -written : written;
  }
  text.remove_prefix(i);
  Rational value{Integer(digits, 10)};
  if (exponent > 0) value *= power_of_ten(static_cast<std::size_t>(exponent));
  if (exponent < 0) value /= Rational(power_of_ten(static_cast<std::size_t>(-exponent)));
  return value;
}

std::int64_t bits(const Integer& n) { return static_cast<std::int64_t>(mpz_sizeinbase(n.get_mpz_t(), 2)); }

/// The integer nearest to n / d (n >= 0, d > 0), ties to even.
Integer divide_nearest(const Integer& n, const Integer& d) {
  Integer q, r;
  mpz_fdiv_qr(q.get_mpz_t(), r.get_mpz_t(), n.get_mpz_t(), d.get_mpz_t());
  r *= 2;
  const int side = cmp(r, d);
  if (side > 0 || (side == 0 && mpz_odd_p(q.get_mpz_t()))) q += 1;
  return q;
}

/// n * 2^shift for n, and n for a negative shift with the power moved to `d`.
void scale_by_two(Integer& n, Integer& d, std::int64_t shift) {
  if (shift > 0) n <<= static_cast<mp_bitcnt_t>(shift);
  if (shift < 0) d <<= static_cast<mp_bitcnt_t>(-shift);
}

}  // namespace

std::optional<Rational> parse_rational(std::string_view text) {
  bool negative = false;
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) {
    negative = text[0] == '-';
    text.remove_prefix(1);
  }
  std::optional<Rational> value = take_decimal(text);
  if (!value) return std::nullopt;
  if (!text.empty() && text[0] == '/') {
    text.remove_prefix(1);
    const std::optional<Rational> denominator = take_decimal(text);
    if (!denominator || *denominator == 0) return std::nullopt;
    *value /= *denominator;
  }
  if (!text.empty()) return std::nullopt;
  if (negative) *value = -*value;
  return value;
}

std::string to_string(const Rational& value) { return value.get_str(); }

std::string to_decimal(const Rational& value, int digits) {
  require(digits > 0, "to_decimal: at least one digit");
  if (value == 0) return "0";
  const Integer n = abs(value.get_num());
  const Integer& d = value.get_den();
  // The power of ten: 10^k <= n/d < 10^(k+1), from the bit lengths and then exactly.
  auto k = static_cast<std::int64_t>(std::floor(static_cast<double>(bits(n) - bits(d)) * 0.30102999566398120));
  const auto at_least = [&](std::int64_t e) {
    return e >= 0 ? n >= d * power_of_ten(static_cast<std::size_t>(e))
                  : n * power_of_ten(static_cast<std::size_t>(-e)) >= d;
  };
  while (!at_least(k)) --k;
  while (at_least(k + 1)) ++k;
  const std::int64_t lowest = k - digits + 1;
  Integer q = lowest >= 0 ? divide_nearest(n, d * power_of_ten(static_cast<std::size_t>(lowest)))
                          : divide_nearest(n * power_of_ten(static_cast<std::size_t>(-lowest)), d);
  std::string text = q.get_str();
  if (text.size() > static_cast<std::size_t>(digits)) ++k;  // rounded up to the next power of ten
  text.erase(text.find_last_not_of('0') + 1);
  const auto count = static_cast<std::int64_t>(text.size());
  const std::string sign = sgn(value) < 0 ? "-" : "";

  std::string plain;
  const std::int64_t plain_length =
      (k < 0 ? 1 - k : k + 1) + std::max<std::int64_t>(0, count - std::max<std::int64_t>(k, 0));
  if (plain_length < 64) {
    const std::size_t whole = static_cast<std::size_t>(std::max<std::int64_t>(k + 1, 0));
    plain = text;
    if (k < 0) plain.insert(0, static_cast<std::size_t>(-k - 1), '0').insert(0, "0.");
    else if (text.size() <= whole) plain.append(whole - text.size(), '0');
    else plain.insert(whole, 1, '.');
    if (sign.size() + plain.size() <= 21) return sign + plain;
  }
  std::string mantissa = text.substr(0, 1);
  if (count > 1) mantissa.append(1, '.').append(text, 1);
  return sign + mantissa + "e" + std::to_string(k);
}

double to_double(const Rational& value) {
  const int sign = sgn(value);
  if (sign == 0) return 0;
  Integer n = abs(value.get_num());
  Integer d = value.get_den();
  std::int64_t exponent = bits(n) - bits(d);  // of the leading bit: this or one less
  if (exponent > 1025) return sign * std::numeric_limits<double>::infinity();
  if (exponent < -1080) return sign * 0.0;
  {
    Integer a = n, b = d;
    scale_by_two(a, b, -exponent);
    if (a < b) --exponent;
  }
  const std::int64_t lowest =
      std::max<std::int64_t>(exponent - 52, -1074);  // the last bit that the double can hold
  scale_by_two(n, d, -lowest);
  const Integer q = divide_nearest(n, d);  // at most 2^53
  return sign * std::ldexp(q.get_d(), static_cast<int>(lowest));
}

Rational from_double(double value) {
  require(std::isfinite(value), "from_double: not a finite number");
  return Rational(value);
}

bool is_double(const Rational& value) {
  if (value == 0) return true;
  const mpz_srcptr n = value.get_num_mpz_t(), d = value.get_den_mpz_t();
  const auto denominator_bits = static_cast<std::int64_t>(mpz_scan1(d, 0));
  if (mpz_sizeinbase(d, 2) != static_cast<std::size_t>(denominator_bits) + 1) return false;  // no power of two
  const auto high = static_cast<std::int64_t>(mpz_sizeinbase(n, 2)),
             low = static_cast<std::int64_t>(mpz_scan1(n, 0));
  return high - low <= 53 && low - denominator_bits >= -1074 && high - denominator_bits <= 1024;
}

Rational sum(std::vector<Rational> values) {
  if (values.empty()) return 0;
  // Neighbours are added level by level, so that both operands of an addition have about the same size.
  for (std::size_t n = values.size(); n > 1; n = (n + 1) / 2) {
    for (std::size_t i = 0; i + 1 < n; i += 2) {
      Rational& target = values[i / 2];
      if (i == 0) target += values[1];
      else mpq_add(target.get_mpq_t(), values[i].get_mpq_t(), values[i + 1].get_mpq_t());
    }
    if (n % 2 == 1) values[n / 2].swap(values[n - 1]);
  }
  return std::move(values[0]);
}

}  // namespace cnrg
