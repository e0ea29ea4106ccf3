#include "csg/operators/fold.h"

#include <algorithm>
#include <cmath>

#include "csg/operators/accumulator.h"
#include "kernel/base/union_find.h"
#include "kernel/refine/box_pairs.h"

namespace cnrg {
namespace {

// A part and the operand that it is of.
struct Item {
  PartRef part;
  std::uint32_t operand;
};

bool finite(const PartBox& box) {
  return std::all_of(box.low.begin(), box.low.end(), [](float x) { return std::isfinite(x); }) &&
         std::all_of(box.high.begin(), box.high.end(), [](float x) { return std::isfinite(x); });
}

Box kernel_box(const PartBox& box) {
  Box out;
  out.extend({box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]});
  return out;
}

// Sets of items of which neighbours may meet, each in the order of operands. Those of a difference hang together
// by the first operand alone.
std::vector<std::vector<Item>> find_clusters(BooleanOp op, const std::vector<Item>& items) {
  UnionFind sets(items.size());
  std::vector<std::uint32_t> bounded, unbounded;
  std::vector<Box> boxes;
  const auto count = static_cast<std::uint32_t>(items.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    if (finite(items[i].part.box())) {
      bounded.push_back(i);
      boxes.push_back(kernel_box(items[i].part.box()));
    } else {
      unbounded.push_back(i);
    }
  }
  const auto meet = [&](std::uint32_t i, std::uint32_t j) {
    const std::uint32_t a = items[i].operand, b = items[j].operand;
    if (a != b && (op == BooleanOp::unite || a == 0 || b == 0)) sets.unite(i, j);
  };
  for (const std::uint32_t i : unbounded) {
    for (std::uint32_t j = 0; j < count; ++j) meet(i, j);
  }
  const BoxPairs pairs(boxes);
  for (std::size_t part = 0; part < pairs.part_count(); ++part) {
    pairs.find(part,
               [&](std::uint32_t x, std::uint32_t y) { meet(bounded[pairs.item(x)], bounded[pairs.item(y)]); });
  }
  std::vector<std::vector<Item>> clusters;
  std::vector<std::uint32_t> number(items.size(), 0);  // 1 + index
  for (std::uint32_t i = 0; i < count; ++i) {
    std::uint32_t& n = number[sets.find(i)];
    if (n == 0) {
      clusters.emplace_back();
      n = static_cast<std::uint32_t>(clusters.size());
    }
    clusters[n - 1].push_back(items[i]);
  }
  return clusters;
}

class Fold {
 public:
  Fold(const Complex& complex, BooleanOp op, std::span<const Dominance> dominances)
      : complex_(complex), op_(op), dominances_(dominances), steps_(dominances.size()) {}

  FoldResult run(std::vector<PartedGroup> operands) {
    FoldResult out;
    std::vector<Item> items;
    for (std::uint32_t k = 0; k < operands.size(); ++k) {
      out.group.dominance = k == 0 ? operands[k].dominance : std::max(out.group.dominance, operands[k].dominance);
      for (PartRef& part : operands[k].parts) items.push_back({std::move(part), k});
    }
    std::vector<PartRef>& parts = out.group.parts;
    for (const std::vector<Item>& cluster : find_clusters(op_, items)) {
      if (cluster.size() > 1) {
        const PartedGroup made = parted(complex_, accumulate(cluster));
        parts.insert(parts.end(), made.parts.begin(), made.parts.end());
      } else if (op_ == BooleanOp::unite || cluster[0].operand == 0) {
        parts.push_back(cluster[0].part);
      } else {
        drop(cluster[0]);
      }
    }
    std::sort(parts.begin(), parts.end(), before);
    sum_up(out);
    return out;
  }

 private:
  Group accumulate(const std::vector<Item>& cluster) {
    std::vector<const Group*> of_operand;
    std::size_t next = 0;
    const auto take = [&] {
      const std::uint32_t operand = cluster[next].operand;
      of_operand.clear();
      for (; next < cluster.size() && cluster[next].operand == operand; ++next) {
        of_operand.push_back(&cluster[next].part->group());
      }
      return operand;
    };
    take();
    Accumulator held(complex_, of_operand);
    while (next < cluster.size()) {
      const std::uint32_t operand = take();
      held.apply(op_, dominances_[operand - 1], of_operand, steps_[operand - 1]);
    }
    return held.group();
  }

  // What a difference takes away, off the first operand: the rows remove all of it.
  void drop(const Item& item) {
    std::vector<std::size_t>& removed = steps_[item.operand - 1].removed;
    if (removed.empty()) removed.resize(table_rows().size(), 0);
    const Group& g = item.part->group();
    const std::size_t sizes[] = {g.vertices.size(), g.edges.size(), g.faces.size()};
    for (int dimension = 0; dimension <= 2; ++dimension) {
      removed[table_row(op_, true, dimension, Relation::b_out_a)] += sizes[dimension];
    }
  }

  void sum_up(FoldResult& out) {
    std::vector<std::size_t> place(table_rows().size(), 0);  // 1 + index in `removals`
    for (FoldStep& step : steps_) {
      for (std::size_t row = 0; row < step.removed.size(); ++row) {
        if (step.removed[row] == 0) continue;
        if (place[row] == 0) {
          out.removals.emplace_back(table_rows()[row].id, 0);
          place[row] = out.removals.size();
        }
        out.removals[place[row] - 1].second += step.removed[row];
      }
      std::stable_sort(step.conflicts.begin(), step.conflicts.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
      for (auto& [region, conflict] : step.conflicts) out.conflicts.push_back(std::move(conflict));
    }
  }

  const Complex& complex_;
  BooleanOp op_;
  std::span<const Dominance> dominances_;
  std::vector<FoldStep> steps_;
};

}  // namespace

FoldResult fold(const Complex& complex, BooleanOp op, std::span<const Dominance> dominances,
                std::vector<PartedGroup> operands) {
  return Fold(complex, op, dominances).run(std::move(operands));
}

}  // namespace cnrg
