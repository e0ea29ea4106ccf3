// ((a op b) op c) op ... of many operands at the cost of what they touch.
//
// Operand by operand, `apply` reads the accumulated value again and again. Here boxes tell first which parts of
// all operands may meet; parts that meet none are carried over or dropped as a whole. Each cluster of the others
// is accumulated by itself: what a step does there depends on nothing outside.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "csg/operators/parts.h"

namespace cnrg {

struct FoldResult {
  PartedGroup group;
  /// Removed entities of all steps by row id: rows in the order of the steps that first removed something by them,
  /// rows of one step in table order.
  std::vector<std::pair<std::string, std::size_t>> removals;
  std::vector<MaterialConflict> conflicts;  ///< step by step; `region` is 0
};

/// `op` is unite or subtract; `dominances[k]` is that of the step that takes in operand k + 1. The value, removals
/// and conflicts are those of `apply` step by step.
FoldResult fold(const Complex& complex, BooleanOp op, std::span<const Dominance> dominances,
                std::vector<PartedGroup> operands);

}  // namespace cnrg
