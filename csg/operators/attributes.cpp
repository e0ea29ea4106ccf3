// The strongest source decides. Unless it dominates (`strict`), weaker sources fill in missing attributes, and
// their conflicting attributes are noted.
#include "csg/operators/attributes.h"

#include <algorithm>

#include "kernel/base/sorted.h"

namespace cnrg {
void add_leaves(std::vector<LeafId>& leaves, const std::vector<LeafId>& more) {
  const auto middle = static_cast<std::ptrdiff_t>(leaves.size());
  const bool after = leaves.empty() || more.empty() || leaves.back() < more.front();
  leaves.insert(leaves.end(), more.begin(), more.end());
  if (after) return;
  std::inplace_merge(leaves.begin(), leaves.begin() + middle, leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
}

AttributeConflict conflict(const Attributes& kept, const Yielded& other, CellSet cells) {
  const std::string stays = other.key.empty() ? kept.material.name() : to_text(kept.properties.at(other.key));
  return {other.key, stays, other.text(), std::move(cells)};
}

AtOdds::Found* AtOdds::find(const SaidPointer& left, const SaidPointer& right, int dimension) {
  const auto known = std::find_if(found_.rbegin(), found_.rend(), [&](const Found& f) {
    return f.left == left && f.right == right && f.dimension == dimension;
  });
  if (known != found_.rend()) return &*known;
  std::vector<Yielded> yielded = at_odds(left, right, dimension);
  if (yielded.empty()) return nullptr;
  found_.push_back({left, right, dimension, std::move(yielded), {}});
  return &found_.back();
}

void AtOdds::take_to(std::vector<AttributeConflict>& conflicts) {
  for (Found& found : found_) {
    sort_unique(found.cells.vertices), sort_unique(found.cells.edges), sort_unique(found.cells.faces);
    Attributes kept = found.left->attributes;
    std::vector<Yielded> all;
    fill_in(kept, found.right->attributes, all);
    for (const Yielded& other : found.yielded) conflicts.push_back(conflict(kept, other, found.cells));
  }
  found_.clear();
}

RegionAttributes combined(std::span<const RegionAttributes* const> sources, bool strict,
                          std::vector<Yielded>& yielded) {
  yielded.clear();
  RegionAttributes out{*sources.front(), {}};
  for (const RegionAttributes* source : sources.subspan(1)) {
    if (strict) break;
    if (out.name.empty()) out.name = source->name;
    fill_in(out, *source, yielded);
  }
  std::stable_sort(yielded.begin(), yielded.end(), [](const Yielded& a, const Yielded& b) {
    return std::pair(a.key, a.text()) < std::pair(b.key, b.text());
  });
  return out;
}

}  // namespace cnrg
