// A tree with finer curved leaves: for studies of convergence, and for files that look smooth.
#pragma once

#include "csg/tree/tree.h"

namespace cnrg {

/// Makes every curved leaf of the tree `times` as fine (1 or more): `segments` and `rings` are multiplied by it,
/// given or not, and `chord` is divided by its square, as the distance of a chord from its curve goes with the
/// square of its length. Points of the coarser shape stay points of the finer one where counts are given. Other
/// leaves are as they were: a grid, a mesh, a result that was read back. Throws TreeError at a leaf that would
/// have more segments or rings than it may.
void make_finer(Tree& tree, int times);

}  // namespace cnrg
