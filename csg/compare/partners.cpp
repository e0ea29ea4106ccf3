// Families are connected parts of the graph between the components of A and those of B with an edge where two
// share a cell. A wall that only one value has makes one region of two: a family of two and one, which people
// understand. Where many meet many, one partner each is what tells the least differences, and the largest shares
// decide.
#include "csg/compare/partners.h"

#include <algorithm>

#include "csg/compare/pieces.h"
#include "kernel/base/union_find.h"
#include "kernel/complex/by_dimension.h"
#include "kernel/selection/measure.h"

namespace cnrg {
namespace {

/// How much two components share, larger in every case than what is less. Lengths and areas are rounded: where
/// they tie, they only decide which of two partners is told.
struct Weight {
  std::optional<Rational> volume;
  Rational area, length;
  std::size_t points;
};
Weight weight_of(const Complex& complex, const CellSet& cells) {
  Weight weight{volume(complex, cells.regions), 0, 0, cells.vertices.size()};
  for (const FaceId f : cells.faces) weight.area += square_root(squared_area(complex, f));
  for (const EdgeId e : cells.edges) weight.length += square_root(squared_length(complex, e));
  return weight;
}
bool heavier(const Weight& a, const Weight& b) {
  if (a.volume.has_value() != b.volume.has_value()) return !a.volume;
  if (a.volume != b.volume) return *a.volume > *b.volume;
  if (a.area != b.area) return a.area > b.area;
  if (a.length != b.length) return a.length > b.length;
  return a.points > b.points;
}

}  // namespace

Shared shared_cells(const Selection& a, const Selection& b) {
  Shared out;
  const auto share = [&](const auto& of_a, const auto& of_b) {
    auto it = of_b.begin();
    for (const auto& [cell, component] : of_a) {
      while (it != of_b.end() && it->first < cell) ++it;
      if (it == of_b.end()) return;
      if (it->first == cell) list_for(out[{component, it->second}], cell).push_back(cell);
    }
  };
  for_each_dimension(share, a, b);
  return out;
}

Partners partners(const Complex& complex, const Shared& shared, const std::array<Component, 2>& entities,
                  const std::array<std::size_t, 2>& count) {
  const auto is_entities = [&](Component a, Component b) { return a == entities[0] || b == entities[1]; };
  Partners out;
  if (entities[0] != 0 && entities[1] != 0) out.pairs.emplace(entities[0], entities[1]);
  UnionFind sets(count[0] + count[1]);
  for (const auto& [pair, cells] : shared) {
    if (!is_entities(pair.first, pair.second))
      sets.unite(pair.first - 1, static_cast<std::uint32_t>(count[0] + pair.second - 1));
  }
  std::map<std::uint32_t, std::array<std::vector<Component>, 2>> families;
  for (int side = 0; side < 2; ++side) {
    for (Component i = 1; i <= count[side]; ++i) {
      if (i == entities[side]) continue;  // of groups
      const auto place = static_cast<std::uint32_t>((side == 0 ? 0 : count[0]) + i - 1);
      families[sets.find(place)][side].push_back(i);
    }
  }
  for (const auto& [root, family] : families) {
    const auto& [of_a, of_b] = family;
    if (of_a.size() != 1 || of_b.size() != 1) out.families.push_back(family);
    const bool many = of_a.size() > 1 && of_b.size() > 1;
    std::vector<std::pair<Weight, std::pair<Component, Component>>> ranking;
    for (const Component a : of_a) {
      for (const Component b : of_b) {
        const auto it = shared.find({a, b});
        if (it == shared.end()) continue;
        if (many) ranking.emplace_back(weight_of(complex, it->second), it->first);
        else out.pairs.insert(it->first);
      }
    }
    // Ties go by the smaller number, then by the larger: the same whichever value comes first.
    std::sort(ranking.begin(), ranking.end(), [](const auto& x, const auto& y) {
      if (heavier(x.first, y.first)) return true;
      if (heavier(y.first, x.first)) return false;
      return std::minmax(x.second.first, x.second.second) < std::minmax(y.second.first, y.second.second);
    });
    std::set<Component> taken_a, taken_b;
    for (const auto& [weight, pair] : ranking) {
      if (taken_a.contains(pair.first) || taken_b.contains(pair.second)) continue;
      taken_a.insert(pair.first), taken_b.insert(pair.second);
      out.pairs.insert(pair);
    }
  }
  return out;
}

}  // namespace cnrg
