// Points and normals for people: of few digits, where that is possible.
#pragma once

#include <array>

#include "kernel/complex/complex.h"

namespace cnrg {

/// The integer normal of a side of a face, shortest.
std::array<Integer, 3> shortest_normal(const Complex& complex, HalfFace side);

/// A point in the open region, of few digits if possible. `locator` is that of the complex.
RationalPoint interior_point(const Complex& complex, const Locator& locator, RegionId r);

/// True for a place on the frame of unbounded leaves or outside of it, where nothing is computed.
bool beyond_frame(const Complex& complex, const Location& at);

}  // namespace cnrg
