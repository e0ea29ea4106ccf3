// Trees of unions of small solids as texts of tree files.
#pragma once

#include <string>

namespace cnrg::bench {

struct ScatteredSolids {
  int nodes = 1000;  ///< unions; there is one more solid
  unsigned seed = 1;
};

/// Solids scattered in space, every tenth overlaps the one before it: ((a u b) u c) u ... .
std::string scattered_chain(const ScatteredSolids& s);
/// The same solids, a union of each and the next.
std::string scattered_pairs(const ScatteredSolids& s);

/// Integer boxes and tetrahedra along a way that winds through a lattice, each overlaps the next and others beside
/// the way; `depth` unions, one after the other. Coordinates are from 0 to less than 2^`kWindingBits` whatever the
/// depth, which is at most 1,000.
std::string winding_chain(int depth, unsigned seed);
inline constexpr int kWindingBits = 7;

/// The first `layers` + 1 of such solids; node j of a layer unites nodes j and j + 1 of the layer below, so that
/// nearly each value has two users. The nodes are called `n<layer>_<j>`, layers from 1; the last has one node.
std::string shared_layers(int layers, unsigned seed);

}  // namespace cnrg::bench
