// The filter's bound: with M the largest coordinate and D the largest difference, every computed difference is off
// by at most 3u M + u D <= 5u M for D <= 2M (u = 2^-53; 2u M of it from coordinates that were rounded). Each of
// the six products of the determinant is then off by less than 3 * 5u M * D^2 * (1 + small) + 4u D^3, their sum by
// less than 6 * (15 + 8) u M D^2 + 6 * 5u D^3 <= 198 u M D^2; 256 u M D^2 covers the bound's own rounding. With
// differences that are not small against M this is about as sharp as bounds get, and two products of a cross
// product give 64 u M D likewise. Products below 1e-280 go to the exact stage, so underflow does no harm.
//
// What passes the filter is mostly nearly zero but not zero: facets of round things. Evaluated modulo the prime
// 2^61 - 1, on the grid of the coordinates, where a power of two is a rotation of bits, it proves itself not zero;
// only a zero residue is evaluated in integers: of 128 bits where the differences are short, as they are on faces
// that were made planar, else of any size.
#include "kernel/exact/coplanar.h"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "kernel/base/products.h"

namespace cnrg {
namespace {

constexpr double kUnit = 0x1p-53;

double largest(std::initializer_list<const double*> points) {
  double m = 0;
  for (const double* p : points) m = std::max({m, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  return m;
}

/// The least exponent e such that all coordinates are integer multiples of 2^e.
int grid_exponent(std::initializer_list<const double*> points) {
  int lowest = 2000;
  for (const double* p : points) {
    for (int k = 0; k < 3; ++k) {
      if (p[k] == 0) continue;
      int e;
      const double mantissa = std::ldexp(std::frexp(std::abs(p[k]), &e), 53);
      lowest = std::min(lowest, e - 53 + std::countr_zero(static_cast<std::uint64_t>(mantissa)));
    }
  }
  return lowest;
}

constexpr std::uint64_t kPrime = (std::uint64_t{1} << 61) - 1;
__extension__ using Wide = unsigned __int128;

/// An integer modulo kPrime.
struct Residue {
  std::uint64_t value = 0;

  Residue() = default;
  explicit Residue(Wide wide) {
    value = static_cast<std::uint64_t>(wide & kPrime) + static_cast<std::uint64_t>(wide >> 61);
    if (value >= kPrime) value -= kPrime;
  }
  /// x / 2^grid, which is an integer.
  Residue(double x, int grid) {
    if (x == 0) return;
    int e;
    const double mantissa = std::ldexp(std::frexp(std::abs(x), &e), 53);
    *this = Residue(static_cast<Wide>(static_cast<std::uint64_t>(mantissa)) << ((e - 53 - grid + 61) % 61));
    if (x < 0 && value != 0) value = kPrime - value;
  }
  friend Residue operator*(Residue a, Residue b) { return Residue(static_cast<Wide>(a.value) * b.value); }
  friend Residue operator+(Residue a, Residue b) { return Residue(static_cast<Wide>(a.value) + b.value); }
  friend Residue operator-(Residue a, Residue b) {
    return Residue(static_cast<Wide>(a.value) + (kPrime - b.value));
  }
};

/// x / 2^grid, an integer.
mpz_class scaled(double x, int grid) {
  mpz_class value;
  if (x == 0) return value;
  int e;
  const double mantissa = std::ldexp(std::frexp(x, &e), 53);
  mpz_set_d(value.get_mpz_t(), mantissa);
  const int shift = e - 53 - grid;  // negative where the mantissa ends with zeros, which then go
  if (shift >= 0) value <<= static_cast<mp_bitcnt_t>(shift);
  else value >>= static_cast<mp_bitcnt_t>(-shift);
  return value;
}

/// Differences of at most 41 bits on the grid, whose determinant fits into 128.
struct ShortVector {
  __extension__ using Value = __int128;
  std::array<Value, 3> parts{};
  bool fits = true;
  ShortVector(const double* from, const double* to, int grid) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = std::ldexp(from[k], -grid), b = std::ldexp(to[k], -grid);  // exact, or too large
      if (!(std::abs(a) < 0x1p53 && std::abs(b) < 0x1p53 && std::abs(b - a) < 0x1p41)) {
        fits = false;
        return;
      }
      parts[k] = static_cast<std::int64_t>(b) - static_cast<std::int64_t>(a);
    }
  }
};

/// From one point to another, in the numbers that `number` makes of coordinates.
template <class Number>
auto way(const double* from, const double* to, const Number& number) {
  using N = decltype(number(0.0));
  return std::array<N, 3>{N(number(to[0]) - number(from[0])), N(number(to[1]) - number(from[1])),
                          N(number(to[2]) - number(from[2]))};
}
double as_it_is(double x) { return x; }

}  // namespace

bool maybe_coplanar(const double* a, const double* b, const double* c, const double* d) {
  const std::array<double, 3> u = way(a, b, as_it_is), v = way(a, c, as_it_is), w = way(a, d, as_it_is);
  const double determinant = dot(u, cross(v, w)), m = largest({a, b, c, d}),
               extent = largest({u.data(), v.data(), w.data()});
  const double bound = 256 * kUnit * m * extent * extent;
  return !(std::abs(determinant) > bound && bound > 1e-280 && std::isfinite(determinant));
}

bool maybe_collinear(const double* a, const double* b, const double* c) {
  const std::array<double, 3> u = way(a, b, as_it_is), v = way(a, c, as_it_is), normal = cross(u, v);
  const double bound = 64 * kUnit * largest({a, b, c}) * largest({u.data(), v.data()});
  const double size = largest({normal.data()});
  return !(size > bound && bound > 1e-280 && std::isfinite(size));
}

bool coplanar(const double* a, const double* b, const double* c, const double* d) {
  for (int k = 0; k < 3; ++k) {
    if (a[k] == b[k] && a[k] == c[k] && a[k] == d[k]) return true;  // most flat faces of made things
  }
  if (!maybe_coplanar(a, b, c, d)) return false;
  const int grid = grid_exponent({a, b, c, d});
  const auto residue = [grid](double x) { return Residue(x, grid); };
  if (dot(way(a, b, residue), cross(way(a, c, residue), way(a, d, residue))).value != 0) return false;
  const ShortVector s(a, b, grid), t(a, c, grid), n(a, d, grid);
  if (s.fits && t.fits && n.fits) return dot(s.parts, cross(t.parts, n.parts)) == 0;
  const auto integer = [grid](double x) { return scaled(x, grid); };
  return dot(way(a, b, integer), cross(way(a, c, integer), way(a, d, integer))) == 0;
}

bool collinear(const double* a, const double* b, const double* c) {
  if (!maybe_collinear(a, b, c)) return false;
  const int grid = grid_exponent({a, b, c});
  const auto integer = [grid](double x) { return scaled(x, grid); };
  return cross(way(a, b, integer), way(a, c, integer)) == std::array<mpz_class, 3>{0, 0, 0};
}

}  // namespace cnrg
