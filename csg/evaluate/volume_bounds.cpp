// From the cells of leaves to nodes; see the header.
#include "csg/evaluate/volume_bounds.h"

#include <algorithm>
#include <set>

#include "csg/leaves/geometry_leaf.h"

namespace cnrg {

SweptLeaves::SweptLeaves(const Tree& tree, const Unfolding& unfolding, const PreparedLeaves& leaves)
    : steps_(tree_steps(tree, unfolding, leaves.numbers().by_instance())) {
  for (const TreeStep& step : steps_) {
    curved_.push_back(step.leaf.valid() ? leaves.instances()[step.leaf.index()].leaf->curved()
                                        : std::ranges::any_of(step.operands, [&](InstanceId operand) {
                                            return curved_[operand.index()] != 0;
                                          }));
  }
}

const SweptLeaf& SweptLeaves::of(const LeafInstance& leaf) {
  const auto key = std::make_pair(leaf.leaf.get(), &*leaf.transform);
  const auto it = known_.find(key);
  if (it != known_.end()) return it->second.second;
  return known_.try_emplace(key, leaf, SweptLeaf(leaf)).first->second.second;
}

VolumeBounds::VolumeBounds(std::shared_ptr<SweptLeaves> shared, const PlacedLeaves& placed)
    : shared_(std::move(shared)) {
  for (std::size_t i = 0; i < placed.instances.size(); ++i) {
    if (placed.instances[i].leaf != no_geometry()) leaves_.emplace(LeafId(i), placed.instances[i]);
  }
}

std::optional<double> VolumeBounds::of(InstanceId id) const {
  if (!shared_->curved_[id.index()]) return 0;
  const std::lock_guard lock(shared_->mutex_);
  const auto [it, is_new] = told_.try_emplace(id);
  if (!is_new) return it->second;
  const std::vector<InstanceId> few = below(id);
  if (!few.empty()) return it->second = of_few(few);
  for (std::size_t i = 0; i < id.index(); ++i) of_any(InstanceId(i));
  return it->second = of_any(id);
}

const SweptLeaf& VolumeBounds::swept(InstanceId id) const {
  static const SweptLeaf none(LeafInstance{no_geometry(), {}});
  const auto leaf = leaves_.find(shared_->steps_[id].leaf);
  return leaf == leaves_.end() ? none : shared_->of(leaf->second);
}

std::vector<InstanceId> VolumeBounds::below(InstanceId id) const {
  constexpr std::size_t kFew = 2000;
  std::set<InstanceId> found{id};
  std::vector<InstanceId> waiting{id};
  while (!waiting.empty()) {
    const InstanceId next = waiting.back();
    waiting.pop_back();
    for (const InstanceId operand : operands(next)) {
      if (found.insert(operand).second) waiting.push_back(operand);
    }
    if (found.size() > kFew) return {};
  }
  return {found.begin(), found.end()};
}

/// Of one whose operands were asked for: the sum of theirs.
std::optional<double> VolumeBounds::of_any(InstanceId id) const {
  const auto [it, fresh] = known_.try_emplace(id, 0.0);
  if (!fresh || !shared_->curved_[id.index()]) return it->second;
  if (const std::vector<InstanceId> few = below(id); !few.empty()) return it->second = of_few(few);
  const enclosure::RoundOutward outward;
  Interval sum(0);
  for (const InstanceId operand : std::set<InstanceId>(operands(id).begin(), operands(id).end())) {
    const std::optional<double>& one = known_.at(operand);
    if (!one) return it->second = std::nullopt;
    sum += Interval(*one);
  }
  return it->second = sum.sup();
}

const Slabs& VolumeBounds::held(InstanceId id) const {
  const auto [it, fresh] = held_.try_emplace(id, Slabs::nothing());
  if (!fresh) return it->second;
  const auto& step = shared_->steps_[id];
  Slabs all = Slabs::nothing();
  if (step.leaf.valid()) {
    all = swept(id).slabs();
  } else if (step.op == Operator::complement) {
    all = Slabs::everything();
  } else {
    for (std::size_t i = 0; i < step.operands.size(); ++i) {
      const Slabs& operand = held(step.operands[i]);
      if (step.op == Operator::intersect && i > 0) all = all.common(operand);
      else if (step.op != Operator::subtract || i == 0) all = all.hull(operand);
    }
  }
  return it->second = all;
}

std::optional<double> VolumeBounds::of_few(const std::vector<InstanceId>& below) const {
  for (const InstanceId id : below) {
    if (!swept(id).known()) return std::nullopt;
    held(id);
  }
  std::map<InstanceId, Slabs> asked{{below.back(), Slabs::everything()}};
  const enclosure::RoundOutward outward;
  Interval sum(0);
  for (auto it = below.rbegin(); it != below.rend(); ++it) {
    const Slabs& within = asked.at(*it);
    sum += Interval(swept(*it).volume(within));
    const Operator op = shared_->steps_[*it].op;
    for (std::size_t i = 0; i < operands(*it).size(); ++i) {
      Slabs here = within;
      if (op == Operator::subtract && i > 0) here = here.common(held(operands(*it)[0]));
      for (std::size_t j = 0; op == Operator::intersect && j < operands(*it).size(); ++j) {
        if (j != i) here = here.common(held(operands(*it)[j]));
      }
      const auto [known, fresh] = asked.try_emplace(operands(*it)[i], here);
      if (!fresh) known->second = known->second.hull(here);
    }
  }
  return sum.sup();
}

}  // namespace cnrg
