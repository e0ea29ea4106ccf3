// Warnings and notices of an evaluation, each with its place in the tree file.
#pragma once

#include <iterator>
#include <utility>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "csg/evaluate/prepared_leaves.h"
#include "csg/evaluate/simplified_value.h"
#include "csg/operators/boolean.h"
#include "csg/tree/tree.h"
#include "kernel/complex/complex.h"

namespace cnrg {

inline void append(std::vector<Diagnostic>& all, std::vector<Diagnostic> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

/// Notices: per leaf, how many of its faces have no area and so are no part of the complex.
std::vector<Diagnostic> dropped_faces(const Tree& tree, const PreparedLeaves& leaves, const Complex& complex,
                                      const RefineReport& report);

/// Warnings: where materials met in a node's value and dominance did not decide, in cells as `cnrg locate` names
/// them where the node stands alone: `moved` by those above it. `simplified` is that of `value` on `complex` and
/// is asked only where there is a conflict.
std::vector<Diagnostic> material_conflicts(const Tree& tree, const Node& node, const NodeValue& value,
                                           const std::vector<AttributeConflict>& conflicts, const Complex& complex,
                                           const SimplifiedValue& simplified, const Transform& moved);

/// Notices: sheets, wires and points with a name of their own that no cell of a kept node has, since each of their
/// cells is part of another one with a name. Flattens the node's value if there are such leaves.
std::vector<Diagnostic> lost_names(const Tree& tree, const Evaluation& evaluation, NodeId node);

/// A warning, if the node is a `select` that has picked nothing.
std::vector<Diagnostic> empty_selection(const Tree& tree, NodeId node, const NodeValue& value);

}  // namespace cnrg
