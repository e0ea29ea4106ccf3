// The value of a leaf that is a result read back (csg/leaves/cell_table.h), on a complex where other leaves may
// cut its cells.
#pragma once

#include <vector>

#include "csg/leaves/cell_table.h"
#include "csg/leaves/shapes.h"
#include "csg/operators/node_value.h"

namespace cnrg {

/// `cells` are the cells of the leaf as leaf_groups has them; `transform` is that of its instance; `attributes`
/// are those of each component, `said` those that cells have (`table.said`, placed as the leaf is). The regions of
/// a group are numbered as detection finds them. Throws InputError if the cells of the file overlap or are no
/// group where the file says so.
NodeValue leaf_value(const Complex& complex, LeafId leaf, const Group& cells, const CellTable& table,
                     const Transform& transform, const std::vector<Attributes>& attributes,
                     const std::vector<Attributes>& said);

}  // namespace cnrg
