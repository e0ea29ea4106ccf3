#include "csg/tree/sizes.h"

#include <algorithm>
#include <limits>

#include "csg/tree/unfold.h"

namespace cnrg {

bool says_sizes(const Tree& tree) {
  return std::any_of(tree.nodes.begin(), tree.nodes.end(), [](const Node& node) { return node.size.has_value(); });
}

std::vector<double> leaf_sizes(const Tree& tree, const IdVector<InstanceId, Instance>& instances, InstanceId root,
                               double above) {
  if (!says_sizes(tree)) return {};
  constexpr double kNothing = std::numeric_limits<double>::infinity();
  const std::vector<InstanceId> below = instances_below(instances, root);
  IdVector<InstanceId, double> heard(instances.size(), kNothing);
  if (above > 0) heard[root] = above;
  std::vector<double> sizes;
  for (auto it = below.rbegin(); it != below.rend(); ++it) {  // users before operands
    const Instance& instance = instances[*it];
    const Node& node = tree.nodes[instance.node];
    const double size = node.size ? to_double(*node.size) : heard[*it];
    if (instance.operands.empty()) sizes.push_back(size == kNothing ? 0 : size);
    for (const InstanceId operand : instance.operands) heard[operand] = std::min(heard[operand], size);
  }
  std::reverse(sizes.begin(), sizes.end());
  if (std::all_of(sizes.begin(), sizes.end(), [](double size) { return size == 0; })) sizes.clear();
  return sizes;
}

}  // namespace cnrg
