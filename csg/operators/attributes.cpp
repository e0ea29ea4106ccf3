// The strongest source decides. Unless it dominates (`strict`), weaker ones fill in what it leaves empty, and
// their materials are noted where they differ.
#include "csg/operators/attributes.h"

#include <algorithm>

namespace cnrg {
void add_leaves(std::vector<LeafId>& leaves, const std::vector<LeafId>& more) {
  const auto middle = static_cast<std::ptrdiff_t>(leaves.size());
  const bool after = leaves.empty() || more.empty() || leaves.back() < more.front();
  leaves.insert(leaves.end(), more.begin(), more.end());
  if (after) return;
  std::inplace_merge(leaves.begin(), leaves.begin() + middle, leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
}

RegionAttributes combined(std::span<const RegionAttributes* const> sources, bool strict,
                          std::vector<RegionMaterial>& others) {
  others.clear();
  RegionAttributes out{sources.front()->name, sources.front()->material, {}};
  for (const RegionAttributes* source : sources.subspan(1)) {
    if (strict) break;
    if (out.name.empty()) out.name = source->name;
    if (out.material.empty()) {
      out.material = source->material;
    } else if (!source->material.empty() && source->material != out.material &&
               std::find(others.begin(), others.end(), source->material) == others.end()) {
      others.push_back(source->material);
    }
  }
  std::stable_sort(others.begin(), others.end(), [](const auto& a, const auto& b) { return a.name() < b.name(); });
  return out;
}

}  // namespace cnrg
