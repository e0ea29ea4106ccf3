// The driver: clusters, the engine on each, the other parts as they are, and all of it put together.
#include "csg/operators/fold.h"

#include <algorithm>
#include <chrono>
#include <compare>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "csg/operators/parts.h"
#include "csg/operators/table_engine.h"
#include "csg/operators/tables.h"
#include "kernel/base/union_find.h"

namespace cnrg {
namespace {

// Which parts of the operands may meet: connected sets of parts whose boxes do, without all pairs that meet. A
// thousand copies of one node, or a thousand boxes around one corner, have half a million pairs and are one set.
//
// A tree of boxes is asked about each part in turn, and each part found joins its set. A subtree that is of one
// set as a whole stays so, as sets only grow: it is passed over by all parts of that set. So the second copy of a
// node costs one look at the root.
//
// Where two sides are compared, the tree is made of the side that has fewer: in a chain of Booleans one small
// operand meets a value of many parts in each step, and most of these are passed over by one comparison with the
// box around the few.

/// Part `part` of operand `operand`.
struct PartPlace {
  std::uint32_t operand, part;
  friend auto operator<=>(const PartPlace&, const PartPlace&) = default;
};

using Cluster = std::vector<PartPlace>;  ///< ascending; two at least

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

/// The clusters of a fold in the order of their first parts. A part that meets none is in none. Parts of a union
/// hang together however they meet; those of an intersection or a difference by the first operand alone, as
/// nothing of the value is ever outside of it.
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

using Parts = std::vector<PartRef>;

// What the tally of a fold needs (tally.h).
bool can_tally(const Complex& complex, const std::vector<PartedGroup>& operands) {
  if (complex.frame.valid()) return false;
  return std::all_of(operands.begin(), operands.end(), [](const PartedGroup& operand) {
    return std::none_of(operand.parts.begin(), operand.parts.end(),
                        [](const PartRef& part) { return part->group().origins.sets.says_anything(); });
  });
}

class Fold {
 public:
  Fold(const Complex& complex, BooleanOp op, std::span<const Dominance> dominances,
       std::vector<PartedGroup> operands, const LeafOrder& order, Removed removed, bool tallies = false)
      : complex_(complex),
        op_(op),
        dominances_(dominances),
        operands_(std::move(operands)),
        order_(order),
        removed_(removed),
        tallies_(tallies),
        busy_(operands_.size()),
        steps_(dominances.size()) {}

  /// The value; what the steps did is in `steps` then.
  PartedGroup run() {
    PartedGroup out;
    const std::vector<Cluster> clusters = find_clusters(op_, operands_);
    Parts made;
    for (const Cluster& cluster : clusters) {
      const PartedGroup one = parted(complex_, evaluate(cluster));
      made.insert(made.end(), one.parts.begin(), one.parts.end());
    }
    take_out(clusters);
    for (std::uint32_t k = 0; k < operands_.size(); ++k) {
      const bool kept = stays(k);
      if (tallies_ && kept != (k == 0)) {
        for (const PartRef& part : operands_[k].parts) add(*part.get(), kept ? 1 : -1, steps_[step_of(k)]);
      }
      if (!kept) drop(k);
    }
    put_together(std::move(made), out);
    for (FoldStep& step : steps_) {
      // Stable: those of one region stay as they are.
      std::stable_sort(step.conflicts.begin(), step.conflicts.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
    }
    return out;
  }

  std::vector<FoldStep>& steps() { return steps_; }

 private:
  Group evaluate(const Cluster& cluster) {
    std::vector<const Group*> of_operand;
    auto next = cluster.begin();
    const auto take = [&](std::uint32_t operand) -> std::span<const Group* const> {
      of_operand.clear();
      for (; next != cluster.end() && next->operand == operand; ++next) {
        of_operand.push_back(&operands_[operand].parts[next->part]->group());
      }
      return of_operand;
    };
    std::uint32_t operand = next->operand;
    if (operand > 0) tally(cluster, operand);
    TableEngine engine(complex_, op_, take(operand), order_, removed_, tallies_);
    while (true) {
      // An intersection with an operand that has no part here leaves nothing.
      if (op_ == BooleanOp::intersect && !engine.empty()) ++operand;
      else operand = next == cluster.end() ? none() : next->operand;
      if (operand >= operands_.size()) return engine.group();
      const auto start = std::chrono::steady_clock::now();
      FoldStep& step = steps_[operand - 1];
      engine.step(dominances_[operand - 1], take(operand), step);
      step.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
  }

  // The first operand of a cluster that came after operand 0 is there from its own step on.
  void tally(const Cluster& cluster, std::uint32_t operand) {
    if (!tallies_) return;
    for (const PartPlace& place : cluster) {
      if (place.operand == operand) add(*operands_[operand].parts[place.part].get(), 1, steps_[operand - 1]);
    }
  }
  void add(const Part& part, int sign, FoldStep& step) const {
    Totals totals;
    totals.add(complex_, part);
    if (totals.unbounded > 0) step.tallied = false;
    for (std::size_t d = 0; d < 4; ++d) {
      step.change.raw[d] += sign * static_cast<std::int64_t>(totals.raw[d]);
      step.change.simplified[d] += sign * static_cast<std::int64_t>(totals.simplified[d]);
    }
    step.change.regions += sign * static_cast<std::int64_t>(totals.regions);
    step.change.volume += sign * totals.bounded_volume;
  }
  std::uint32_t none() const { return static_cast<std::uint32_t>(operands_.size()); }

  // Moves the parts that are in clusters from the operands to `busy_`.
  void take_out(const std::vector<Cluster>& clusters) {
    for (const Cluster& cluster : clusters) {
      for (const PartPlace& place : cluster) {
        busy_[place.operand].push_back(std::move(operands_[place.operand].parts[place.part]));
      }
    }
    for (std::size_t k = 0; k < operands_.size(); ++k) {
      if (busy_[k].empty()) continue;
      std::erase_if(operands_[k].parts, [](const PartRef& part) { return part.get() == nullptr; });
    }
  }

  // What the rows say of parts of an operand that meet no other: the first one stands left in the first step, the
  // others right in their own.
  std::size_t step_of(std::uint32_t operand) const { return operand == 0 ? 0 : operand - 1; }
  Relation outside(std::uint32_t operand) const {
    const bool is_a = (operand == 0) != roles(op_, dominances_[step_of(operand)]).swapped;
    return is_a ? Relation::a_out_b : Relation::b_out_a;
  }
  bool stays(std::uint32_t operand) const {
    return dominances_.empty() ||
           keeps_outside(op_, roles(op_, dominances_[step_of(operand)]).dominant, outside(operand));
  }

  void drop(std::uint32_t operand) {
    const std::size_t step = step_of(operand);
    const bool dominant = roles(op_, dominances_[step]).dominant;
    for (const PartRef& part : operands_[operand].parts) {
      if (removed_ == Removed::uncounted) break;
      const auto& cells = part->counts(complex_).simplified;
      for (int dimension = 0; dimension <= 2; ++dimension) {
        const std::size_t row = table_row(op_, dominant, dimension, outside(operand));
        if (const std::size_t n = cells[static_cast<std::size_t>(dimension)]) steps_[step].removed[row] += n;
      }
    }
    operands_[operand].parts.clear();
  }

  void put_together(Parts made, PartedGroup& out) {
    out.dominance = operands_[0].dominance;
    for (const PartedGroup& operand : operands_) {
      out.dominance = std::max(out.dominance, operand.dominance);
      out.ranked = out.ranked || operand.ranked;
    }
    // The longest list of parts stays where it is; the others are merged into it.
    const auto most = std::max_element(operands_.begin(), operands_.end(), [](const auto& a, const auto& b) {
      return a.parts.size() < b.parts.size();
    });
    Parts others;
    for (auto operand = operands_.begin(); operand != operands_.end(); ++operand) {
      if (operand == most) continue;
      std::move(operand->parts.begin(), operand->parts.end(), std::back_inserter(others));
    }
    const bool measured = std::all_of(operands_.begin(), operands_.end(), [](const PartedGroup& operand) {
      return operand.totals && operand.fresh.empty();
    });
    if (measured) out.totals = carried_totals(*most, others);
    std::sort(made.begin(), made.end(), before);
    out.fresh = made;
    std::move(made.begin(), made.end(), std::back_inserter(others));
    out.parts = std::move(most->parts);
    add(out.parts, std::move(others));
  }

  // The totals of all parts that are carried: those of the operand with the most, and `others`.
  Totals carried_totals(PartedGroup& most, const Parts& others) const {
    if (most.parts.empty()) return {};
    Totals out = std::move(*most.totals);
    for (const PartRef& part : busy_[static_cast<std::size_t>(&most - operands_.data())]) {
      out.remove(complex_, *part.get());
    }
    for (const PartRef& part : others) out.add(complex_, *part.get());
    return out;
  }

  // A few parts are put in one by one, many are sorted and merged.
  static void add(Parts& parts, Parts more) {
    if (more.size() < 8) {
      for (PartRef& part : more) {
        parts.insert(std::upper_bound(parts.begin(), parts.end(), part, before), std::move(part));
      }
      return;
    }
    std::sort(more.begin(), more.end(), before);
    const auto middle = static_cast<std::ptrdiff_t>(parts.size());
    parts.insert(parts.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    std::inplace_merge(parts.begin(), parts.begin() + middle, parts.end(), before);
  }

  const Complex& complex_;
  BooleanOp op_;
  std::span<const Dominance> dominances_;
  std::vector<PartedGroup> operands_;
  const LeafOrder& order_;
  Removed removed_;
  bool tallies_;
  std::vector<Parts> busy_;  // by operand: its parts in clusters
  std::vector<FoldStep> steps_;
};

}  // namespace

FoldResult boolean_fold(const Complex& complex, BooleanOp op, std::span<const Dominance> dominances,
                        std::vector<PartedGroup> operands, const LeafOrder& order, Removed removed) {
  Fold fold(complex, op, dominances, std::move(operands), order, removed);
  FoldResult out;
  out.group = fold.run();
  for (FoldStep& step : fold.steps()) {
    for (const auto& [row, count] : step.removed) out.removals.add(row, count);
    for (auto& [region, conflict] : step.conflicts) out.conflicts.push_back(std::move(conflict));
  }
  return out;
}

FoldInSteps boolean_fold_in_steps(const Complex& complex, BooleanOp op, std::span<const Dominance> dominances,
                                  std::vector<PartedGroup> operands, bool totals, const LeafOrder& order,
                                  Removed removed) {
  std::optional<Totals> sums;
  if (totals && can_tally(complex, operands)) sums = Totals();
  if (sums) {
    for (const PartRef& part : operands[0].parts) sums->add(complex, *part.get());
  }
  Fold fold(complex, op, dominances, std::move(operands), order, removed, sums.has_value());
  FoldInSteps out;
  out.group = fold.run();
  for (FoldStep& step : fold.steps()) {
    StepOfFold& told = out.steps.emplace_back();
    for (const auto& [row, count] : step.removed) told.removals.add(row, count);
    for (auto& [region, conflict] : step.conflicts) told.conflicts.push_back(std::move(conflict));
    told.seconds = step.seconds;
    if (sums && step.tallied) sums->add(step.change);
    else sums.reset();
    told.totals = sums;
  }
  if (sums) {
    out.group.totals = sums;
    out.group.fresh.clear();
  }
  return out;
}

}  // namespace cnrg
