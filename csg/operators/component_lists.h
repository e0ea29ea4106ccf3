// Questions about the components of a value, and about its lists, one per dimension.
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include "csg/operators/components.h"
#include "kernel/base/sorted.h"
#include "kernel/complex/by_dimension.h"

namespace cnrg {

/// The place of a cell in a sorted list of (cell, component); its size when the cell is not there.
template <class IdT>
std::size_t place_in(const std::vector<std::pair<IdT, Component>>& list, IdT id) {
  const auto it = std::lower_bound(list.begin(), list.end(), id,
                                   [](const auto& entry, IdT wanted) { return entry.first < wanted; });
  return it != list.end() && it->first == id ? static_cast<std::size_t>(it - list.begin()) : list.size();
}

/// The component of a cell in such a list; 0 when it is not there.
template <class IdT>
Component component_in(const std::vector<std::pair<IdT, Component>>& list, IdT id) {
  const Component* const component = value_of_key(list, id);
  return component != nullptr ? *component : 0;
}

/// The largest dimension of the cells of each component, by component - 1; -1 for one without cells.
std::vector<int> dimensions(const Components& x);

/// The components that have cells, ascending.
std::vector<Component> components_in(const Selection& selection);

/// The largest dominance of its components; 0 when there is none.
Rational largest_dominance(const Components& x);

/// The cells of each component, by component - 1, in one pass.
std::vector<CellSet> supports(const Components& x);

/// The union of two sorted sets of features.
Features unite(const Features& a, const Features& b);
/// Those features that are entities of a group.
Features among_entities(const Group& group, const Features& features);
/// Those features that are active cells.
Features active(const Selection& selection, const Features& features);

/// Which cells belong to which of several sets, and the atoms that this makes of them.
class Memberships {
 public:
  /// The cells of `set` belong to `component`, beside those to which they belong already.
  void add(const CellSet& set, Component component);
  /// Numbers the distinct sets of components in their order (1, 2, ...), makes the selection of all cells by that
  /// number, and returns the sets.
  std::vector<std::vector<Component>> atoms(Selection& selection);

 private:
  Selection cells_;  // each with each of its components
};

}  // namespace cnrg
