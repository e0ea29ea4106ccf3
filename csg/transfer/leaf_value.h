// The value of a leaf that is a result read back (csg/leaves/cell_table.h), on a complex where other leaves may
// cut its cells.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "csg/leaves/cell_table.h"
#include "csg/operators/node_value.h"
#include "csg/transfer/cell_map.h"
#include "kernel/complex/draft.h"

namespace cnrg {

/// The cells of the file as a part of the complex; `points`: the vertices of its points.
CellMap::Part part_of(LeafId leaf, const CellTable& table, std::span<const VertexId> points);

/// `cells` are the cells of the leaf as leaf_groups has them; `map` has the leaf among its parts; `attributes` are
/// those of each component, `said` those that cells have (`table.said`, placed as the leaf is). The regions of a
/// group are numbered as detection finds them. Throws InputError if the cells of the file overlap or are no group
/// where the file says so.
/// Cells came from the leaf, and from those that made them (`table.makers`), whose cells are added to `held`.
NodeValue leaf_value(const Complex& complex, LeafId leaf, const Group& cells, const CellTable& table,
                     const CellMap& map, const std::vector<Attributes>& attributes,
                     const std::vector<Attributes>& said, HeldCells* held = nullptr);

}  // namespace cnrg
