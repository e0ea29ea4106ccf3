// CGAL's kernel of lazy numbers, and the way there from ours, for the files that include CGAL's algorithms over
// it: the dearest of the house to compile, so that they are all in this room.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "kernel/exact/rational.h"

namespace cnrg::lazy {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

// The exact type below the lazy one depends on how CGAL was set up; all of them are made of GMP's fractions.
using Exact = std::decay_t<decltype(std::declval<Kernel::FT>().exact())>;

inline Kernel::FT number(const Rational& value) {
  return is_double(value) ? Kernel::FT(to_double(value)) : Kernel::FT(Exact(value.get_mpq_t()));
}
inline Kernel::Point_3 point(const RationalPoint& p) { return {number(p[0]), number(p[1]), number(p[2])}; }

}  // namespace cnrg::lazy
