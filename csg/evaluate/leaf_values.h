// The values of the leaves, before any operator runs.
#pragma once

#include "csg/evaluate/prepared_leaves.h"
#include "csg/evaluate/value_store.h"
#include "csg/transfer/leaf_value.h"

namespace cnrg {

/// Puts the values of the leaves among some instances (ascending): its group on the complex, with the attributes
/// of its node; of a result read back what its file says. TreeError, at the leaf, for a result whose cells do
/// not fit. `complex` is made of `soup`; `vertex_of`, if one of the leaves is a result, as RefineReport has it.
/// Returns what of leaves below joined nodes holds the cells of these.
HeldCells put_leaf_values(const Tree& tree, const Unfolding& unfolding, std::span<const InstanceId> instances,
                          const PreparedLeaves& leaves, Grades& grades, const Complex& complex, const Soup& soup,
                          const std::vector<VertexId>& vertex_of, ValueStore& values);

}  // namespace cnrg
