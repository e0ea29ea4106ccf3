// Broad phase: an implicit balanced tree of boxes over items in Morton order.
//
// Items are sorted along a space-filling curve and packed into blocks; block i of a tree with n blocks is the
// leaf n + i of a heap, so the tree is one array of boxes and needs no pointers. Self pairs are found block by
// block against the blocks that follow, in parallel.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace cnrg {

struct Box {
  std::array<double, 3> lo{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::infinity()};
  std::array<double, 3> hi{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()};
  void extend(const Box& b) {
    for (int k = 0; k < 3; ++k) {
      lo[k] = b.lo[k] < lo[k] ? b.lo[k] : lo[k];
      hi[k] = b.hi[k] > hi[k] ? b.hi[k] : hi[k];
    }
  }
  void extend(const std::array<double, 3>& l, const std::array<double, 3>& h) {
    for (int k = 0; k < 3; ++k) {
      lo[k] = l[k] < lo[k] ? l[k] : lo[k];
      hi[k] = h[k] > hi[k] ? h[k] : hi[k];
    }
  }
  /// Closed boxes: a common boundary point counts.
  bool meets(const Box& b) const {
    return lo[0] <= b.hi[0] && b.lo[0] <= hi[0] && lo[1] <= b.hi[1] && b.lo[1] <= hi[1] && lo[2] <= b.hi[2] &&
           b.lo[2] <= hi[2];
  }
};

class BoxTree {
 public:
  static constexpr std::size_t kBlock = 4;

  /// Builds over boxes; item i is `boxes[i]`.
  explicit BoxTree(std::vector<Box> boxes);

  std::size_t item_count() const { return items_.size(); }
  std::size_t block_count() const { return blocks_; }

  /// Calls `visit(item)` for every item whose box satisfies `test(box)`; test must be monotone (true for a box
  /// if true for a box inside of it). `visit` may return false to stop.
  template <class Test, class Visit>
  void query(const Test& test, const Visit& visit) const {
    if (blocks_ == 0) return;
    std::array<std::uint32_t, 64> stack;
    std::size_t depth = 0;
    stack[depth++] = 1;
    while (depth > 0) {
      const std::uint32_t node = stack[--depth];
      if (!test(nodes_[node])) continue;
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

  /// Calls `visit(i, j)` for every pair of items whose boxes meet and that has its first item (in tree order)
  /// in block `block`. Over all blocks each pair comes once.
  template <class Visit>
  void self_pairs(std::size_t block, const Visit& visit) const {
    const std::size_t begin = block * kBlock, end = std::min(begin + kBlock, items_.size());
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t j = i + 1; j < end; ++j) {
        if (boxes_[i].meets(boxes_[j])) visit(items_[i], items_[j]);
      }
    }
    const Box& own = nodes_[leaves_ + block];
    std::array<std::uint32_t, 128> stack;
    std::size_t depth = 0;
    // Subtrees to the right of the block: siblings on the way to the root.
    for (std::size_t node = leaves_ + block; node > 1; node /= 2) {
      if ((node & 1) == 0) stack[depth++] = static_cast<std::uint32_t>(node + 1);
    }
    while (depth > 0) {
      const std::uint32_t node = stack[--depth];
      if (!nodes_[node].meets(own)) continue;
      if (node < leaves_) {
        stack[depth++] = 2 * node + 1;
        stack[depth++] = 2 * node;
        continue;
      }
      const std::size_t first = (node - leaves_) * kBlock, last = std::min(first + kBlock, items_.size());
      for (std::size_t j = first; j < last; ++j) {
        if (!boxes_[j].meets(own)) continue;
        for (std::size_t i = begin; i < end; ++i) {
          if (boxes_[i].meets(boxes_[j])) visit(items_[i], items_[j]);
        }
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
