// Sums, products, quotients and roots rounded upward, where a machine rounds to nearest only: the same doubles as
// by a machine that rounds upward.
//
// The error of a result to nearest is a double, too, in the absence of overflow and underflow (Dekker, Knuth).
// Only its sign is asked for: where the true value is above the result, the next double is taken. To take it
// always, as CGAL does by itself, makes an interval of what is exact, and a zero is never proven. Where a product
// of parts may underflow or overflow, mantissas are taken instead of numbers.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace cnrg::round_up {

inline constexpr double kLargest = std::numeric_limits<double>::max();

/// The next double above a finite one.
inline double above(double x) {
  if (x == 0) return std::numeric_limits<double>::denorm_min();
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(x) + (x > 0 ? 1 : -1));
}
inline double below(double x) { return -above(-x); }

/// What is beyond the doubles, of operands that are doubles: downward it is the largest one.
inline double beyond(double nearest, bool finite) { return finite && nearest < 0 ? -kLargest : nearest; }

/// True where the parts of products neither underflow nor overflow.
inline bool is_moderate(double x) {
  const double size = std::fabs(x);
  return 0x1p-450 < size && size < 0x1p450;
}

/// x * y - product, exactly, of moderate numbers.
inline double product_error(double x, double y, double product) {
  constexpr double kSplit = 134217729;  // 2^27 + 1
  const double a = kSplit * x, b = kSplit * y;
  const double x1 = a - (a - x), y1 = b - (b - y), x2 = x - x1, y2 = y - y1;
  return ((x1 * y1 - product) + x1 * y2 + x2 * y1) + x2 * y2;
}

inline double add(double a, double b) {
  const double sum = a + b;
  if (!std::isfinite(sum)) return beyond(sum, std::isfinite(a) && std::isfinite(b));
  const bool first = std::fabs(a) >= std::fabs(b);
  const double large = first ? a : b, small = first ? b : a;
  return small - (sum - large) > 0 ? above(sum) : sum;
}

inline double multiply(double a, double b) {
  const double product = a * b;
  if (!std::isfinite(product)) return beyond(product, std::isfinite(a) && std::isfinite(b));
  if (a == 0 || b == 0) return product;
  if (is_moderate(a) && is_moderate(b)) return product_error(a, b, product) > 0 ? above(product) : product;
  int i = 0, j = 0;
  const double x = std::frexp(a, &i), y = std::frexp(b, &j);
  return std::fma(x, y, -std::ldexp(product, -(i + j))) > 0 ? above(product) : product;
}

inline double divide(double a, double b) {
  const double quotient = a / b;
  if (!std::isfinite(quotient)) return beyond(quotient, std::isfinite(a) && std::isfinite(b) && b != 0);
  if (a == 0 || !std::isfinite(b)) return quotient;
  int i = 0, j = 0;
  const double x = std::frexp(a, &i), y = std::frexp(b, &j);
  const double rest = std::fma(-std::ldexp(quotient, j - i), y, x);
  return (b > 0 ? rest > 0 : rest < 0) ? above(quotient) : quotient;
}

/// The sign of x - root^2, for the root to nearest of a positive number.
inline double square_rest(double x, double root) {
  if (is_moderate(x)) {
    const double square = root * root;
    return (x - square) - product_error(root, root, square);
  }
  int i = 0;
  double mantissa = std::frexp(x, &i);
  if (i % 2 != 0) {
    mantissa *= 2;
    --i;
  }
  const double scaled = std::ldexp(root, -i / 2);
  return std::fma(-scaled, scaled, mantissa);
}

inline double sqrt_up(double x) {
  const double root = std::sqrt(x);
  return x > 0 && std::isfinite(x) && square_rest(x, root) > 0 ? above(root) : root;
}
/// 0 of what is not positive.
inline double sqrt_down(double x) {
  if (!(x > 0)) return 0;
  const double root = std::sqrt(x);
  return std::isfinite(x) && square_rest(x, root) < 0 ? below(root) : root;
}

}  // namespace cnrg::round_up
