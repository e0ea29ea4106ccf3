// Interval arithmetic of this room: CGAL's intervals under a rounding mode that is set once per call.
#pragma once

#include <CGAL/Interval_nt.h>

#include <array>
#include <cmath>
#include <compare>

#include "kernel/base/products.h"
#include "kernel/exact/cross_filter.h"
#include "kernel/exact/points.h"

#if defined(__EMSCRIPTEN__) && !(defined(CGAL_ALWAYS_ROUND_TO_NEAREST) && defined(CNRG_ROUND_UP))
#error "WebAssembly rounds to nearest only: intervals need CGAL_ALWAYS_ROUND_TO_NEAREST and kernel/stand_ins"
#endif

namespace cnrg::enclosure {

using Interval = CGAL::Interval_nt<false>;
using Interval3 = std::array<Interval, 3>;
/// While one lives, intervals round outward in this thread.
using RoundOutward = CGAL::Protect_FPU_rounding<true>;
/// While one lives, doubles round to nearest, as anywhere else: around calls of functions of doubles.
struct RoundNearest : CGAL::Protect_FPU_rounding<true> {
  RoundNearest() : CGAL::Protect_FPU_rounding<true>(CGAL_FE_TONEAREST) {}
};

using CGAL::IA_up;  // of its macros
/// A double to compute with while a RoundOutward lives, as a bound from above or a guess: each operation rounds
/// upward, on every machine. Those of `double` do so where the mode of the machine decides, and not in
/// WebAssembly.
class Upward {
 public:
  Upward(double value = 0) : value_(value) {}
  explicit operator double() const { return value_; }

  friend Upward operator+(Upward a, Upward b) { return CGAL_IA_ADD(a.value_, b.value_); }
  friend Upward operator-(Upward a, Upward b) { return CGAL_IA_SUB(a.value_, b.value_); }
  friend Upward operator*(Upward a, Upward b) { return CGAL_IA_MUL(a.value_, b.value_); }
  friend Upward operator/(Upward a, Upward b) { return CGAL_IA_DIV(a.value_, b.value_); }
  friend Upward operator-(Upward a) { return -a.value_; }
  friend Upward sqrt(Upward a) { return CGAL::IA_sqrt_up(a.value_); }
  friend Upward abs(Upward a) { return std::abs(a.value_); }
  friend bool isfinite(Upward a) { return std::isfinite(a.value_); }
  friend auto operator<=>(const Upward&, const Upward&) = default;

 private:
  double value_;
};

/// The middle, while a RoundOutward lives.
inline double middle_of(const Interval& x) { return double(Upward(x.inf()) * 0.5 + Upward(x.sup()) * 0.5); }

/// The sign if the interval proves it, kUndecided otherwise (NaN included).
inline int sign_of(const Interval& x) {
  if (x.inf() > 0) return 1;
  if (x.sup() < 0) return -1;
  if (x.inf() == 0 && x.sup() == 0) return 0;
  return kUndecided;
}

inline Interval3 of(const PointView& p) {
  return {Interval(p.lo[0], p.hi[0]), Interval(p.lo[1], p.hi[1]), Interval(p.lo[2], p.hi[2])};
}

inline Interval3 operator-(const Interval3& a, const Interval3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

using cnrg::cross, cnrg::dot;

/// (b - a) x (c - a)
inline Interval3 normal(const PointView& a, const PointView& b, const PointView& c) {
  const Interval3 o = of(a);
  return cross(of(b) - o, of(c) - o);
}

}  // namespace cnrg::enclosure
