// Interval arithmetic of this room: CGAL's intervals under a rounding mode that is set once per call.
#pragma once

#include <CGAL/Interval_nt.h>

#include <array>
#include <cmath>
#include <limits>

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

inline Interval3 cross(const Interval3& a, const Interval3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Interval dot(const Interval3& a, const Interval3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// (b - a) x (c - a)
inline Interval3 normal(const PointView& a, const PointView& b, const PointView& c) {
  const Interval3 o = of(a);
  return cross(of(b) - o, of(c) - o);
}

}  // namespace cnrg::enclosure
