// The leaves of a tree as what is welded, where the tree puts them, all together.
//
// A leaf whose points move is replaced by one that is placed already. Facets that are not planar any more become
// triangles; the parameters of patches and curves move with their corners.
#pragma once

#include <string>
#include <vector>

#include "csg/leaves/leaf.h"

namespace cnrg {

struct WeldedLeaves {
  std::vector<LeafInstance> instances;
  std::string notice;  ///< empty: nothing is near; names leaves as `leaf 3, face 2`
};

/// Planes, half-spaces and results read back stay as they are. Throws InputError as `weld`, which names leaves and
/// faces as `leaf 3, face 2`. `moved`: how far points of round leaves may have been moved before
/// (weld_surfaces.h), at most d; all together go no farther than d.
WeldedLeaves weld_leaves(const std::vector<LeafInstance>& instances, const Rational& d, const Rational& moved = 0);

}  // namespace cnrg
