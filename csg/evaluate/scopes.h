// A *scope* is what is refined together: instances of a tree below some roots, down to the leaves or to sections
// (sections.h), whose values are carried in. There is one for the results, one for each section, and one for
// each step of an intersection in steps.
//
// Scopes are evaluated from below: a section's complex is gone before the next scope is refined, all but what is
// carried on.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "csg/evaluate/drawings.h"
#include "csg/evaluate/evaluate.h"
#include "csg/evaluate/grades.h"
#include "csg/evaluate/operate.h"
#include "csg/evaluate/prepared_leaves.h"
#include "csg/evaluate/sections.h"
#include "csg/evaluate/simplified_value.h"
#include "csg/evaluate/value_store.h"
#include "csg/transfer/carried_groups.h"

namespace cnrg {

/// The tree as all scopes see it; what is referred to must outlive them.
struct ScopeContext {
  const Tree& tree;
  const Unfolding& unfolding;
  const PreparedLeaves& leaves;
  const PlacedLeaves& placed;
  const EvaluateOptions& options;
  Grades& grades;
};

/// What is said of an instance.
struct InstanceTold {
  std::optional<NodeRow> row;
  std::vector<Diagnostic> diagnostics;
};

/// What came of the instances below some roots.
struct ScopeResult {
  std::shared_ptr<const Complex> complex;
  std::optional<LeafPlaces> places;  ///< of `complex`, if values were carried into it
  RefineReport refine;               ///< sums over all scopes
  double refine_seconds = 0;
  ValueStore values;
  std::optional<SimplifiedValue> of_result;  ///< where it was made on the way
  IdVector<InstanceId, InstanceTold> told;   ///< with rows of those below the roots
  std::vector<Diagnostic> diagnostics;       ///< of the leaves' faces
};

/// Adds what is counted.
void add(RefineReport& sum, const RefineReport& more);

/// Evaluates the roots and all below them. `sections` may be empty. `top`: the roots are those of the run.
ScopeResult evaluate_scopes(const ScopeContext& context, std::span<const InstanceId> roots, Sections sections,
                            bool top = true);

}  // namespace cnrg
