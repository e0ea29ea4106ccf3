// Problems of trees: a Boolean node on the point sets of its operands, which our kernel evaluates.
#pragma once

#include "bench/cases/family.h"
#include "csg/tree/tree.h"

namespace cnrg::bench {

/// The fold that a union, intersection or difference is. An inline operand is part of it: as the first one, a
/// Boolean is its beginning; behind, a union in a union or difference, and an intersection in an intersection, are
/// more operands. Every other operand is one model: a mesh as it is given, else the point set of its value, curved
/// leaves as `cnrg eval` of the node draws them. Faces have one loop. Throws InputError for a node that is none of
/// these, or says more than a point set, and as `evaluate` does.
Problem tree_problem(const Tree& tree, NodeId node);

/// Whether it is such a node.
bool is_tree_problem(const Tree& tree, NodeId node);

/// The point set of a node, drawn as below `among`, or with what is below that.
Model tree_model(const Tree& tree, NodeId node, NodeId among);

/// A node as an operand: a mesh as it is given, else the point set of its value. Throws as `tree_problem` does.
Model operand_model(const Tree& tree, NodeId node);

/// Throws as `tree_problem` does, but for faults of the geometry of leaves.
void check_tree_problem(const Tree& tree, NodeId node);

}  // namespace cnrg::bench
