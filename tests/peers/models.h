// Operands built by hand, and what is measured of results: by formulas of their own, not by the library's.
#pragma once

#include "bench/peers/system.h"

namespace cnrg::peers {

using bench::Model;
using bench::Operation;
using bench::Problem;

/// An axis-parallel box.
Model box(const RationalPoint& low, const RationalPoint& high);
/// A parallelogram at `corner` as a surface.
Model sheet(const RationalPoint& corner, const RationalPoint& u, const RationalPoint& v);
Model wire(const RationalPoint& a, const RationalPoint& b);
Model point(const RationalPoint& p);

Problem pair_of(Model a, Operation operation, Model b);

/// Signed: cones from the origin over all solid faces.
Rational volume(const Model& model);
/// Of the faces that are no solid's, if they are parallel to coordinate planes.
Rational sheet_area(const Model& model);
/// Of wires that are parallel to the axes.
Rational wire_length(const Model& model);
/// Points at the place of another one.
std::size_t duplicates(const Model& model);
/// Each side of the solid faces is walked there as often as back, point by point.
bool closed(const Model& model);

}  // namespace cnrg::peers
