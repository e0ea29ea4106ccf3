// CGAL's arithmetic of bounds by round_up.h: what a machine gives that rounds upward, where this one cannot.
#pragma once

#define CGAL_IA_SQUARE CGAL_IA_SQUARE_of_nearest
#define IA_sqrt_up IA_sqrt_up_of_nearest
#define IA_sqrt_toward_zero IA_sqrt_toward_zero_of_nearest
#include_next <CGAL/FPU.h>
#undef CGAL_IA_SQUARE
#undef IA_sqrt_up
#undef IA_sqrt_toward_zero
#undef CGAL_IA_ADD
#undef CGAL_IA_SUB
#undef CGAL_IA_MUL
#undef CGAL_IA_DIV

#include "../../round_up.h"

#define CNRG_ROUND_UP
#define CGAL_IA_ADD(a, b) (::cnrg::round_up::add(a, b))
#define CGAL_IA_SUB(a, b) (::cnrg::round_up::add(a, -(b)))
#define CGAL_IA_MUL(a, b) (::cnrg::round_up::multiply(a, b))
#define CGAL_IA_DIV(a, b) (::cnrg::round_up::divide(a, b))

namespace CGAL {

inline double CGAL_IA_SQUARE(double a) { return cnrg::round_up::multiply(a, a); }
inline double IA_sqrt_up(double a) { return cnrg::round_up::sqrt_up(a); }
inline double IA_sqrt_toward_zero(double a) { return cnrg::round_up::sqrt_down(a); }

}  // namespace CGAL
