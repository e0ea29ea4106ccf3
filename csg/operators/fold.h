// ((a op b) op c) op ... of values in parts, at the cost of what the operands touch.
//
// Boxes tell first which parts of all operands may meet. Each cluster goes through the engine of the
// tables by itself: what a step does there depends on nothing outside. A part that meets none is carried over or
// dropped as a whole: what is outside of the other operand, a row keeps always or removes always.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "csg/operators/attributes.h"
#include "csg/operators/leaf_order.h"
#include "csg/operators/parts.h"
#include "csg/operators/tables.h"

namespace cnrg {

struct FoldResult {
  PartedGroup group;
  Removals removals;                         ///< of all steps, step by step, those of one step in table order
  std::vector<AttributeConflict> conflicts;  ///< step by step, those of one step in the order of its regions
};

/// `dominances[k]` is that of the step that takes in operand k + 1; `order` that of the leaves below the node,
/// where there is one. The value, removals and conflicts are those of `boolean_operation` step by step. Move in
/// operands that are not needed any more: their lists are used again.
FoldResult boolean_fold(const Complex& complex, BooleanOp op, std::span<const Dominance> dominances,
                        std::vector<PartedGroup> operands, const LeafOrder& order = {},
                        Removed removed = Removed::counted);

/// What became of the value in one step.
struct StepOfFold {
  Removals removals;                         ///< in table order
  std::vector<AttributeConflict> conflicts;  ///< in the order of the regions of the step's result
  std::optional<Totals> totals;              ///< of the value after the step
  double seconds = 0;
};

struct FoldInSteps {
  PartedGroup group;
  std::vector<StepOfFold> steps;  ///< one less than operands
};

/// The same, told step by step. With `totals` the sums over the value after each step are known, unless something
/// is said of single cells, the space has a frame, a region has no bounds, or a merged face would be one-sided.
FoldInSteps boolean_fold_in_steps(const Complex& complex, BooleanOp op, std::span<const Dominance> dominances,
                                  std::vector<PartedGroup> operands, bool totals, const LeafOrder& order = {},
                                  Removed removed = Removed::counted);

}  // namespace cnrg
