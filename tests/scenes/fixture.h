// Scenes as text: one line per part, `#` starts a comment.
//
//   leaf FILL                  a new leaf: sides, winding, parity, cells or none
//   box x y z, x y z           lowest and highest corner; faces outward, region 1 behind (with sides)
//   tetrahedron p, q, r, s     outward in any order
//   prism v | p, q, r, ...     the base swept along v
//   face p, q, r, ... | ...    the outer loop, then holes; `face FRONT BACK: p, ...` names regions
//   wire p, q, ...             a chain of segments
//   point p
//
// A number is a decimal, a fraction (both exact) or a double in hexadecimal (0x1p-900).
#pragma once

#include <string>
#include <vector>

#include "tests/scenes/scene.h"

namespace cnrg::scenes {

/// Throws std::invalid_argument with the line for text that is no fixture.
std::vector<Leaf> parse_fixture(const std::string& text);

}  // namespace cnrg::scenes
