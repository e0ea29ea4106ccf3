// Clusters of what is near: from the nearest pair on, as long as all of one are within a distance of each other.
#pragma once

#include <algorithm>
#include <tuple>

#include "csg/weld/planes.h"
#include "kernel/base/union_find.h"

namespace cnrg::welding {

using Pair = std::array<Index, 2>;

/// The sets that different values, ascending, fall into, and near pairs that are in two.
template <class Pairs, class Apart>
UnionFind join(std::size_t count, const Pairs& near, const Rational& d, const Apart& apart,
               std::vector<Pair>& left) {
  std::vector<std::tuple<Rational, Index, Index>> links;
  for (const auto& [a, b] : near) {
    Rational by = apart(a, b);
    if (by <= d) links.emplace_back(std::move(by), a, b);
  }
  std::sort(links.begin(), links.end());
  UnionFind sets(count);
  std::vector<std::vector<Index>> members(count);
  for (Index i = 0; i < count; ++i) members[i] = {i};
  for (const auto& [by, a, b] : links) {
    std::vector<Index>&p = members[sets.find(a)], &q = members[sets.find(b)];
    if (&p == &q) continue;
    const bool fits = std::all_of(p.begin(), p.end(), [&](Index i) {
      return std::all_of(q.begin(), q.end(), [&](Index j) { return apart(i, j) <= d; });
    });
    if (!fits) continue;
    std::vector<Index> both = p;
    both.insert(both.end(), q.begin(), q.end());
    sets.unite(a, b);
    members[sets.find(a)] = std::move(both);
  }
  for (const auto& [by, a, b] : links) {
    if (sets.find(a) != sets.find(b)) left.push_back({a, b});
  }
  return sets;
}

}  // namespace cnrg::welding
