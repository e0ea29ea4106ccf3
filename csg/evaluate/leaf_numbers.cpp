#include "csg/evaluate/leaf_numbers.h"

#include <algorithm>
#include <utility>

#include "csg/tree/sizes.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

InstanceId root_of(const JoinedRun& run) { return InstanceId(run.instances.size() - 1); }

/// The number of a leaf of the run below a joined leaf.
LeafId number(LeafId joined, LeafId below) { return LeafId(joined.value() + 1 + below.value()); }

}  // namespace

LeafNumbers::LeafNumbers(const IdVector<InstanceId, Instance>& instances, const JoinedLeaves& joined)
    : of_instance_(instances.size()), first_(instances.size()), last_(instances.size()) {
  for (const InstanceId i : IdRange<InstanceId>(instances.size())) {
    if (!instances[i].operands.empty()) {
      note_range(i, instances[i].operands);
      continue;
    }
    of_instance_[i] = first_[i] = nodes_.push_back(instances[i].node);
    if (const auto found = joined.find(instances[i].node); found != joined.end()) {
      const LeafNumbers& below = found->second.run->leaves;
      runs_.emplace(of_instance_[i], found->second.run);
      for (const LeafId leaf : IdRange<LeafId>(below.count())) nodes_.push_back(below.node_of(leaf));
    }
    last_[i] = LeafId(nodes_.size() - 1);
  }
}

/// Numbers ascend where they do in each operand and from one to the next.
void LeafNumbers::note_range(InstanceId id, std::span<const InstanceId> operands) {
  first_[id] = first_[operands.front()];
  last_[id] = last_[operands.front()];
  for (const InstanceId operand : operands.subspan(1)) {
    if (!first_[operand].valid() || first_[operand] <= last_[id]) first_[id] = LeafId();
    last_[id] = std::max(last_[id], last_[operand]);
  }
}

std::vector<LeafId> LeafNumbers::below(const IdVector<InstanceId, Instance>& instances, InstanceId root,
                                       std::span<const NodeId> nodes) const {
  std::vector<LeafId> leaves = leaves_below(instances, of_instance_, root, nodes);
  if (runs_.empty()) return leaves;
  const std::vector<LeafId> all = nodes.empty() ? leaves : leaves_below(instances, of_instance_, root);
  std::vector<LeafId> more;
  for (const LeafId leaf : all) {
    const auto run = runs_.find(leaf);
    if (run == runs_.end()) continue;
    const bool whole = std::binary_search(leaves.begin(), leaves.end(), leaf);
    const auto wanted = whole ? std::span<const NodeId>() : nodes;
    for (const LeafId one : run->second->leaves.below(run->second->instances, root_of(*run->second), wanted))
      more.push_back(number(leaf, one));
  }
  leaves.insert(leaves.end(), more.begin(), more.end());
  sort_unique(leaves);
  return leaves;
}

std::vector<LeafId> LeafNumbers::in_order(const IdVector<InstanceId, Instance>& instances, InstanceId root) const {
  if (first_[root].valid()) return below(instances, root);
  std::vector<LeafId> order;
  std::vector<char> seen(root.index() + 1, 0);
  std::vector<InstanceId> stack{root};
  while (!stack.empty()) {
    const InstanceId id = stack.back();
    stack.pop_back();
    if (std::exchange(seen[id.index()], 1)) continue;
    const auto& operands = instances[id].operands;
    stack.insert(stack.end(), operands.rbegin(), operands.rend());
    if (!of_instance_[id].valid()) continue;
    for (LeafId leaf = of_instance_[id]; leaf.value() <= last_[id].value(); leaf = LeafId(leaf.value() + 1))
      order.push_back(leaf);
  }
  return order;
}

LeafOrder LeafNumbers::order_below(const IdVector<InstanceId, Instance>& instances, InstanceId root) const {
  if (first_[root].valid()) return {};
  return LeafOrder([this, &instances, root] { return in_order(instances, root); });
}

std::vector<double> LeafNumbers::sizes(const Tree& tree, const IdVector<InstanceId, Instance>& instances,
                                       InstanceId root, double above) const {
  std::vector<double> said = leaf_sizes(tree, instances, root, above), sizes;
  if (runs_.empty()) return said;
  const std::vector<LeafId> leaves = leaves_below(instances, of_instance_, root);
  said.resize(leaves.size(), 0);
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const auto run = runs_.find(leaves[i]);
    sizes.push_back(run == runs_.end() ? said[i] : 0);
    if (run == runs_.end()) continue;
    const JoinedRun& of = *run->second;
    std::vector<double> below = of.leaves.sizes(tree, of.instances, root_of(of), said[i]);
    below.resize(of.leaves.count(), 0);
    sizes.insert(sizes.end(), below.begin(), below.end());
  }
  if (std::all_of(sizes.begin(), sizes.end(), [](double size) { return size == 0; })) sizes.clear();
  return sizes;
}

void LeafNumbers::tell(std::vector<LeafInfo>& leaves) const {
  for (const auto& [leaf, run] : runs_) {
    LeafInfo& info = leaves[leaf.index()];
    info.makers = static_cast<std::uint32_t>(run->leaves.count());
    auto regions = std::make_shared<std::vector<LeafParts>>(run->regions);
    for (LeafParts& parts : *regions) {
      for (std::vector<LeafId>& part : parts) {
        for (LeafId& one : part) one = number(leaf, one);
      }
    }
    info.regions = std::move(regions);
  }
}

}  // namespace cnrg
