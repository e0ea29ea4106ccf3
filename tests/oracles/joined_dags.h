// Random dags with nodes whose near features are joined: `simplify: {of: node, within: d}`.
#pragma once

#include <string>

#include "tests/oracles/dag.h"

namespace cnrg::properties {

/// A random dag whose leaves have names, materials and attributes and are moved by some 1/10000 each, with up to
/// three nodes that join what is nearer than 1/1000.
RandomDag joined_dag(std::uint64_t seed);

/// What is wrong with it, empty if nothing is. Below, each joined node against its operand (moved_result.h);
/// above, the result against that of the tree in which the node is the file of what `join` makes of its operand.
std::string joined_failure(const RandomDag& dag);
/// How many of its nodes joined anything; 0 if the tree is refused.
std::size_t joined_nodes(const RandomDag& dag);

}  // namespace cnrg::properties
