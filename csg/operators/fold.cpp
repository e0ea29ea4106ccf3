// The driver: clusters, the engine on each, the other parts as they are, and all of it put together.
#include "csg/operators/fold.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <iterator>

#include "csg/operators/clusters.h"
#include "csg/operators/table_engine.h"

namespace cnrg {
namespace {

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
