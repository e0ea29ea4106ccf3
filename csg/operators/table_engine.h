// The engine of the paper's tables: a fold ((a op b) op c) op ... of groups, in place. A Boolean of two groups is
// a fold of two.
//
// table_engine.cpp is where a row of tables.h is decided, for all who ask: `boolean_operation` (boolean.h) and
// `boolean_fold` (fold.h). The head of that file says how.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "csg/operators/attributes.h"
#include "csg/operators/leaf_order.h"
#include "csg/operators/parts.h"
#include "csg/operators/tables.h"

namespace cnrg {

/// What one step of a fold did, in one engine or in several.
struct FoldStep {
  std::map<std::size_t, std::size_t> removed;  ///< row of the tables -> cells
  /// Each with the smallest 3-cell of its region of the step's result, in that order; those of entities, which
  /// have none, are the last.
  std::vector<std::pair<RegionId, AttributeConflict>> conflicts;
  TotalsChange change;  ///< of an engine that tallies: what the step does to the sums over the value is added
  bool tallied = true;  ///< false: it is not known
  double seconds = 0;   ///< for whoever takes the time
};

class TableEngine {
 public:
  /// Starts as the group of the first operand's `parts`, which share no point with each other. `tallies`: each
  /// step says what it changes in the sums over the value (tally.h); nothing may be said of any cell. `order` is
  /// that of the leaves below the node.
  TableEngine(const Complex& complex, BooleanOp op, std::span<const Group* const> parts, const LeafOrder& order,
              Removed removed = Removed::counted, bool tallies = false);
  ~TableEngine();
  /// One step with the next operand, given as its parts, which may be none; what it did is added to `step`.
  void step(Dominance dominance, std::span<const Group* const> parts, FoldStep& step);
  /// True if nothing is left.
  bool empty() const;
  /// The group of what there is. Its dominance is not set.
  Group group();

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace cnrg
