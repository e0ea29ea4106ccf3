// Chains ((a op b) op c) op ... of Boolean nodes of which nobody sees the value but the node after.
//
// A model is often written one hole at a time, with a node for each. To make each node's value is to list all that
// there is n times, so the cost is the square of the chain's length. A chain is one fold, as a node with all of
// these operands would be; its rows say what each step did and what the value was after it
// (csg/operators/tally.h).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "csg/evaluate/operate.h"
#include "csg/tree/unfold.h"

namespace cnrg {

/// Whether the node may be one of a chain: a Boolean without `blend`. And whether another may follow it: nothing
/// changes the value of its operator afterwards, as attributes or `regularize` would.
bool can_be_in_chain(const Node& node);
bool can_be_followed(const Node& node);

/// One node of a chain, with its operands; of all but the first without the value so far.
struct ChainNode {
  const Node* node = nullptr;
  std::vector<Operand> operands;
};

/// What became of the value at one node.
struct ChainStep {
  Removals removals;
  std::optional<Totals> totals;
  double seconds = 0;
};

struct ChainOutcome {
  PartedGroup value;             ///< after the last node, before its attributes
  std::vector<ChainStep> nodes;  ///< of all; `totals` where these were asked for
};

/// Nothing if the nodes must be evaluated one by one: an operand is no group, materials or properties conflict,
/// what is equal is decided by materials, or `totals` cannot be told. Operands stay as they are. `order` is that
/// of the leaves below the last node, which is that below each node before it.
std::optional<ChainOutcome> evaluate_chain(const Complex& complex, std::span<const ChainNode> chain, bool totals,
                                           const LeafOrder& order, Removed removed);

}  // namespace cnrg
