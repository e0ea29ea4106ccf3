// All lists are sorted by cell: a question about one component is one pass, a question about two is a merge.
#include "csg/operators/component_lists.h"

namespace cnrg {
namespace {

template <class IdT>
std::vector<IdT> active_ones(const std::vector<std::pair<IdT, Component>>& list,
                             const std::vector<IdT>& features) {
  std::vector<IdT> out;
  auto it = list.begin();
  for (const IdT id : features) {
    while (it != list.end() && it->first < id) ++it;
    if (it != list.end() && it->first == id) out.push_back(id);
  }
  return out;
}

// Calls f(cell, components of it) in the order of cells.
template <class IdT, class F>
void for_each_cell(const std::vector<std::pair<IdT, Component>>& list, F f) {
  std::vector<Component> components;
  for (std::size_t begin = 0; begin < list.size();) {
    components.clear();
    std::size_t end = begin;
    for (; end < list.size() && list[end].first == list[begin].first; ++end) {
      components.push_back(list[end].second);
    }
    f(list[begin].first, components);
    begin = end;
  }
}

}  // namespace

std::vector<int> dimensions(const Components& x) {
  std::vector<int> out(x.attributes.size(), -1);
  const auto see = [&](const auto& list) {
    for (const auto& [id, component] : list) out[component - 1] = dimension_of(id);
  };
  for_each_dimension(see, x.selection);
  return out;
}

std::vector<Component> components_in(const Selection& selection) {
  std::vector<Component> out;
  const auto see = [&](const auto& list) {
    for (const auto& [id, component] : list) out.push_back(component);
  };
  for_each_dimension(see, selection);
  sort_unique(out);
  return out;
}

Rational largest_dominance(const Components& x) {
  if (x.attributes.empty()) return 0;
  return std::max_element(x.attributes.begin(), x.attributes.end(),
                          [](const auto& a, const auto& b) { return a.dominance < b.dominance; })
      ->dominance;
}

std::vector<CellSet> supports(const Components& x) {
  std::vector<CellSet> out(x.attributes.size());
  const auto add = [&](const auto& list) {
    for (const auto& [id, c] : list) list_for(out[c - 1], id).push_back(id);
  };
  for_each_dimension(add, x.selection);
  return out;
}

Features unite(const Features& a, const Features& b) {
  return {in_either(a.edges, b.edges), in_either(a.vertices, b.vertices)};
}

Features among_entities(const Group& group, const Features& features) {
  return {in_common(features.edges, group.edges), in_common(features.vertices, group.vertices)};
}

Features active(const Selection& selection, const Features& features) {
  return {active_ones(selection.edges, features.edges), active_ones(selection.vertices, features.vertices)};
}

void Memberships::add(const CellSet& set, Component component) {
  const auto append = [&](const auto& cells, auto& list) {
    for (const auto cell : cells) list.emplace_back(cell, component);
  };
  for_each_dimension(append, set, cells_);
}

std::vector<std::vector<Component>> Memberships::atoms(Selection& selection) {
  std::map<std::vector<Component>, Component> numbers;
  const auto see = [&](auto, const std::vector<Component>& components) { numbers.emplace(components, 0); };
  const auto see_all = [&](auto& list) {
    std::sort(list.begin(), list.end());
    for_each_cell(list, see);
  };
  for_each_dimension(see_all, cells_);
  std::vector<std::vector<Component>> out;
  for (auto& [components, number] : numbers) {
    out.push_back(components);
    number = static_cast<Component>(out.size());
  }
  const auto assign = [&](const auto& from, auto& to) {
    for_each_cell(from, [&](auto cell, const std::vector<Component>& components) {
      to.emplace_back(cell, numbers.at(components));
    });
  };
  for_each_dimension(assign, cells_, selection);
  return out;
}

}  // namespace cnrg
