// Connected sets of parts whose boxes meet, without all pairs that meet: a thousand copies of one node, or
// a thousand boxes around one corner, have half a million pairs and are one set.
//
// A tree of boxes is asked about each part in turn, and each part found joins its set. A subtree that is of one
// set as a whole stays so, as sets only grow: it is passed over by all parts of that set. So the second copy of a
// node costs one look at the root.
//
// Where two sides are compared, the tree is made of the side that has fewer: in a chain of Booleans one small
// operand meets a value of many parts in each step, and most of these are passed over by one comparison with the
// box around the few.
#include "csg/operators/clusters.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "kernel/base/union_find.h"

namespace cnrg {
namespace {

struct Item {
  PartBox box;
  PartPlace place;
};
using Items = std::vector<Item>;

PartBox hull(const PartBox& a, const PartBox& b) {
  PartBox out = a;
  for (std::size_t k = 0; k < 3; ++k) {
    out.low[k] = std::min(a.low[k], b.low[k]);
    out.high[k] = std::max(a.high[k], b.high[k]);
  }
  return out;
}

/// Sets of items. Two are joined if their boxes meet and they are not of one operand, whose parts share no point.
/// The first `in_tree` items are in the tree.
class Meetings {
 public:
  Meetings(const Items& items, std::size_t in_tree)
      : items_(items), sets_(items.size()), met_(items.size(), 0), order_(in_tree) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (in_tree > 0) build(0, static_cast<std::uint32_t>(in_tree), 0);
  }

  /// Joins an item with those in the tree.
  void join(std::uint32_t item) {
    if (!nodes_.empty()) join(item, 0);
  }

  std::uint32_t set_of(std::uint32_t item) { return sets_.find(item); }
  /// Whether it met any.
  bool met(std::uint32_t item) const { return met_[item] != 0; }

 private:
  static constexpr std::uint32_t kLeafSize = 4;
  struct TreeNode {
    PartBox box;
    std::uint32_t begin, end;  // of order_
    std::uint32_t right;       // the left child is the next node; 0: a leaf
    bool one_set;              // once true, it stays
    bool one_operand;
    std::uint32_t operand;  // of the first item
  };

  // Splits at the median of the middles along x, y, z in turn.
  std::uint32_t build(std::uint32_t begin, std::uint32_t end, std::size_t axis) {
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    const Item& first = items_[order_[begin]];
    TreeNode node{first.box, begin, end, 0, end - begin == 1, true, first.place.operand};
    for (std::uint32_t i = begin + 1; i < end; ++i) {
      const Item& item = items_[order_[i]];
      node.box = hull(node.box, item.box);
      node.one_operand = node.one_operand && item.place.operand == node.operand;
    }
    nodes_.push_back(node);
    if (end - begin <= kLeafSize) return number;
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto place = [&](std::uint32_t i) {
      constexpr float kMost = std::numeric_limits<float>::max() / 2;  // so that infinite boxes have a middle
      return std::max(items_[i].box.low[axis], -kMost) + std::min(items_[i].box.high[axis], kMost);
    };
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
    build(begin, middle, (axis + 1) % 3);
    const std::uint32_t right = build(middle, end, (axis + 1) % 3);
    nodes_[number].right = right;
    return number;
  }

  void join(std::uint32_t item, std::uint32_t number) {
    TreeNode& node = nodes_[number];
    const Item& own = items_[item];
    if (!node.box.meets(own.box)) return;
    if (node.one_operand && node.operand == own.place.operand) return;
    if (node.one_set && sets_.find(order_[node.begin]) == sets_.find(item)) return;
    if (node.right == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        const std::uint32_t other = order_[i];
        if (items_[other].place.operand == own.place.operand || !items_[other].box.meets(own.box)) continue;
        sets_.unite(item, other);
        met_[item] = met_[other] = 1;
      }
    } else {
      join(item, number + 1);
      join(item, node.right);
    }
    node.one_set = node.one_set || is_one_set(node, number + 1);
  }

  bool is_one_set(const TreeNode& node, std::uint32_t left) {
    const std::uint32_t set = sets_.find(order_[node.begin]);
    if (node.right != 0) {
      const TreeNode& right = nodes_[node.right];
      return nodes_[left].one_set && right.one_set && sets_.find(order_[right.begin]) == set;
    }
    return std::all_of(order_.begin() + node.begin, order_.begin() + node.end,
                       [&](std::uint32_t i) { return sets_.find(i) == set; });
  }

  const Items& items_;
  UnionFind sets_;
  std::vector<char> met_;
  std::vector<std::uint32_t> order_;
  std::vector<TreeNode> nodes_;
};

void add_parts(const PartedGroup& operand, std::uint32_t number, Items& items) {
  for (std::uint32_t i = 0; i < operand.parts.size(); ++i) items.push_back({operand.parts[i].box(), {number, i}});
}

/// The clusters of items of which the first `in_tree` are asked for by the others, or all by all.
std::vector<Cluster> clusters_of(const Items& items, std::size_t in_tree) {
  Meetings meetings(items, in_tree);
  const auto asking = static_cast<std::uint32_t>(in_tree == items.size() ? 0 : in_tree);
  for (std::uint32_t i = asking; i < items.size(); ++i) meetings.join(i);
  std::vector<std::uint32_t> met;
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    if (meetings.met(i)) met.push_back(i);
  }
  std::sort(met.begin(), met.end(),
            [&](std::uint32_t a, std::uint32_t b) { return items[a].place < items[b].place; });
  std::vector<Cluster> clusters;
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> cluster_of(items.size(), kNone);
  for (const std::uint32_t i : met) {
    std::size_t& cluster = cluster_of[meetings.set_of(i)];
    if (cluster == kNone) {
      cluster = clusters.size();
      clusters.emplace_back();
    }
    clusters[cluster].push_back(items[i].place);
  }
  return clusters;
}

/// Between `few`, the parts of one side, and those of `operands`, whose numbers begin with `first`.
std::vector<Cluster> across(Items few, std::span<const PartedGroup> operands, std::uint32_t first) {
  if (few.empty()) return {};
  const std::size_t in_tree = few.size();
  PartBox all = few[0].box;
  for (const Item& item : few) all = hull(all, item.box);
  for (std::uint32_t k = 0; k < operands.size(); ++k) {
    const std::vector<PartRef>& many = operands[k].parts;
    for (std::uint32_t i = 0; i < many.size(); ++i) {
      if (many[i].box().meets(all)) few.push_back({many[i].box(), {first + k, i}});
    }
  }
  if (few.size() == in_tree) return {};
  return clusters_of(few, in_tree);
}

}  // namespace

std::vector<Cluster> find_clusters(BooleanOp op, std::span<const PartedGroup> operands) {
  Items items;
  if (op == BooleanOp::unite && operands.size() > 2) {
    for (std::uint32_t k = 0; k < operands.size(); ++k) add_parts(operands[k], k, items);
    return clusters_of(items, items.size());
  }
  const auto first = operands.first(1), others = operands.subspan(1);
  std::size_t count = 0;
  for (const PartedGroup& operand : others) count += operand.parts.size();
  if (first[0].parts.size() < count) {
    add_parts(first[0], 0, items);
    return across(std::move(items), others, 1);
  }
  for (std::uint32_t k = 0; k < others.size(); ++k) add_parts(others[k], k + 1, items);
  return across(std::move(items), first, 0);
}

}  // namespace cnrg
