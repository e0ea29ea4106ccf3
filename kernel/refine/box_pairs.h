// Broad phase: all pairs of boxes that meet, by an implicit balanced tree of boxes on an integer grid.
//
// Coordinates are mapped to 31-bit integers by a map that never decreases: boxes that meet in doubles meet on the
// grid, so no pair is lost, whatever the rounding; a pair too many does no harm. Items in Morton order are packed
// in blocks of four; block b is leaf `leaves_ + b` of a heap. An item is compared with the four boxes of a block at
// once. Pairs are found by walking down two nodes at a time; the walk is cut into parts for threads.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "kernel/refine/morton.h"

namespace cnrg {

class BoxPairs {
 public:
  /// Builds over boxes; item i is `boxes[i]`.
  explicit BoxPairs(const std::vector<Box>& boxes);

  /// Work for threads: `find(part, visit)` for every part from 0 on.
  std::size_t part_count() const { return parts_.size(); }
  /// Calls `visit(i, j)` for the pairs of items of this part whose boxes may meet; over all parts, every pair whose
  /// closed boxes meet comes once.
  template <class Visit>
  void find(std::size_t part, const Visit& visit) const {
    std::vector<NodePair> stack{parts_[part]};
    while (!stack.empty()) {
      const auto [a, b] = stack.back();
      stack.pop_back();
      if (a >= leaves_) {
        if (a == b) pairs_within(a - leaves_, visit);
        else pairs_between(a - leaves_, b - leaves_, visit);
      } else {
        split({a, b}, stack);
      }
    }
  }
  /// Calls `visit(i)` for every item whose box may meet `box`, among them all whose closed boxes do.
  template <class Visit>
  void query(const Box& box, const Visit& visit) const {
    if (nodes_.empty()) return;
    const GridBox own = on_grid(box);
    std::array<std::uint32_t, 64> stack;
    std::size_t depth = 0;
    stack[depth++] = 1;
    while (depth > 0) {
      const std::uint32_t node = stack[--depth];
      if (!meet(nodes_[node], own)) continue;
      if (node < leaves_) {
        stack[depth++] = 2 * node + 1;
        stack[depth++] = 2 * node;
      } else {
        const std::uint32_t block = node - leaves_;
        visit_hits(hits(own, blocks_[block]), block, visit);
      }
    }
  }

 private:
  static constexpr std::uint32_t kBlock = 4;
  using Four = std::int32_t __attribute__((vector_size(16)));
  struct GridBox {
    std::array<std::int32_t, 3> lo, hi;
  };
  struct Block {
    std::array<Four, 3> lo, hi;
  };
  struct NodePair {
    std::uint32_t a, b;  // on one level; a == b: the pairs within
  };

  GridBox on_grid(const Box& box) const {
    GridBox g;
    for (std::size_t k = 0; k < 3; ++k) {
      g.lo[k] = grid_(box.lo[k], k);
      g.hi[k] = grid_(box.hi[k], k);
    }
    return g;
  }
  static bool meet(const GridBox& a, const GridBox& b) {
    return (a.lo[0] <= b.hi[0]) & (b.lo[0] <= a.hi[0]) & (a.lo[1] <= b.hi[1]) & (b.lo[1] <= a.hi[1]) &
           (a.lo[2] <= b.hi[2]) & (b.lo[2] <= a.hi[2]);
  }
  /// -1 in the places of the boxes of the block that meet `a`, 0 in the others.
  static Four hits(const GridBox& a, const Block& b) {
    return (b.lo[0] <= a.hi[0]) & (b.hi[0] >= a.lo[0]) & (b.lo[1] <= a.hi[1]) & (b.hi[1] >= a.lo[1]) &
           (b.lo[2] <= a.hi[2]) & (b.hi[2] >= a.lo[2]);
  }
  template <class Visit>
  void visit_hits(const Four& found, std::uint32_t block, const Visit& visit, std::uint32_t from = 0) const {
    const auto* halves = reinterpret_cast<const std::uint64_t*>(&found);
    if ((halves[0] | halves[1]) == 0) return;
    for (std::uint32_t i = from; i < kBlock; ++i) {
      if (found[i] != 0) visit(items_[block * kBlock + i]);
    }
  }
  GridBox item_box(std::uint32_t block, std::uint32_t i) const {
    const Block& b = blocks_[block];
    return {{b.lo[0][i], b.lo[1][i], b.lo[2][i]}, {b.hi[0][i], b.hi[1][i], b.hi[2][i]}};
  }
  std::uint32_t count(std::uint32_t block) const {
    return std::min<std::uint32_t>(kBlock, static_cast<std::uint32_t>(items_.size()) - block * kBlock);
  }
  template <class Visit>
  void pairs_within(std::uint32_t block, const Visit& visit) const {
    for (std::uint32_t i = 0; i + 1 < count(block); ++i) {
      visit_hits(hits(item_box(block, i), blocks_[block]), block,
                 [&](std::uint32_t j) { visit(items_[block * kBlock + i], j); }, i + 1);
    }
  }
  template <class Visit>
  void pairs_between(std::uint32_t a, std::uint32_t b, const Visit& visit) const {
    const GridBox& other = nodes_[leaves_ + b];
    for (std::uint32_t i = 0; i < count(a); ++i) {
      const GridBox own = item_box(a, i);
      if (!meet(own, other)) continue;
      visit_hits(hits(own, blocks_[b]), b, [&](std::uint32_t j) { visit(items_[a * kBlock + i], j); });
    }
  }
  /// The pairs of children that meet.
  void split(NodePair pair, std::vector<NodePair>& out) const {
    const std::uint32_t a = 2 * pair.a, b = 2 * pair.b;
    const auto add = [&](std::uint32_t x, std::uint32_t y) {
      if (meet(nodes_[x], nodes_[y])) out.push_back({x, y});
    };
    add(a, b);
    add(a, b + 1);
    if (a != b) add(a + 1, b);
    add(a + 1, b + 1);
  }

  Grid grid_;
  std::uint32_t leaves_ = 1;
  std::vector<std::uint32_t> items_;  // item numbers in tree order
  std::vector<Block> blocks_;
  std::vector<GridBox> nodes_;        // heap: node i has children 2i, 2i + 1; leaves_ + b is block b
  std::vector<NodePair> parts_;
};

}  // namespace cnrg
