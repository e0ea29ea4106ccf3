// Broad phase: all pairs of boxes that meet, by an implicit balanced tree of boxes on an integer grid.
//
// Coordinates are mapped to 30-bit integers by a map that never decreases: boxes that meet in doubles meet on the
// grid, so no pair is lost, whatever the rounding; a pair too many does no harm. Items in Morton order are packed
// in blocks of four; block b is leaf `leaves_ + b` of a heap. An item is compared with the four boxes of a block
// at once. Pairs are found by walking down two nodes at a time; the walk is cut into parts for threads.
//
// Where boxes crowd, so that a point of a node lies in more than a few of them, they tell nothing: that is how
// long oblique items look. Such nodes and their items get boxes with axes of their own (oriented_box.h), and pairs
// that these part are left out.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "kernel/refine/morton.h"
#include "kernel/refine/oriented_box.h"

namespace cnrg {

class BoxPairs {
 public:
  /// An item as `orient` wants it.
  struct Outline {
    std::vector<Box> corners;  ///< boxes around points whose convex hull holds the item
    /// Items with a group in common need not be compared; kNoGroup: none.
    std::array<std::uint32_t, 3> groups{kNoGroup, kNoGroup, kNoGroup};
  };
  static constexpr std::uint32_t kNoGroup = 0xffffffffu;
  using Describe = std::function<void(std::uint32_t item, Outline& out)>;

  /// Builds over boxes; item i is `boxes[i]`.
  explicit BoxPairs(const std::vector<Box>& boxes);

  /// True if boxes crowd somewhere; then `orient` is worth its cost.
  bool crowded() const { return !crowded_.empty(); }
  /// Leaves out pairs that are certainly apart though their boxes meet, and pairs of a group, as far as that saves
  /// time. `boxes` as in the constructor; several threads call `describe`, for items whose boxes crowd.
  void orient(const std::vector<Box>& boxes, const Describe& describe);

  /// Work for threads: `find(part, visit)` for every part from 0 on.
  std::size_t part_count() const { return parts_.size(); }
  /// Items by their place in the tree, for data that is to lie in that order; more places than items at the end.
  std::size_t place_count() const { return items_.size(); }
  std::uint32_t item(std::uint32_t place) const { return items_[place]; }
  /// Calls `visit(x, y)` for the places of the pairs of items of this part whose boxes may meet; over all parts,
  /// every pair of items that meet comes once.
  template <class Visit>
  void find(std::size_t part, const Visit& visit) const {
    NodeStack stack;
    ItemPairs found;
    stack.push(parts_[part], true);
    while (stack.size > 0) {
      const NodePair pair = stack.entries[--stack.size];
      if (pair.a < leaves_) {
        split(pair, stack);
        continue;
      }
      if (pair.a == pair.b) pairs_within(pair.a - leaves_, found);
      else pairs_between(pair.a - leaves_, pair.b - leaves_, found);
      if (found.size + kBlock * kBlock > ItemPairs::kCapacity) flush(found, visit);
    }
    flush(found, visit);
  }
  /// Calls `visit(i)` for every item that may meet `box`, among them all that do.
  template <class Visit>
  void query(const Box& box, const Visit& visit) const {
    if (nodes_.empty()) return;
    const GridBox own = on_grid(box);
    const OrientedBox query = oriented() ? upright(box) : OrientedBox{};
    std::array<std::uint32_t, 64> stack;
    std::size_t depth = 0;
    stack[depth++] = 1;
    while (depth > 0) {
      const std::uint32_t node = stack[--depth];
      if (!meet(nodes_[node], own)) continue;
      if (oriented() && needless(node, query)) continue;
      if (node < leaves_) {
        stack[depth++] = 2 * node + 1;
        stack[depth++] = 2 * node;
      } else {
        const std::uint32_t block = node - leaves_;
        const Four found = hits(own, blocks_[block]);
        for (std::uint32_t i = 0; i < kBlock; ++i) {
          const std::uint32_t place = block * kBlock + i;
          if (found[i] == 0) continue;
          if (oriented() && needless(of_place(place), query)) continue;
          visit(items_[place]);
        }
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
  // What the walk has yet to do, and what it found. An entry is always written, and counted only if its boxes
  // meet: no processor predicts which do, and a branch predicted wrong costs more than the write.
  struct NodeStack {
    std::array<NodePair, 128> entries;  // a level leaves at most three of its four pairs of children behind
    std::uint32_t size = 0;
    void push(NodePair pair, bool counts) {
      entries[size] = pair;
      size += counts;
    }
  };
  struct ItemPairs {
    static constexpr std::uint32_t kCapacity = 256;
    std::array<std::array<std::uint32_t, 2>, kCapacity> entries;
    std::uint32_t size = 0;
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
  GridBox item_box(std::uint32_t block, std::uint32_t i) const {
    const Block& b = blocks_[block];
    return {{b.lo[0][i], b.lo[1][i], b.lo[2][i]}, {b.hi[0][i], b.hi[1][i], b.hi[2][i]}};
  }
  template <class Visit>
  void flush(ItemPairs& found, const Visit& visit) const {
    for (std::uint32_t i = 0; i < found.size; ++i) {
      const auto [x, y] = found.entries[i];
      if (!oriented() || !needless(of_place(x), of_place(y))) visit(x, y);
    }
    found.size = 0;
  }
  static void add(std::uint32_t place, const Four& hit, std::uint32_t block, std::uint32_t from, ItemPairs& out) {
    for (std::uint32_t j = from; j < kBlock; ++j) {
      out.entries[out.size] = {place, block * kBlock + j};
      out.size -= static_cast<std::uint32_t>(hit[j]);
    }
  }
  void pairs_within(std::uint32_t block, ItemPairs& out) const {
    for (std::uint32_t i = 0; i + 1 < kBlock; ++i) {
      add(block * kBlock + i, hits(item_box(block, i), blocks_[block]), block, i + 1, out);
    }
  }
  void pairs_between(std::uint32_t a, std::uint32_t b, ItemPairs& out) const {
    for (std::uint32_t i = 0; i < kBlock; ++i) {
      add(a * kBlock + i, hits(item_box(a, i), blocks_[b]), b, 0, out);
    }
  }
  /// The pairs of children that meet.
  void split(NodePair pair, NodeStack& out) const {
    const std::uint32_t a = 2 * pair.a, b = 2 * pair.b;
    const auto add = [&](std::uint32_t x, std::uint32_t y) {
      bool may_meet = meet(nodes_[x], nodes_[y]);
      if (oriented()) may_meet = may_meet && !needless(x, y);
      out.push({x, y}, may_meet);
    };
    add(a, b);
    add(a, b + 1);
    if (a != b) add(a + 1, b);
    add(a + 1, b + 1);
  }

  // Oriented boxes are of nodes and of items: an item at a place has the number after all nodes.
  struct Turned {
    OrientedBox box;
    std::array<std::uint32_t, 3> groups{kNoGroup, kNoGroup, kNoGroup};  // of all items in it
  };
  static constexpr std::uint32_t kUpright = 0xffffffffu;
  bool oriented() const { return !turned_.empty(); }
  std::uint32_t of_place(std::uint32_t place) const { return static_cast<std::uint32_t>(nodes_.size()) + place; }
  Turned turned(std::uint32_t x) const {
    return turned_[x] == kUpright ? Turned{upright(upright_[x])} : oriented_[turned_[x]];
  }
  /// True only if no item of x has to be compared with one of y.
  bool needless(std::uint32_t x, std::uint32_t y) const {
    if (turned_[x] == kUpright && turned_[y] == kUpright) return false;
    const Turned a = turned(x), b = turned(y);
    for (const std::uint32_t group : a.groups) {
      if (group != kNoGroup && std::find(b.groups.begin(), b.groups.end(), group) != b.groups.end()) return true;
    }
    return apart(a.box, b.box);
  }
  bool needless(std::uint32_t x, const OrientedBox& box) const {
    return turned_[x] != kUpright && apart(oriented_[turned_[x]].box, box);
  }
  bool is_empty(std::uint32_t node) const { return nodes_[node].hi[0] < 0; }
  void find_crowded(const std::vector<Box>& boxes);

  Grid grid_;
  std::uint32_t leaves_ = 1;
  std::vector<std::uint32_t> items_;  // item numbers in tree order; the last block is filled up with empty boxes
  std::vector<Block> blocks_;
  std::vector<GridBox> nodes_;  // heap: node i has children 2i, 2i + 1; leaves_ + b is block b
  std::vector<NodePair> parts_;
  std::vector<char> crowded_;  // by node; empty if none is
  // Empty until `orient`.
  std::vector<std::uint32_t> turned_;  // by node and item: its place in `oriented_`, or kUpright
  std::vector<Turned> oriented_;
  std::vector<Box> upright_;  // by node and item
};

}  // namespace cnrg
