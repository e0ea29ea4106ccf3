// The directed acyclic graph of a tree's nodes: who uses whom.
//
// An edge runs from a node to one of its operands; the edges of a node keep the order of its operands, and an
// operand that is used twice has two edges. The graph is Boost.Graph's; nobody else includes it.
#pragma once

#include <memory>
#include <vector>

#include "csg/tree/position.h"

namespace cnrg {

class Dag {
 public:
  Dag();
  ~Dag();
  Dag(Dag&&) noexcept;
  Dag& operator=(Dag&&) noexcept;

  NodeId add_node();
  /// `mention`: where the tree file names the operand.
  void add_operand(NodeId user, NodeId operand, Position mention);

  std::size_t size() const;
  /// The operands in the order in which they were added.
  std::vector<NodeId> operands(NodeId node) const;

  /// A way around: each node is an operand of the one before, the first an operand of the last.
  struct Cycle {
    std::vector<NodeId> nodes;  ///< empty: there is no cycle
    Position mention;           ///< where the last node names the first
  };
  /// The first cycle met from the nodes in ascending order. Iterative: depth costs memory, not stack.
  Cycle find_cycle() const;

  /// All nodes, operands before their users. There must be no cycle.
  std::vector<NodeId> order() const;

  /// For each node, whether it is one of the roots or below one.
  std::vector<char> reachable(const std::vector<NodeId>& roots) const;

 private:
  struct Graph;
  std::unique_ptr<Graph> graph_;
};

}  // namespace cnrg
