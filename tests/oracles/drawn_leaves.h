// Random leaves of tree files as text, all that a tree file knows but those of other files.
#pragma once

#include <string>
#include <utility>

#include "tests/scenes/scene.h"

namespace cnrg::properties {

/// Which leaves are drawn besides flat and bounded ones.
struct LeafKinds {
  bool curved = false, unbounded = false;
};

/// The operator and its value, as `box` and `{min: [0, 0, 0], max: [1, 1, 1]}`. Coordinates are whole numbers from
/// 0 to 4, so that leaves lie in each other's planes, share corners and touch; a few are halves and thirds.
std::pair<std::string, std::string> drawn_leaf(scenes::Random& random, const LeafKinds& kinds);
/// A solid box, and a surface that parts all space between 0 and 4.
std::pair<std::string, std::string> drawn_box(scenes::Random& random);
std::pair<std::string, std::string> drawn_horizon(scenes::Random& random);

}  // namespace cnrg::properties
