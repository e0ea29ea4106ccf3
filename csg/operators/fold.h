// ((a op b) op c) op ... of values in parts, at the cost of what the operands touch.
//
// Boxes tell first which parts of all operands may meet (clusters.h). Each cluster goes through the engine of the
// tables by itself: what a step does there depends on nothing outside. A part that meets none is carried over or
// dropped as a whole: what is outside of the other operand, a row keeps always or removes always.
#pragma once

#include <span>
#include <vector>

#include "csg/operators/attributes.h"
#include "csg/operators/parts.h"
#include "csg/operators/tables.h"

namespace cnrg {

struct FoldResult {
  PartedGroup group;
  Removals removals;                         ///< of all steps, step by step, those of one step in table order
  std::vector<AttributeConflict> conflicts;  ///< step by step, those of one step in the order of its regions
};

/// `dominances[k]` is that of the step that takes in operand k + 1. The value, removals and conflicts are those of
/// `boolean_operation` step by step. Move in operands that are not needed any more: their lists are used again.
FoldResult boolean_fold(const Complex& complex, BooleanOp op, std::span<const Dominance> dominances,
                        std::vector<PartedGroup> operands);

}  // namespace cnrg
