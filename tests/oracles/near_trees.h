// Random trees of boxes, tetrahedra, sheets, wires and points with names, materials and attributes, whose corners
// are those of a lattice but for a jitter: what touches there nearly touches here.
#pragma once

#include <string>
#include <vector>

#include "tests/result/near_scenes.h"

namespace cnrg::properties {

struct NearTree {
  struct Leaf {
    test::LatticeLeaf shape;
    std::vector<std::array<int, 3>> jitter;  ///< of each corner, in units
  };
  std::vector<Leaf> leaves;
  std::string op;         ///< of all leaves: `union` or `sum`
  std::string dominance;  ///< a word, or nothing
  Rational unit, within;  ///< of the jitter; what is nearer is to be joined
};

/// Distances to join by that are a few units or just above one.
NearTree near_tree(std::uint64_t seed);
/// Units of 1e-17, for doubles.
NearTree slight_tree(std::uint64_t seed);
/// The tree file: `model` is all leaves together, `joined` the same with `within`; the result is `result`.
std::string text_of(const NearTree& tree, const std::string& result);
/// With a leaf, or a corner's jitter, less.
std::vector<NearTree> smaller(const NearTree& tree);

/// The first thing that is wrong with what `join` makes of `model`, or with the node `joined`; empty if nothing
/// is.
std::string join_failure(const NearTree& tree);
/// The same of what `snap` makes of it.
std::string snap_failure(const NearTree& tree);

}  // namespace cnrg::properties
