// The groups of the leaves, read off the labels and covers of the complex in one pass (csg/SEMANTICS.md#leaves).
//
// Entities of a leaf: the faces that a soup face of it covers, with their closure (cells that other leaves cut
// into their interior included), its wires, its isolated vertices. Regions: the 3-cells with a label of the
// leaf, joined across faces that are no entities.
// Features of a leaf: edges on the boundary of its soup faces that part two of its faces or patches or are a free
// border, and its wires; its isolated vertices, and the ends of feature edges but those where exactly two of
// them continue each other, on a line or on one tessellated curve.
#pragma once

#include <vector>

#include "csg/operators/group.h"

namespace cnrg {

/// The group of each leaf, by LeafId; that of the frame is empty. `attributes[leaf][label - 1]` says what people
/// call a labelled region (missing ones have none); `leaves` of each region is set to the leaf.
std::vector<Group> leaf_groups(const Complex& complex,
                               const std::vector<std::vector<RegionAttributes>>& attributes = {});

}  // namespace cnrg
