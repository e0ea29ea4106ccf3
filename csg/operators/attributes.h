// Attributes of a region of a result from those of the operands (csg/SEMANTICS.md#attributes).
#pragma once

#include <span>
#include <vector>

#include "csg/operators/group.h"
#include "kernel/selection/selection.h"

namespace cnrg {

/// Two materials of operands in one region or component of a result, where dominance does not decide.
struct MaterialConflict {
  RegionMaterial kept, other;  ///< `kept` is the left operand's
  CellSet cells;               ///< where `other` gave way; not empty
};

/// The attributes of one region from those of the regions that share a 3-cell with it, the strongest first; there
/// is one at least. With `strict` an empty name or material of the first one stays empty; otherwise the next one
/// that has any is taken, and `others` becomes the materials that gave way, by name. It has no leaves: these are
/// merged over all, by `add_leaves`.
RegionAttributes combined(std::span<const RegionAttributes* const> sources, bool strict,
                          std::vector<RegionMaterial>& others);

/// The union of two ascending lists, in place.
void add_leaves(std::vector<LeafId>& leaves, const std::vector<LeafId>& more);

}  // namespace cnrg
