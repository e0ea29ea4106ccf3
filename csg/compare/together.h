// Two trees as one, so that all their leaves are refined together and surfaces that they have in common get common
// lines: then both results are selections on one complex and can be compared cell by cell.
//
// Names of nodes and materials of the two must not meet. Nodes get a mark in front of their names: no two nodes of
// one tree can then be told apart from before, but a region that is called after a node can be told from one that
// somebody named. Materials of B have another mark, which goes when they are compared.
#pragma once

#include <array>
#include <set>
#include <string>

#include "csg/tree/tree.h"

namespace cnrg {

struct Together {
  Tree tree;                                   ///< its result is the node of A
  std::array<NodeId, 2> nodes;                 ///< of A and of B
  std::array<std::set<std::string>, 2> named;  ///< names that the trees themselves give, by `name` and in groups
  std::array<bool, 2> reads_result{};          ///< a leaf below the node is a result that was read back
  std::string node_mark, material_mark;
};

/// Throws TreeError for a tree with `weld`.
Together together(const Tree& a, NodeId node_a, const Tree& b, NodeId node_b);

/// A tree with one leaf: a mesh, a CAD model or a result, read from a file as the leaf of that kind would. Any
/// other file is read as a tree. Throws what `read_tree` throws.
Tree tree_of_file(const std::string& path, const ReadOptions& options);

}  // namespace cnrg
