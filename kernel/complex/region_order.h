// Which of several sets of points comes first, by where they are.
#pragma once

#include <functional>
#include <vector>

#include "kernel/complex/complex.h"

namespace cnrg {

/// The sets that bodies of space fall into, by the sides of faces that look into them.
struct BodiesOfSpace {
  std::vector<FaceId> faces;                    ///< all that bound one
  std::function<std::uint32_t(HalfFace)> body;  ///< less than `count`; 0 has no place
  std::uint32_t count;
};

/// Bodies 1, 2, ... in their order: by the least vertex, then the least direction from it, then the angle about
/// that, in the coordinates `axes` (nullptr: x, y, z).
std::vector<std::uint32_t> in_order_of_place(const Complex& complex, const BodiesOfSpace& bodies,
                                             const LeafAxes* axes = nullptr);

}  // namespace cnrg
