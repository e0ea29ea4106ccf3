// The left operand of a fold ((a op b) op c) op ..., changed in place by one operand after the other.
//
// The tables decide about a cell by what lies around it: a step changes only entities of the new operand, entities
// inside of its regions, and 3-cells of these. So a step walks the new operand's cells alone. Group and lists are
// written down once, at the end; what comes out is what `apply` of groups gives step by step.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "csg/operators/boolean.h"

namespace cnrg {

/// What one step of a fold did.
struct FoldStep {
  std::vector<std::size_t> removed;  ///< entities by row of the tables; empty when nothing was
  /// Conflicts of materials with the smallest 3-cell of their region of the result, in that order; `region` is 0.
  std::vector<std::pair<RegionId, MaterialConflict>> conflicts;
};

class Accumulator {
 public:
  /// Starts as the group of the first operand's `parts`, which share no point with each other.
  Accumulator(const Complex& complex, std::span<const Group* const> parts);
  ~Accumulator();
  /// `op` with the next operand, given as its parts; what it did is added to `step`. All steps unite, or all
  /// subtract: the cost of an intersection is that of both operands anyway.
  void apply(BooleanOp op, Dominance dominance, std::span<const Group* const> parts, FoldStep& step);
  /// The group of what there is. Its dominance is not set.
  Group group();

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace cnrg
