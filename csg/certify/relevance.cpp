// From leaves up to a root, and down again; see the header.
#include "csg/certify/relevance.h"

#include <map>

namespace cnrg {

Relevance::Relevance(const Tree& tree, const Unfolding& unfolding, const IdVector<InstanceId, LeafId>& leaf_of,
                     std::vector<Root> roots)
    : roots_(std::move(roots)) {
  for (const Root& root : roots_) {
    std::vector<Step>& steps = steps_.emplace_back();
    std::map<InstanceId, std::uint32_t> places;
    bool cut = false;
    for (const InstanceId id : instances_below(unfolding.instances, root.first)) {
      const Instance& instance = unfolding.instances[id];
      Step& step = steps.emplace_back(Step{tree.nodes[instance.node].op, {}, leaf_of[id]});
      cut = cut || step.op == Operator::intersect || step.op == Operator::product ||
            step.op == Operator::subtract || step.op == Operator::cnrg_subtract;
      places.emplace(id, static_cast<std::uint32_t>(steps.size() - 1));
      if (step.leaf.valid()) continue;
      for (const InstanceId operand : instance.operands) step.operands.push_back(places.at(operand));
    }
    if (!cut) steps.clear();
  }
}

bool Relevance::together(LeafId a, LeafId b) const {
  return std::ranges::any_of(roots_,
                             [&](const Root& root) { return root.second[a.index()] && root.second[b.index()]; });
}

/// Of operands, in their order.
static Filling filled(Operator op, const std::vector<Filling>& of) {
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

bool Relevance::dies(std::span<const LeafId> leaves, const std::function<Filling(LeafId)>& of) const {
  for (std::size_t r = 0; r < roots_.size(); ++r) {
    if (std::ranges::any_of(leaves, [&](LeafId leaf) { return !roots_[r].second[leaf.index()]; })) continue;
    const std::vector<Step>& steps = steps_[r];
    std::vector<Filling> held, operands;
    std::vector<unsigned> below;  // which of the leaves, as bits
    for (const Step& step : steps) {
      operands.clear();
      unsigned bits = 0;
      for (std::size_t i = 0; i < leaves.size(); ++i) bits |= unsigned(step.leaf == leaves[i]) << i;
      for (const std::uint32_t i : step.operands) operands.push_back(held[i]), bits |= below[i];
      held.push_back(step.leaf.valid() ? of(step.leaf) : filled(step.op, operands));
      below.push_back(bits);
    }
    std::vector<char> matters(steps.size(), 0);
    std::vector<LeafId> dead(leaves.begin(), leaves.end());
    if (steps.empty()) dead.clear();
    else matters.back() = 1;
    for (std::size_t i = steps.size(); i-- > 0;) {
      if (!matters[i] || (held[i] == Filling::none && below[i] != below.back())) continue;
      for (const std::uint32_t operand : steps[i].operands) matters[operand] = 1;
      std::erase(dead, steps[i].leaf);
    }
    if (dead.empty()) return false;
  }
  return true;
}

}  // namespace cnrg
