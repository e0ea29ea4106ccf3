// What dies is not asked (proof.h): where no value that somebody asked for depends on a leaf. A place that holds
// nothing of the first operand of a difference, or all of another one, holds nothing of the difference, whatever
// is below it there; so it is with intersections. Where all that meets in the place is below the difference it is
// asked: regions that are joined there are joined elsewhere, too.
#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include "csg/tree/unfold.h"

namespace cnrg {

/// How much of an open place a leaf, or the value of a node, holds; a part, too, where nobody knows.
enum class Filling : std::uint8_t { none, part, all };

class Relevance {
 public:
  /// A node that was asked for, and by leaf: whether it is below, and asked about.
  using Root = std::pair<InstanceId, std::vector<char>>;
  Relevance(const Tree& tree, const Unfolding& unfolding, const IdVector<InstanceId, LeafId>& leaf_of,
            std::vector<Root> roots);
  /// True if both leaves are below one root, and asked about.
  bool together(LeafId a, LeafId b) const;
  /// True if something may die.
  bool cuts() const {
    return std::ranges::any_of(steps_, [](const auto& steps) { return !steps.empty(); });
  }
  /// True if the value of every root that has all of these leaves is the same without one of them in a place.
  /// `of`: how much of the place leaves hold.
  bool dies(std::span<const LeafId> leaves, const std::function<Filling(LeafId)>& of) const;

 private:
  struct Step {
    Operator op = Operator::leaf;
    std::vector<std::uint32_t> operands;  // places of earlier steps
    LeafId leaf;
  };
  std::vector<Root> roots_;
  std::vector<std::vector<Step>> steps_;  // by root, which is the last; none where nothing is cut
};

}  // namespace cnrg
