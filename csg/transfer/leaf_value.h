// The value of a leaf that is a stored one, on a complex where other leaves may cut its cells.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "csg/operators/node_value.h"
#include "csg/transfer/cell_map.h"
#include "csg/transfer/stored_value.h"
#include "kernel/complex/draft.h"

namespace cnrg {

/// The cells of the value as a part of the complex; `points`: the vertices of its points.
CellMap::Part part_of(LeafId leaf, const StoredValue& stored, std::span<const VertexId> points);

/// `cells` are the cells of the leaf as leaf_groups has them; `map` has the leaf among its parts; `attributes` are
/// those of each component, and `placed` makes of what is said of a cell the same where the leaf is. The regions
/// of a group are numbered as detection finds them. Throws InputError if the cells overlap or are no group where
/// the value says so. Cells came from the leaf, and from those that they have as origins, whose cells are added to
/// `held`.
NodeValue leaf_value(const Complex& complex, LeafId leaf, const Group& cells, const StoredValue& stored,
                     const CellMap& map, const std::vector<Attributes>& attributes,
                     const std::function<Attributes(const Attributes&)>& placed, HeldCells* held = nullptr);

}  // namespace cnrg
