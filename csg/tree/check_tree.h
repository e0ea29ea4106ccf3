// What can be said of a tree once all of its nodes are read. Throws TreeError.
#pragma once

#include "csg/tree/dag.h"
#include "csg/tree/tree.h"

namespace cnrg {

/// Nodes do not use each other in a cycle.
void check_graph(const Tree& tree, const Dag& dag);
/// What is asked for is below what it is picked from. There must be no cycle.
void check_selectors(const Tree& tree, const Dag& dag);
/// Nodes to which materials measure distances exist.
void check_distances(const Tree& tree);

}  // namespace cnrg
