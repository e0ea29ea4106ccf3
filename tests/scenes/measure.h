// Measures of cells by the divergence theorem and a point inside of every cell: short, exact, on their own.
#pragma once

#include "kernel/complex/complex.h"

namespace cnrg::scenes {

/// The volume of a bounded region.
Rational volume(const Complex& complex, RegionId region);
/// Volumes of all bounded regions, ascending.
std::vector<Rational> volumes(const Complex& complex);
/// A point in the relative interior of a cell. That of a region lies off every wire and isolated vertex too.
RationalPoint point_in(const Complex& complex, EdgeId e);
RationalPoint point_in(const Complex& complex, FaceId f);
RationalPoint point_in(const Complex& complex, RegionId r);

}  // namespace cnrg::scenes
