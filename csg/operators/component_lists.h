// Passes over the four lists of a value, one per dimension, and over the lists parallel to them.
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include "csg/operators/components.h"
#include "kernel/base/sorted.h"

namespace cnrg {

/// f(list, origins) for vertices, edges, faces and 3-cells.
template <class ComponentsT, class F>
void for_each_list(ComponentsT& x, F f) {
  f(x.selection.vertices, x.origins.vertices);
  f(x.selection.edges, x.origins.edges);
  f(x.selection.faces, x.origins.faces);
  f(x.selection.regions, x.origins.regions);
}

/// f(list of x, origins of x, list of y, origins of y).
template <class F>
void for_each_list(Components& x, const Components& y, F f) {
  f(x.selection.vertices, x.origins.vertices, y.selection.vertices, y.origins.vertices);
  f(x.selection.edges, x.origins.edges, y.selection.edges, y.origins.edges);
  f(x.selection.faces, x.origins.faces, y.selection.faces, y.origins.faces);
  f(x.selection.regions, x.origins.regions, y.selection.regions, y.origins.regions);
}

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
  const std::size_t k = place_in(list, id);
  return k == list.size() ? 0 : list[k].second;
}

/// The largest dimension of the cells of each component, by component - 1; -1 for one without cells.
std::vector<int> dimensions(const Components& x);

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
  template <class IdT>
  using List = std::vector<std::pair<IdT, Component>>;
  List<VertexId> vertices_;
  List<EdgeId> edges_;
  List<FaceId> faces_;
  List<RegionId> regions_;
};

}  // namespace cnrg
