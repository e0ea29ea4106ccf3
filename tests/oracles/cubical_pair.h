// A pair of cubical groups as a soup for the kernel, and the comparison of both answers cell by cell.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "kernel/exact/rational.h"
#include "tests/oracles/cubical.h"
#include "tests/scenes/scene.h"

namespace cubical {

/// How a pair reaches the kernel.
struct Presentation {
  bool large_a = false, large_b = false;  ///< maximal rectangles instead of unit squares
  /// Where the grid lies in space: a rotation, a shear, a scaling, a reflection; nothing: on whole numbers.
  std::optional<cnrg::scenes::Motion> place;
  bool thorough = false;  ///< identities, classification by rays, complement, simplified counts
};

/// Compares the kernel with the brute force for every operator and dominance. Returns the first difference in
/// words, or an empty string.
std::string compare_pair(const Grid& grid, const Group& a, const Group& b, const Presentation& presentation);

/// The pair of a seed.
struct Pair {
  Group a, b;
  Presentation presentation;
};
Pair random_pair(const Grid& grid, std::uint64_t seed, double loose = 1);

/// Groups with a cube or an entity less.
std::vector<Group> smaller(const Grid& grid, const Group& group);
/// A tree file with both groups and all that is made of them.
std::string tree_file(const Grid& grid, const Pair& pair);

/// The group as a leaf of a scene: faces with their regions, wires, points; in maximal pieces if `large`.
cnrg::scenes::Leaf leaf_of(const Grid& grid, const Group& group, bool large);
/// The group that a leaf of such rectangles, wires and points is.
Group group_of(const Grid& grid, const cnrg::scenes::Leaf& leaf);
/// Applies a motion; the front of a face stays its front, also under a reflection.
void place(const cnrg::scenes::Motion& motion, cnrg::scenes::Leaf& leaf);

}  // namespace cubical
