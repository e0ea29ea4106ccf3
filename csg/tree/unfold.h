// From the shared nodes of a tree to instances: a node under one accumulated transform.
//
// A transform moves everything below its node, so a node that two users place differently is two instances; where
// the accumulated matrices are equal, exactly, it stays one. Values are computed per instance. A `simplify` that
// joins is computed by itself, before: here it has nothing below it, as a leaf.
#pragma once

#include <span>
#include <vector>

#include "csg/tree/tree.h"

namespace cnrg {

struct Unfolding {
  IdVector<InstanceId, Instance> instances;  ///< operands before users
  std::vector<InstanceId> roots;             ///< one for each root that was asked for
  IdVector<NodeId, std::uint32_t> count;     ///< instances of each node
};

/// The longest number, in bits, that a product of two transforms or more may have: 30,000 digits, as of 2,000
/// rotations. One transform may have longer ones.
inline constexpr std::size_t kMostBits = 100'000;

/// The instances below `roots`, each root placed by its own transform alone. Iterative: depth costs memory, not
/// stack. Throws TreeError when there are more than `most`, mostly before any is made, and when a product of
/// transforms has numbers of more than kMostBits bits.
Unfolding unfold(const Tree& tree, const std::vector<NodeId>& roots, std::size_t most = 1'000'000);

/// What the users of an instance add to its node's own transform: from the coordinates in which the node stands to
/// those of the root. For instances that have a transform; the identity for others.
SharedTransform transform_above(const Tree& tree, const Instance& instance);

/// An instance and all below it, ascending: operands before users, itself the last.
std::vector<InstanceId> instances_below(const IdVector<InstanceId, Instance>& instances, InstanceId root);

/// The leaves below an instance, ascending, by their numbers `leaf_of`; its own if it is one. With `nodes` only
/// those that are at or below one of these nodes there.
std::vector<LeafId> leaves_below(const IdVector<InstanceId, Instance>& instances,
                                 const IdVector<InstanceId, LeafId>& leaf_of, InstanceId root,
                                 std::span<const NodeId> nodes = {});

}  // namespace cnrg
