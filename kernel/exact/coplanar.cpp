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
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>

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

struct ResidueVector {
  Residue x, y, z;
  ResidueVector(const double* from, const double* to, int grid)
      : x(Residue(to[0], grid) - Residue(from[0], grid)),
        y(Residue(to[1], grid) - Residue(from[1], grid)),
        z(Residue(to[2], grid) - Residue(from[2], grid)) {}
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
  Value x = 0, y = 0, z = 0;
  bool fits = true;
  ShortVector(const double* from, const double* to, int grid) {
    Value* const parts[3] = {&x, &y, &z};
    for (int k = 0; k < 3; ++k) {
      const double a = std::ldexp(from[k], -grid), b = std::ldexp(to[k], -grid);  // exact, or too large
      if (!(std::abs(a) < 0x1p53 && std::abs(b) < 0x1p53 && std::abs(b - a) < 0x1p41)) {
        fits = false;
        return;
      }
      *parts[k] = static_cast<std::int64_t>(b) - static_cast<std::int64_t>(a);
    }
  }
};

struct IntegerVector {
  mpz_class x, y, z;
  IntegerVector(const double* from, const double* to, int grid)
      : x(scaled(to[0], grid) - scaled(from[0], grid)),
        y(scaled(to[1], grid) - scaled(from[1], grid)),
        z(scaled(to[2], grid) - scaled(from[2], grid)) {}
};

}  // namespace

bool maybe_coplanar(const double* a, const double* b, const double* c, const double* d) {
  const double ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
  const double vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
  const double wx = d[0] - a[0], wy = d[1] - a[1], wz = d[2] - a[2];
  const double determinant = ux * (vy * wz - vz * wy) - uy * (vx * wz - vz * wx) + uz * (vx * wy - vy * wx);
  const double m = largest({a, b, c, d});
  const double extent = std::max({std::abs(ux), std::abs(uy), std::abs(uz), std::abs(vx), std::abs(vy),
                                  std::abs(vz), std::abs(wx), std::abs(wy), std::abs(wz)});
  const double bound = 256 * kUnit * m * extent * extent;
  return !(std::abs(determinant) > bound && bound > 1e-280 && std::isfinite(determinant));
}

bool maybe_collinear(const double* a, const double* b, const double* c) {
  const double ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
  const double vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
  const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
  const double m = largest({a, b, c});
  const double extent =
      std::max({std::abs(ux), std::abs(uy), std::abs(uz), std::abs(vx), std::abs(vy), std::abs(vz)});
  const double bound = 64 * kUnit * m * extent;
  const double size = std::max({std::abs(x), std::abs(y), std::abs(z)});
  return !(size > bound && bound > 1e-280 && std::isfinite(size));
}

bool coplanar(const double* a, const double* b, const double* c, const double* d) {
  for (int k = 0; k < 3; ++k) {
    if (a[k] == b[k] && a[k] == c[k] && a[k] == d[k]) return true;  // most flat faces of made things
  }
  if (!maybe_coplanar(a, b, c, d)) return false;
  const int grid = grid_exponent({a, b, c, d});
  const ResidueVector p(a, b, grid), q(a, c, grid), r(a, d, grid);
  const Residue residue =
      p.x * (q.y * r.z - q.z * r.y) - p.y * (q.x * r.z - q.z * r.x) + p.z * (q.x * r.y - q.y * r.x);
  if (residue.value != 0) return false;
  const ShortVector s(a, b, grid), t(a, c, grid), n(a, d, grid);
  if (s.fits && t.fits && n.fits) {
    return s.x * (t.y * n.z - t.z * n.y) - s.y * (t.x * n.z - t.z * n.x) + s.z * (t.x * n.y - t.y * n.x) == 0;
  }
  const IntegerVector u(a, b, grid), v(a, c, grid), w(a, d, grid);
  const mpz_class determinant =
      u.x * (v.y * w.z - v.z * w.y) - u.y * (v.x * w.z - v.z * w.x) + u.z * (v.x * w.y - v.y * w.x);
  return determinant == 0;
}

bool collinear(const double* a, const double* b, const double* c) {
  if (!maybe_collinear(a, b, c)) return false;
  const int grid = grid_exponent({a, b, c});
  const IntegerVector u(a, b, grid), v(a, c, grid);
  return u.y * v.z == u.z * v.y && u.z * v.x == u.x * v.z && u.x * v.y == u.y * v.x;
}

}  // namespace cnrg
