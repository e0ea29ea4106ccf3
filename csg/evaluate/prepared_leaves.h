// The leaves of a tree, read and checked, and the way back from the geometry's faults to the tree file.
//
// Shapes and kernel know no tree file. What they throw is caught here and told with its place: that of the leaf,
// of the face of a group where the file lists it, or of the line of the mesh file that the fault is in.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "csg/carriers/near_surfaces.h"
#include "csg/evaluate/grades.h"
#include "csg/evaluate/leaf_numbers.h"
#include "csg/leaves/leaf.h"
#include "csg/operators/group.h"
#include "csg/tree/tree.h"
#include "csg/tree/unfold.h"
#include "kernel/base/leaf_words.h"

namespace cnrg {

/// The file that a shape reads; nullptr if it reads none.
const std::string* file_of(const Shape& shape);

/// The leaf instances of an unfolded tree, by LeafId as LeafNumbers has it; those below joined ones without
/// geometry. The tree must outlive this; the unfolding need not.
class PreparedLeaves {
 public:
  /// Prepares each leaf node below the unfolding once; those of `joined` are there. Throws TreeError or FileError
  /// with a position, Stopped where somebody stops it (csg/leaves/leaf_stop.h).
  PreparedLeaves(const Tree& tree, const Unfolding& unfolding, const JoinedLeaves& joined = {});
  /// Prepares every leaf node of the tree, used or not, without instances.
  explicit PreparedLeaves(const Tree& tree);

  const std::vector<LeafInstance>& instances() const { return instances_; }
  /// The leaf of an instance; none() for an inner node.
  LeafId leaf_of(InstanceId instance) const { return numbers_.of(instance); }
  /// As LeafNumbers has it.
  std::vector<LeafId> below(const Unfolding& unfolding, InstanceId instance,
                            std::span<const NodeId> nodes = {}) const {
    return numbers_.below(unfolding.instances, instance, nodes);
  }
  const Node& node_of(LeafId leaf) const { return tree_->nodes[numbers_.node_of(leaf)]; }
  const LeafNumbers& numbers() const { return numbers_; }

  /// What people say of the regions 1 to `count` of a leaf: the shape's own words, else those of the node,
  /// materials placed as `instance`, that of the leaf, is. What a node that joins says comes later, as of an
  /// operator.
  std::vector<Attributes> attributes(LeafId leaf, std::uint32_t count, const Instance& instance,
                                     Grades& grades) const;

  /// Runs `work`; an InputError that it throws comes out as TreeError, a LeafError with the place of the first
  /// leaf or face that it names, and with the names of nodes.
  void locate_errors(const std::function<void()>& work) const;
  /// With the names of nodes; `first` becomes the place of the first leaf or face.
  std::string in_words(const LeafWords& message, Position* first = nullptr) const;

  /// Surfaces that are nearly one, as notices: the first few, and how many there are.
  std::vector<Diagnostic> near_notices(const std::vector<NearSurfaces>& near) const;

  /// Messages about leaves, as notices.
  std::vector<Diagnostic> located_notices(const std::vector<LeafWords>& messages) const;

  /// What the shapes have to say, one diagnostic per notice.
  std::vector<Diagnostic> notices() const;

 private:
  void prepare_nodes(const std::vector<NodeId>& nodes);
  void prepare_node(NodeId id);
  const Tree* tree_;
  IdVector<NodeId, std::shared_ptr<const PreparedLeaf>> prepared_;
  std::vector<LeafInstance> instances_;
  LeafNumbers numbers_;
};

}  // namespace cnrg
