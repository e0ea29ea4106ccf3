// The leaves of a tree as what is welded, where the tree puts them, all together.
//
// A leaf whose points move is replaced by one that is placed already. Facets that are not planar any more become
// triangles; the parameters of patches and curves move with their corners.
#pragma once

#include <vector>

#include "csg/leaves/leaf.h"
#include "kernel/base/leaf_words.h"

namespace cnrg {

struct WeldedLeaves {
  std::vector<LeafInstance> instances;
  LeafWords notice;  ///< empty: nothing is near
};

/// Planes, half-spaces and results read back stay as they are. Throws LeafError as `weld`. `moved`: how far points
/// of round leaves may have been moved before (weld_surfaces.h), at most d; all together go no farther than d.
WeldedLeaves weld_leaves(const std::vector<LeafInstance>& instances, const Rational& d, const Rational& moved = 0);

}  // namespace cnrg
