// The faces of a box by the numbers of its corners.
#pragma once

#include <cstddef>

namespace cnrg {

/// Bit k of a corner's number is set where coordinate k is the larger one. Faces: x-, x+, y-, y+, z-, z+, their
/// corners counter-clockwise as seen from outside.
inline constexpr std::size_t kBoxFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

}  // namespace cnrg
