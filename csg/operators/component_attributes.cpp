// Names and materials are combined from operands, pair by pair. Leaves are not: they are those of the cells that a
// component has in the end.
#include "csg/operators/component_attributes.h"

#include <algorithm>

#include "csg/operators/component_lists.h"

namespace cnrg {
Dominance dominant(const ComponentAttributes& a, const ComponentAttributes& b,
                   std::optional<Dominance> dominance) {
  if (dominance) return *dominance;
  const bool tie = a.dominance == b.dominance;  // then materials decide
  const Rational& of_a = tie ? a.material.dominance() : a.dominance;
  const Rational& of_b = tie ? b.material.dominance() : b.dominance;
  return of_a == of_b ? Dominance::equal : of_a > of_b ? Dominance::left : Dominance::right;
}

Combined combine(const ComponentAttributes& a, const ComponentAttributes& b, std::optional<Dominance> dominance) {
  Combined out;
  const Dominance decides = dominant(a, b, dominance);
  out.attributes = decides == Dominance::right ? b : a;
  if (decides == Dominance::equal) {
    out.attributes.name = join_names(a.name, b.name);
    fill_in(out.attributes, b, out.yielded);
  }
  out.attributes.dominance = std::max(a.dominance, b.dominance);
  return out;
}

// Neighbouring cells mostly have one origin.
void collect_leaves(Components& x) {
  std::vector<std::pair<Component, LeafSetId>> seen;
  const auto see = [&](const auto& list, const auto& origins) {
    for (std::size_t k = 0; k < list.size(); ++k) {
      const std::pair entry(list[k].second, origins[k]);
      if (seen.empty() || seen.back() != entry) seen.push_back(entry);
    }
  };
  for_each_dimension(see, x.selection, x.origins);
  sort_unique(seen);
  for (ComponentAttributes& a : x.attributes) a.leaves.clear();
  for (const auto& [component, set] : seen) {
    std::vector<LeafId>& leaves = x.attributes[component - 1].leaves;
    leaves.insert(leaves.end(), x.origins.sets[set].begin(), x.origins.sets[set].end());
  }
  for (ComponentAttributes& a : x.attributes) sort_unique(a.leaves);
}

}  // namespace cnrg
