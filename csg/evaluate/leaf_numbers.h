// Which leaf has which number in a run, and what leaves there were below a joined one.
//
// Leaves are numbered as their instances come: 0, 1, ... A joined node is a leaf of those who use it
// (joined_nodes.h), but its cells came from the leaves below it, and who asks where a cell came from wants these.
// So they have numbers here, too, the next ones after the joined leaf and in the order that they had in their own
// run: without geometry, since that is in the joined leaf, but with names and sizes. A leaf below two joined
// nodes, one below the other, is numbered in the run of either.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "csg/leaves/leaf.h"
#include "csg/operators/leaf_order.h"
#include "csg/result/result_view.h"
#include "csg/tree/unfold.h"

namespace cnrg {

struct JoinedLeaf;
/// Nodes whose values were joined, as leaves.
using JoinedLeaves = std::map<NodeId, JoinedLeaf>;
struct JoinedRun;

class LeafNumbers {
 public:
  LeafNumbers() = default;
  /// `joined`: all joined nodes among the instances.
  LeafNumbers(const IdVector<InstanceId, Instance>& instances, const JoinedLeaves& joined);

  std::size_t count() const { return nodes_.size(); }
  /// The leaf of an instance; none() for an inner node.
  LeafId of(InstanceId instance) const { return of_instance_[instance]; }
  const IdVector<InstanceId, LeafId>& by_instance() const { return of_instance_; }
  NodeId node_of(LeafId leaf) const { return nodes_[leaf]; }
  /// The leaves below an instance, ascending, its own if it is one, those below joined ones included. With `nodes`
  /// only those that are at or below one of these nodes there.
  std::vector<LeafId> below(const IdVector<InstanceId, Instance>& instances, InstanceId root,
                            std::span<const NodeId> nodes = {}) const;
  /// The same in the order of the subtree (csg/operators/leaf_order.h): each joined leaf, then those below it.
  std::vector<LeafId> in_order(const IdVector<InstanceId, Instance>& instances, InstanceId root) const;
  /// That order for an operator; both arguments must outlive it.
  LeafOrder order_below(const IdVector<InstanceId, Instance>& instances, InstanceId root) const;
  /// Of the leaves below an instance what `leaf_sizes` says (csg/tree/sizes.h), parallel to `below`; a joined leaf
  /// has no size, those below it have theirs. `above`: what is heard at the root from its users.
  std::vector<double> sizes(const Tree& tree, const IdVector<InstanceId, Instance>& instances, InstanceId root,
                            double above = 0) const;
  /// Of each joined leaf how many leaves were below it, and what its regions were made of.
  void tell(std::vector<LeafInfo>& leaves) const;

 private:
  void note_range(InstanceId id, std::span<const InstanceId> operands);

  IdVector<InstanceId, LeafId> of_instance_;
  IdVector<LeafId, NodeId> nodes_;
  std::map<LeafId, std::shared_ptr<const JoinedRun>> runs_;  // of joined leaves
  IdVector<InstanceId, LeafId> first_, last_;  // below each; without a first one where the order is not theirs
};

/// What is known of a run that evaluated the operand of a joined node.
struct JoinedRun {
  IdVector<InstanceId, Instance> instances;  ///< the last one is the operand
  LeafNumbers leaves;
  std::vector<LeafParts>
      regions;  ///< of the joined value, by label (LeafInfo::regions), with the numbers of the run
};

struct JoinedLeaf {
  std::shared_ptr<const PreparedLeaf> leaf;
  std::shared_ptr<const JoinedRun> run;
};

}  // namespace cnrg
