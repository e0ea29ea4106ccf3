// An operand is read twice: first which pairs of an atom and a component of the operand there are, so that the new
// atoms can be numbered in their order; then each cell goes to its new atom. Atoms that lose their last cell stay
// in the list and are skipped in the end.
#include "csg/operators/atoms.h"

#include <algorithm>
#include <numeric>

#include "csg/operators/component_lists.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

constexpr std::uint32_t kNoAtom = 0xffffffffu;  // after all atoms

}  // namespace

int Atoms::Atom::dimension() const {
  int d = 3;
  while (d >= 0 && cells[static_cast<std::size_t>(d)] == 0) --d;
  return d;
}

bool Atoms::meet(const Components& x) const {
  bool known = false;
  const auto see = [&](const auto& list, const auto& cells) {
    known = known || std::any_of(list.begin(), list.end(),
                                 [&](const auto& entry) { return cells.place[entry.first] != 0; });
  };
  for_each_dimension(see, x.selection, cells_);
  return known;
}

void Atoms::add(const Components& x, std::optional<Dominance> dominance) {
  std::vector<Key> keys;
  const auto key_of = [](const auto& cells, const auto& entry) {
    const std::uint32_t place = cells.place.get(entry.first);
    return Key(place == 0 ? kNoAtom : cells.atoms[place - 1], entry.second);
  };
  const auto see = [&](const auto& cells, const auto& list) {
    for (const auto& entry : list) {
      const Key key = key_of(cells, entry);
      if (keys.empty() || keys.back() != key) keys.push_back(key);
    }
  };
  for_each_dimension(see, cells_, x.selection);
  sort_unique(keys);
  const std::size_t before = atoms_.size();
  std::vector<Conflict> conflicts = add_atoms(x, keys, dominance);

  LeafSetMap sets(x.origins.sets, sets_);
  std::size_t last = 0;
  const auto take_in = [&](auto& cells, const auto& list, const auto& origins) {
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Key key = key_of(cells, list[k]);
      const auto d = static_cast<std::size_t>(dimension_of(list[k].first));
      if (keys[last] != key) {
        last = static_cast<std::size_t>(std::lower_bound(keys.begin(), keys.end(), key) - keys.begin());
      }
      const auto atom = static_cast<std::uint32_t>(before + last);
      ++atoms_[atom].cells[d];
      std::uint32_t& place = cells.place[list[k].first];
      if (place == 0) {
        cells.ids.push_back(list[k].first);
        cells.atoms.push_back(atom);
        cells.origins.push_back(sets(origins[k]));
        place = static_cast<std::uint32_t>(cells.ids.size());
        continue;
      }
      --atoms_[cells.atoms[place - 1]].cells[d];
      cells.atoms[place - 1] = atom;
      LeafSetId& origin = cells.origins[place - 1];
      const LeafSetId more = sets(origins[k]);
      Conflict& at = conflicts[last];
      if (at.decides == Dominance::equal) at_odds_.see(list[k].first, sets_.said(origin), sets_.said(more));
      origin = sets_.unite(origin, more, at.decides);
      if (!at.yielded.empty()) list_for(at.cells, list[k].first).push_back(list[k].first);
    }
  };
  for_each_dimension(take_in, cells_, x.selection, x.origins);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Atom& atom = atoms_[before + i];
    if (atom.dimension() < conflicts[i].least) continue;
    for (const Yielded& other : conflicts[i].yielded) {
      conflicts_.push_back(conflict(atom.attributes, other, conflicts[i].cells));
    }
  }
  features_.edges.insert(features_.edges.end(), x.features.edges.begin(), x.features.edges.end());
  features_.vertices.insert(features_.vertices.end(), x.features.vertices.begin(), x.features.vertices.end());
}

// Two attributes meet where the common part is as large as one of the two: a wall where two solids touch is no
// conflict.
std::vector<Atoms::Conflict> Atoms::add_atoms(const Components& x, const std::vector<Key>& keys,
                                              std::optional<Dominance> dominance) {
  std::vector<Conflict> conflicts(keys.size());
  const std::vector<int> in_x = dimensions(x);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto& [atom, component] = keys[i];
    if (atom == kNoAtom) {
      atoms_.push_back({x.attributes[component - 1], {}});
      continue;
    }
    Combined c = combine(atoms_[atom].attributes, x.attributes[component - 1], dominance);
    conflicts[i].decides = dominant(atoms_[atom].attributes, x.attributes[component - 1], dominance);
    conflicts[i].yielded = std::move(c.yielded);
    conflicts[i].least = std::min(atoms_[atom].dimension(), in_x[component - 1]);
    atoms_.push_back({std::move(c.attributes), {}});
  }
  return conflicts;
}

ComponentsResult Atoms::result() {
  ComponentsResult out;
  Components& value = out.value;
  std::vector<Component> number(atoms_.size(), 0);
  for (std::size_t a = 0; a < atoms_.size(); ++a) {
    if (atoms_[a].dimension() < 0) continue;
    value.attributes.push_back(std::move(atoms_[a].attributes));
    number[a] = static_cast<Component>(value.attributes.size());
  }
  LeafSetMap sets(sets_, value.origins.sets);
  const auto write = [&](const auto& cells, auto& list, auto& origins) {
    std::vector<std::uint32_t> order(cells.ids.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return cells.ids[a] < cells.ids[b]; });
    list.reserve(order.size()), origins.reserve(order.size());
    for (const std::uint32_t i : order) {
      list.emplace_back(cells.ids[i], number[cells.atoms[i]]);
      origins.push_back(sets(cells.origins[i]));
    }
  };
  for_each_dimension(write, cells_, value.selection, value.origins);
  sort_unique(features_.edges), sort_unique(features_.vertices);
  value.features = active(value.selection, features_);
  collect_leaves(value);
  at_odds_.take_to(conflicts_);
  out.conflicts = std::move(conflicts_);
  return out;
}

}  // namespace cnrg
