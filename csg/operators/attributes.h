// Attributes of a result's regions from those of the operands (csg/SEMANTICS.md#attributes).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "csg/operators/boolean.h"

namespace cnrg {

/// The attributes of one region from those of the regions that share a 3-cell with it, the strongest first; there
/// is one at least. `strict` as below. `others` becomes the materials that gave way, by name.
RegionAttributes combined(std::span<const RegionAttributes* const> sources, bool strict,
                          std::vector<RegionMaterial>& others);

/// Fills `result.regions` from the regions of `operands` that share a 3-cell with them. The first operand with a
/// region there gives name and material; leaves are merged over all. With `strict` its empty name or material
/// stays empty; otherwise the next one that has any is taken, and materials that differ are returned.
std::vector<MaterialConflict> combine_attributes(Group& result, const std::vector<const Group*>& operands,
                                                 bool strict);

}  // namespace cnrg
