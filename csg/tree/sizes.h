// How long edges of a mesh are to be: what the tree says of its leaves.
//
// A node speaks for the leaves below it, and of the nodes on the way from the root down to a leaf the last one
// that says something counts: what is said near a leaf is meant for it. Where several ways lead to one leaf, since
// a node has several users, the shortest length that comes along a way counts. Lengths are those of the model as
// it stands: transforms move a leaf, and leave what is said of it.
#pragma once

#include <vector>

#include "csg/tree/tree.h"

namespace cnrg {

/// Some node of the tree says a length.
bool says_sizes(const Tree& tree);

/// The lengths that hold for the leaves below an instance, in the order of their instances, as doubles; 0: nobody
/// says. Empty if nobody says anything. `above`: what the root hears from its users. Iterative; costs what is
/// below.
std::vector<double> leaf_sizes(const Tree& tree, const IdVector<InstanceId, Instance>& instances, InstanceId root,
                               double above = 0);

}  // namespace cnrg
