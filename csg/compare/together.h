// Two trees as one, so that all their leaves are refined together and surfaces that they have in common get common
// lines: then both results are selections on one complex and can be compared cell by cell.
//
// Names of materials of the two must not meet: those of B get a mark, which goes when they are compared.
#pragma once

#include <array>
#include <string>

#include "csg/tree/tree.h"

namespace cnrg {

/// What no name of a material of two trees has in it.
std::string unused_mark(const Tree& a, const Tree& b);

struct Together {
  Tree tree;                    ///< its result is the node of A
  std::array<NodeId, 2> nodes;  ///< of A and of B
};

/// The trees must have no `weld`.
Together together(const Tree& a, NodeId node_a, const Tree& b, NodeId node_b, const std::string& mark);

}  // namespace cnrg
