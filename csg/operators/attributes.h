// Attributes of a result's regions from those of the operands (SEMANTICS 4, end).
#pragma once

#include <vector>

#include "csg/operators/boolean.h"

namespace cnrg {

/// Fills `result.regions` from the regions of `operands` that share a 3-cell with them. The first operand with a
/// region there gives name and material; leaves are merged over all. With `strict` its empty name or material
/// stays empty; otherwise the next one that has any is taken, and materials that differ are returned.
std::vector<MaterialConflict> combine_attributes(Group& result, const std::vector<const Group*>& operands,
                                                 bool strict);

}  // namespace cnrg
