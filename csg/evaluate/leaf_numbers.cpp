#include "csg/evaluate/leaf_numbers.h"

#include <algorithm>

#include "csg/tree/sizes.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

InstanceId root_of(const JoinedRun& run) { return InstanceId(run.instances.size() - 1); }

/// The number of a leaf of the run below a joined leaf.
LeafId number(LeafId joined, LeafId below) { return LeafId(joined.value() + 1 + below.value()); }

}  // namespace

LeafNumbers::LeafNumbers(const IdVector<InstanceId, Instance>& instances, const JoinedLeaves& joined)
    : of_instance_(instances.size()) {
  for (const InstanceId i : IdRange<InstanceId>(instances.size())) {
    if (!instances[i].operands.empty()) continue;
    of_instance_[i] = nodes_.push_back(instances[i].node);
    const auto found = joined.find(instances[i].node);
    if (found == joined.end()) continue;
    const LeafNumbers& below = found->second.run->leaves;
    runs_.emplace(of_instance_[i], found->second.run);
    for (const LeafId leaf : IdRange<LeafId>(below.count())) nodes_.push_back(below.node_of(leaf));
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
