// Which of the leaves below a node comes first: depth first through the node's own subtree, operands in their
// order, each leaf where it comes for the first time. Numbers of leaves follow what else is in the tree.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "kernel/base/ids.h"

namespace cnrg {

/// Listed when it is first asked for; not to be asked by several threads at once.
class LeafOrder {
 public:
  using Listing = std::function<std::vector<LeafId>()>;
  /// That of the numbers.
  LeafOrder() = default;
  /// All leaves that will be asked for, in their order.
  explicit LeafOrder(Listing listing) : listing_(std::move(listing)) {}
  std::uint32_t place(LeafId leaf) const;
  /// Of some leaves their places, ascending.
  std::vector<std::uint32_t> places(const std::vector<LeafId>& leaves) const;
  /// Puts what is of leaves in their order.
  template <class List, class LeafOf>
  void sort(List& list, const LeafOf& leaf_of) const {
    std::stable_sort(list.begin(), list.end(),
                     [&](const auto& a, const auto& b) { return place(leaf_of(a)) < place(leaf_of(b)); });
  }

 private:
  Listing listing_;
  mutable IdVector<LeafId, std::uint32_t> place_;  // by leaf, once there was a question
};

}  // namespace cnrg
