// An implicit balanced tree of boxes over items in Morton order, for queries by any test on boxes.
//
// Items are sorted along a space-filling curve and packed into blocks; block b is leaf `leaves_ + b` of a heap, so
// the tree is one array of boxes and needs no pointers. For all pairs of boxes that meet, see box_pairs.h.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/refine/box.h"

namespace cnrg {

class BoxTree {
 public:
  static constexpr std::size_t kBlock = 4;

  /// Builds over boxes; item i is `boxes[i]`.
  explicit BoxTree(std::vector<Box> boxes);

  /// Calls `visit(item)` for every item whose box satisfies `test(box)`; test must be monotone (true for a box
  /// if true for a box inside of it).
  template <class Test, class Visit>
  void query(const Test& test, const Visit& visit) const {
    if (blocks_ == 0) return;
    std::array<std::uint32_t, 64> stack;
    std::size_t depth = 0;
    stack[depth++] = 1;
    while (depth > 0) {
      const std::uint32_t node = stack[--depth];
      // Nodes without items are passed over here: few tests are made for the infinities of an empty box.
      if (!(nodes_[node].lo[0] <= nodes_[node].hi[0]) || !test(nodes_[node])) continue;
      if (node < leaves_) {
        stack[depth++] = 2 * node + 1;
        stack[depth++] = 2 * node;
        continue;
      }
      const std::size_t begin = (node - leaves_) * kBlock, end = std::min(begin + kBlock, items_.size());
      for (std::size_t i = begin; i < end; ++i) {
        if (test(boxes_[i])) visit(items_[i]);
      }
    }
  }

 private:
  std::size_t blocks_ = 0, leaves_ = 1;
  std::vector<std::uint32_t> items_;  // item numbers in tree order
  std::vector<Box> boxes_;            // their boxes, same order
  std::vector<Box> nodes_;            // heap: node i has children 2i, 2i + 1; leaves_ + b is block b
};

}  // namespace cnrg
