// One list of (region of the result, operand, region of the operand), sorted: its groups are the sources of each
// region, the dominant operand first.
#include "csg/operators/attributes.h"

#include <algorithm>
#include <tuple>

#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

// The 3-cells of a region of the result where an operand has the material.
CellSet cells_of(const Group& result, std::uint32_t region, const std::vector<const Group*>& operands,
                 const RegionMaterial& material) {
  CellSet out;
  for (const auto& [cell, number] : result.cells) {
    if (number != region) continue;
    const RegionId c = cell;
    if (std::any_of(operands.begin(), operands.end(), [&](const Group* operand) {
          const std::uint32_t at = operand->region_of(c);
          return at != 0 && operand->regions[at - 1].material == material;
        })) {
      out.regions.push_back(cell);
    }
  }
  return out;
}

// The union of two ascending lists, in place.
void add_leaves(std::vector<LeafId>& leaves, const std::vector<LeafId>& more) {
  const auto middle = static_cast<std::ptrdiff_t>(leaves.size());
  leaves.insert(leaves.end(), more.begin(), more.end());
  std::inplace_merge(leaves.begin(), leaves.begin() + middle, leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
}

}  // namespace

RegionAttributes combined(std::span<const RegionAttributes* const> sources, bool strict,
                          std::vector<RegionMaterial>& others) {
  others.clear();
  RegionAttributes out = *sources.front();
  for (const RegionAttributes* source : sources.subspan(1)) {
    add_leaves(out.leaves, source->leaves);
    if (strict) continue;
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

std::vector<MaterialConflict> combine_attributes(Group& result, const std::vector<const Group*>& operands,
                                                 bool strict) {
  std::uint32_t count = 0;
  for (const auto& [cell, region] : result.cells) count = std::max(count, region);
  result.regions.assign(count, {});

  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> sources;
  for (std::uint32_t i = 0; i < operands.size(); ++i) {
    const auto& cells = operands[i]->cells;
    auto it = cells.begin();
    for (const auto& [cell, region] : result.cells) {
      while (it != cells.end() && it->first < cell) ++it;
      if (it != cells.end() && it->first == cell) sources.emplace_back(region, i, it->second);
    }
  }
  std::sort(sources.begin(), sources.end());
  sources.erase(std::unique(sources.begin(), sources.end()), sources.end());

  std::vector<MaterialConflict> conflicts;
  std::vector<const RegionAttributes*> of_region;
  std::vector<RegionMaterial> others;
  for (auto begin = sources.begin(); begin != sources.end();) {
    const std::uint32_t region = std::get<0>(*begin);
    const auto end = std::find_if(begin, sources.end(), [&](const auto& s) { return std::get<0>(s) != region; });
    of_region.clear();
    for (auto it = begin; it != end; ++it) {
      of_region.push_back(&operands[std::get<1>(*it)]->regions[std::get<2>(*it) - 1]);
    }
    RegionAttributes& attributes = result.regions[region - 1];
    attributes = combined(of_region, strict, others);
    for (const RegionMaterial& other : others) {
      conflicts.push_back({region, attributes.material, other, cells_of(result, region, operands, other)});
    }
    begin = end;
  }
  return conflicts;
}

}  // namespace cnrg
