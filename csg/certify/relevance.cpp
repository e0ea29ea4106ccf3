// From leaves up to a root, and down again; see the header.
#include "csg/certify/relevance.h"

#include <algorithm>

namespace cnrg {
namespace {

bool cuts(Operator op) {
  return op == Operator::intersect || op == Operator::product || op == Operator::subtract ||
         op == Operator::cnrg_subtract;
}

/// Of operands, in their order.
Filling filled(Operator op, const std::vector<Filling>& of) {
  const auto without = [](Filling filling) { return Filling(2 - int(filling)); };
  const Filling least = std::ranges::min(of), most = std::ranges::max(of);
  switch (op) {
    case Operator::intersect:
    case Operator::product: return least;
    case Operator::unite:
    case Operator::aggregate:
    case Operator::unify:
    case Operator::sum: return most;
    case Operator::complement: return without(most);
    case Operator::subtract:
    case Operator::cnrg_subtract:
      return of.size() == 1 ? most : std::min(of[0], without(*std::max_element(of.begin() + 1, of.end())));
    default: return std::min(most, Filling::part);  // they hold a part of that
  }
}

}  // namespace

IdVector<InstanceId, TreeStep> tree_steps(const Tree& tree, const Unfolding& unfolding,
                                          const IdVector<InstanceId, LeafId>& leaf_of) {
  IdVector<InstanceId, TreeStep> steps;
  for (const InstanceId id : IdRange<InstanceId>(unfolding.instances.size())) {
    const Instance& instance = unfolding.instances[id];
    steps.push_back({tree.nodes[instance.node].op, instance.operands, leaf_of[id]});
    if (leaf_of[id].valid()) steps[id].operands.clear();
  }
  return steps;
}

bool Relevance::Root::has(std::span<const LeafId> leaves) const {
  return std::ranges::all_of(leaves, [&](LeafId leaf) { return asked[leaf.index()] != 0; });
}

bool Relevance::together(std::span<const LeafId> leaves) const {
  return std::ranges::any_of(roots_, [&](const Root& root) { return root.has(leaves); });
}

IdVector<InstanceId, char> Relevance::parts(const Root& root, std::span<const LeafId> leaves) const {
  IdVector<InstanceId, unsigned> below(steps_.size());  // which of the leaves, as bits
  IdVector<InstanceId, char> result(steps_.size());
  for (const InstanceId id : root.below) {
    for (std::size_t i = 0; i < leaves.size(); ++i) below[id] |= unsigned(steps_[id].leaf == leaves[i]) << i;
    for (const InstanceId operand : steps_[id].operands) below[id] |= below[operand];
  }
  for (const InstanceId id : root.below) result[id] = below[id] != 0 && below[id] != below[root.below.back()];
  return result;
}

bool Relevance::may_die(std::span<const LeafId> leaves) const {
  return std::ranges::all_of(roots_, [&](const Root& root) {
    if (!root.has(leaves)) return true;
    const IdVector<InstanceId, char> parted = parts(root, leaves);
    return std::ranges::any_of(root.below, [&](InstanceId id) { return parted[id] && cuts(steps_[id].op); });
  });
}

bool Relevance::dies(std::span<const LeafId> leaves, const std::function<Filling(LeafId)>& of) const {
  return std::ranges::all_of(roots_, [&](const Root& root) {
    if (!root.has(leaves)) return true;
    const IdVector<InstanceId, char> parted = parts(root, leaves);
    IdVector<InstanceId, Filling> held(steps_.size());
    std::vector<Filling> operands;
    for (const InstanceId id : root.below) {
      operands.clear();
      for (const InstanceId operand : steps_[id].operands) operands.push_back(held[operand]);
      held[id] = steps_[id].leaf.valid() ? of(steps_[id].leaf) : filled(steps_[id].op, operands);
    }
    IdVector<InstanceId, char> matters(steps_.size());
    matters[root.below.back()] = 1;
    std::vector<LeafId> dead(leaves.begin(), leaves.end());
    for (auto it = root.below.rbegin(); it != root.below.rend(); ++it) {
      if (!matters[*it] || (held[*it] == Filling::none && parted[*it])) continue;
      for (const InstanceId operand : steps_[*it].operands) matters[operand] = 1;
      std::erase(dead, steps_[*it].leaf);
    }
    return !dead.empty();
  });
}

}  // namespace cnrg
