// What dies is not asked (proof.h): where no value that somebody asked for depends on a leaf. A place that holds
// nothing of the first operand of a difference, or all of another one, holds nothing of the difference, whatever
// is below it there; so it is with intersections. Where all that meets in the place is below the difference it is
// asked: regions that are joined there are joined elsewhere, too.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "csg/tree/unfold.h"

namespace cnrg {

/// An instance of a tree: a leaf, or an operator of earlier ones.
struct TreeStep {
  Operator op = Operator::leaf;
  std::vector<InstanceId> operands;
  LeafId leaf;
};
/// Of all instances, in their order.
IdVector<InstanceId, TreeStep> tree_steps(const Tree& tree, const Unfolding& unfolding,
                                          const IdVector<InstanceId, LeafId>& leaf_of);

/// How much of an open place a leaf, or the value of a node, holds; a part, too, where nobody knows.
enum class Filling : std::uint8_t { none, part, all };

class Relevance {
 public:
  /// A node that was asked for.
  struct Root {
    std::vector<InstanceId> below;  ///< ascending, itself the last
    std::vector<char> asked;        ///< by leaf: below it, and asked about
    bool has(std::span<const LeafId> leaves) const;
  };
  Relevance(IdVector<InstanceId, TreeStep> steps, std::vector<Root> roots)
      : steps_(std::move(steps)), roots_(std::move(roots)) {}
  /// True if all of the leaves are below one root, and asked about.
  bool together(std::span<const LeafId> leaves) const;
  /// False if of these leaves none dies anywhere.
  bool may_die(std::span<const LeafId> leaves) const;
  /// True if the value of every root that has all of these leaves is the same without one of them in a place.
  /// `of`: how much of the place leaves hold.
  bool dies(std::span<const LeafId> leaves, const std::function<Filling(LeafId)>& of) const;

 private:
  /// Of each instance whether some of the leaves are below it, and others are not.
  IdVector<InstanceId, char> parts(const Root& root, std::span<const LeafId> leaves) const;
  IdVector<InstanceId, TreeStep> steps_;
  std::vector<Root> roots_;
};

}  // namespace cnrg
