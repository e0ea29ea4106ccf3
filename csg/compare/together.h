// Two trees as one, so that all their leaves are refined together and surfaces that they have in common get common
// lines: then both results are selections on one complex and can be compared cell by cell.
//
// Names of materials of the two must not meet: those of B get a mark, which goes when they are compared. Names of
// nodes get another one, so that a region that is called after its node is told from one that somebody named.
#pragma once

#include <array>
#include <set>
#include <string>

#include "csg/tree/tree.h"

namespace cnrg {

/// What no name of two trees has in it.
struct UnusedMarks {
  UnusedMarks(const Tree& a, const Tree& b);
  std::string node, material;
};

/// Who gave names in the part of a tree that a node uses.
struct Given {
  Given() = default;
  Given(const Tree& tree, NodeId node);
  std::set<std::string> words;  ///< of names that the tree itself gives, by `name` and in groups
  bool reads_result = false;    ///< a leaf is a result that was read back
};

struct Together {
  Tree tree;                    ///< its result is the node of A
  std::array<NodeId, 2> nodes;  ///< of A and of B
};

/// The trees, whose nodes may have the mark in front of their names already, must have no `weld`.
Together together(const Tree& a, NodeId node_a, const Tree& b, NodeId node_b, const UnusedMarks& marks);

/// The tree with the mark in front of the names of its nodes, and of each word of them.
Tree marked(Tree tree, const UnusedMarks& marks);

/// A tree with one node, that leaf.
Tree tree_of_leaf(const std::string& file, const std::string& name, const std::string& key, Shape shape);

}  // namespace cnrg
