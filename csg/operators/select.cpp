// Each cell of the simplified value is asked by the cells that it unites; what is around these is read off the
// complex. What is picked of a group is marked with its closure (subgroup.h), and one pass over the lists of the
// group takes what is marked.
#include "csg/operators/select.h"

#include <algorithm>

#include "csg/operators/below.h"
#include "csg/operators/cell_sources.h"
#include "csg/operators/component_lists.h"
#include "csg/operators/sides.h"
#include "csg/operators/subgroup.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

template <class T>
bool one_of(const std::vector<T>& wanted, const T& value) {
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), value) != wanted.end();
}

template <class IdT>
bool has(const CellSet& set, IdT cell) {
  return std::ranges::binary_search(list_for(set, cell), cell);
}

// What the two kinds of values call the component of a 3-cell, and what is said of one.
Component component_at(const Group& group, RegionId r) { return group.region_of(r); }
Component component_at(const Components& x, RegionId r) { return component_in(x.selection.regions, r); }
const RegionAttributes& attributes(const Group& group, Component i) { return group.regions[i - 1]; }
const RegionAttributes& attributes(const Components& x, Component i) { return x.attributes[i - 1]; }

template <class Value>
class Picker {
 public:
  Picker(const Complex& complex, const Value& value, const Criteria& criteria)
      : complex_(complex), value_(value), criteria_(criteria) {
    // The cells whose closure meets the set.
    if (criteria.touching) touching_ = star(complex, *criteria.touching);
    if (!criteria.sides.empty()) sides_ = touched_sides(complex, value);
  }

  /// A cell that came from `origin` and of which `said` is said, if anything; its component, or 0 for an entity of
  /// a group.
  template <class IdT>
  bool picks(IdT cell, const Attributes* said, LeafSetId origin, Component own) const {
    return one_of(criteria_.dimensions, dimension_of(cell)) && says(said) &&
           comes_from(cell, value_.origins.sets[origin]) && is_among_regions(cell, own);
  }
  template <class IdT>
  bool is_inside(IdT cell) const {
    return !criteria_.inside || has(*criteria_.inside, cell);
  }
  template <class IdT>
  bool touches(IdT cell) const {
    return !criteria_.touching || has(touching_, cell);
  }

  /// A region of a group, with its 3-cells.
  bool picks_region(Component region, std::span<const RegionId> cells) const {
    const RegionAttributes& said = attributes(value_, region);
    return one_of(criteria_.dimensions, 3) && criteria_.between.empty() && criteria_.source_faces.empty() &&
           says(&said) && is_wanted(region) && from(said.leaves) &&
           std::all_of(cells.begin(), cells.end(), [&](RegionId r) { return is_inside(r); }) &&
           std::any_of(cells.begin(), cells.end(), [&](RegionId r) { return touches(r); });
  }

 private:
  bool says(const Attributes* said) const {
    if (criteria_.names.empty() && criteria_.materials.empty() && criteria_.properties.empty()) return true;
    if (said == nullptr) return false;
    const auto says_it = [&](const std::pair<std::string, Property>& wanted) {
      const auto it = said->properties.find(wanted.first);
      return it != said->properties.end() && it->second == wanted.second;
    };
    // Values of one key are alternatives; every key must hold.
    const auto key_holds = [&](const std::pair<std::string, Property>& wanted) {
      return std::any_of(criteria_.properties.begin(), criteria_.properties.end(),
                         [&](const auto& other) { return other.first == wanted.first && says_it(other); });
    };
    return one_of(criteria_.names, said->name.text()) && one_of(criteria_.materials, said->material.name()) &&
           std::all_of(criteria_.properties.begin(), criteria_.properties.end(), key_holds);
  }

  template <class Leaves>
  bool from(const Leaves& leaves) const {
    return criteria_.leaves.empty() || std::any_of(leaves.begin(), leaves.end(), [&](LeafId leaf) {
             return std::binary_search(criteria_.leaves.begin(), criteria_.leaves.end(), leaf);
           });
  }
  template <class IdT>
  bool comes_from(IdT cell, std::span<const LeafId> leaves) const {
    if (criteria_.source_faces.empty()) return from(leaves);
    const std::vector<LeafCell> cells = leaf_cells(complex_, cell, in_common(leaves, criteria_.leaves));
    return std::any_of(cells.begin(), cells.end(), [&](const LeafCell& of) {
      return of.dimension == 2 && one_of(criteria_.source_faces, of.number);
    });
  }

  template <class IdT>
  bool is_among_regions(IdT cell, Component own) const {
    const bool any_region = is_any_region();
    if (any_region && criteria_.between.empty()) return true;
    const std::vector<Component> around = components_around(cell);
    const auto wanted = [&](Component component) { return is_wanted(component); };
    return (any_region || is_wanted(own) || std::any_of(around.begin(), around.end(), wanted)) &&
           is_between(around);
  }
  bool is_any_region() const {
    return criteria_.regions.empty() && criteria_.region_numbers.empty() && criteria_.sides.empty();
  }
  /// By name or number, and by where it is; 0 is no region.
  bool is_wanted(Component component) const {
    if (is_any_region()) return true;
    if (component == 0) return false;
    const auto is = [&](const auto& list, const auto& value) {
      return std::find(list.begin(), list.end(), value) != list.end();
    };
    const bool called = (criteria_.regions.empty() && criteria_.region_numbers.empty()) ||
                        is(criteria_.region_numbers, component) ||
                        is(criteria_.regions, attributes(value_, component).name.text());
    return called && std::all_of(criteria_.sides.begin(), criteria_.sides.end(), [&](const Criteria::Side& side) {
             return component <= sides_.size() && lies_on(sides_[component - 1], side.surfaces, side.front);
           });
  }

  /// Those that the 3-cells around a cell are of, ascending and unique; 0 is none.
  template <class IdT>
  std::vector<Component> components_around(IdT cell) const {
    std::vector<RegionId> cells;
    if constexpr (std::is_same_v<IdT, RegionId>) cells = {cell};
    else complex_.star_regions(cell, cells);
    std::vector<Component> components;
    components.reserve(cells.size());
    for (const RegionId r : cells) components.push_back(component_at(value_, r));
    sort_unique(components);
    return components;
  }

  bool is(Component component, const SideName& side) const {
    if (component == 0 || !side) return component == 0 && !side;
    const RegionAttributes& said = attributes(value_, component);
    return said.name == *side || said.material.name() == *side;
  }
  bool is_between(const std::vector<Component>& around) const {
    if (criteria_.between.empty()) return true;
    for (const auto& [first, second] : criteria_.between) {
      for (const Component a : around) {
        for (const Component b : around) {
          if (a != b && is(a, first) && is(b, second)) return true;
        }
      }
    }
    return false;
  }

  const Complex& complex_;
  const Value& value_;
  const Criteria& criteria_;
  CellSet touching_;
  TouchedSides sides_;
};

/// Which cells of the simplified value are picked: the criteria hold for one of the cells that it unites, all of
/// them are inside, one of them touches.
class PickedPlaces {
 public:
  explicit PickedPlaces(const SimplifiedComplex& simplified) : simplified_(simplified) {
    const std::array<std::size_t, 4> counts{simplified.vertices.size(), simplified.edges.size(),
                                            simplified.faces.size(), simplified.regions.size()};
    for (std::size_t d = 0; d < 4; ++d) states_[d].resize(counts[d]);
  }

  /// A cell of the value; `picked`: the criteria hold for it.
  template <class IdT>
  void see(IdT cell, bool picked, bool inside, bool touches) {
    State* const state = at(cell);
    if (state == nullptr) return;
    state->asked |= picked && place(cell).dimension == dimension_of(cell);
    state->outside |= !inside;
    state->touches |= touches;
  }
  template <class IdT>
  bool has(IdT cell) {
    const State* const state = at(cell);
    return state != nullptr && state->asked && !state->outside && state->touches;
  }

 private:
  struct State {
    bool asked = false, outside = false, touches = false;
  };
  const SimplifiedComplex::Place& place(VertexId v) const { return simplified_.vertex_place[v.index()]; }
  const SimplifiedComplex::Place& place(EdgeId e) const { return simplified_.edge_place[e.index()]; }
  const SimplifiedComplex::Place& place(FaceId f) const { return simplified_.face_place[f.index()]; }
  const SimplifiedComplex::Place& place(RegionId r) const { return simplified_.region_place[r.index()]; }
  template <class IdT>
  State* at(IdT cell) {
    const SimplifiedComplex::Place& p = place(cell);
    if (p.index == SimplifiedComplex::kNowhere) return nullptr;
    return &states_[static_cast<std::size_t>(p.dimension)][p.index];
  }

  const SimplifiedComplex& simplified_;
  std::array<std::vector<State>, 4> states_;
};

}  // namespace

namespace {

template <class Value, class Named>
bool by_drawn_numbers(const Complex& complex, const Value& value, const std::vector<Named>& named,
                      const std::vector<std::pair<RegionId, Component>>& cells, const Criteria& criteria) {
  const auto by_name = [&](const Named& region) {
    const std::string& name = region.name.text();
    const auto wanted = [&](const auto& names) { return std::ranges::find(names, name) != names.end(); };
    return std::ranges::any_of(region.name.parts(), [](const NamePart& part) { return part.ordinal != 0; }) &&
           (wanted(criteria.names) || wanted(criteria.regions) || std::ranges::any_of(criteria.between, wanted));
  };
  if (!(criteria.region_numbers.empty() ? std::ranges::any_of(named, by_name) : named.size() > 1)) return false;
  return std::ranges::any_of(cells, [&](const auto& cell) {
    return std::ranges::any_of(complex.region_faces[cell.first], [&](HalfFace h) {
      return component_at(value, complex.region(h.opposite())) != cell.second && is_curved(complex, h.face());
    });
  });
}

}  // namespace

bool picks_by_drawn_numbers(const Complex& complex, const Group& group, const Criteria& criteria) {
  return by_drawn_numbers(complex, group, group.regions, group.cells, criteria);
}
bool picks_by_drawn_numbers(const Complex& complex, const Components& components, const Criteria& criteria) {
  return by_drawn_numbers(complex, components, components.attributes, components.selection.regions, criteria);
}

Group select(const Complex& complex, const Group& group, const Criteria& criteria) {
  const Picker picker(complex, group, criteria);
  const GroupSources sources(complex, group);
  const SimplifiedComplex simplified =
      simplify(complex, selection_of(complex, group), group.features, SimplifyMode::features, &sources);
  PickedPlaces picked(simplified);
  const auto ask = [&](const auto& cells, const auto& origins) {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const auto cell = cells[k];
      picked.see(cell, picker.picks(cell, sources.said(cell), origins[k], 0), picker.is_inside(cell),
                 picker.touches(cell));
    }
  };
  for_each_entity(ask, group, group.origins);
  WantedEntities wanted(complex);
  const auto want = [&](const auto& cells) {
    for (const auto cell : cells) {
      if (picked.has(cell)) wanted.add(cell);
    }
  };
  for_each_entity(want, group);

  std::vector<std::vector<RegionId>> cells_of(group.regions.size());
  for (const auto& [cell, region] : group.cells) cells_of[region - 1].push_back(cell);
  std::vector<Component> number(group.regions.size() + 1, 0);  // in the selection; 0: not picked
  std::vector<RegionAttributes> regions;
  for (Component region = 1; region <= group.regions.size(); ++region) {
    if (!picker.picks_region(region, cells_of[region - 1])) continue;
    regions.push_back(group.regions[region - 1]);
    number[region] = static_cast<Component>(regions.size());
    for (const RegionId cell : cells_of[region - 1]) {
      for_each_bounding(complex, cell, [&](auto of) { wanted.add(of); });
    }
  }

  Group out = wanted.of(group);
  for (const auto& [cell, region] : group.cells) {
    if (number[region] != 0) out.cells.emplace_back(cell, number[region]);
  }
  out.regions = std::move(regions);
  return out;
}

Components select(const Complex& complex, const Components& components, const Criteria& criteria) {
  const Picker picker(complex, components, criteria);
  const ComponentSources sources(complex, components);
  const auto said = [&](const auto& cell, Component component) -> const Attributes* {
    if constexpr (!std::is_same_v<std::decay_t<decltype(cell)>, RegionId>) {
      if (const Attributes* const own = sources.said(cell)) return own;
    }
    return &components.attributes[component - 1];
  };
  const SimplifiedComplex simplified =
      simplify(complex, components.selection, components.features, SimplifyMode::features, &sources);
  PickedPlaces picked(simplified);
  const auto ask = [&](const auto& cells, const auto& origins) {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const auto& [cell, component] = cells[k];
      picked.see(cell, picker.picks(cell, said(cell, component), origins[k], component), picker.is_inside(cell),
                 picker.touches(cell));
    }
  };
  for_each_dimension(ask, components.selection, components.origins);
  Components out;
  LeafSetMap map(components.origins.sets, out.origins.sets);
  std::vector<Component> number(components.attributes.size() + 1, 0);
  const auto pick = [&](auto& to, auto& to_origins, const auto& cells, const auto& origins) {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const auto& [cell, component] = cells[k];
      if (!picked.has(cell)) continue;
      to.push_back(cells[k]);
      to_origins.push_back(map(origins[k]));
      number[component] = 1;
    }
  };
  for_each_dimension(pick, out.selection, out.origins, components.selection, components.origins);
  for (Component i = 1; i < number.size(); ++i) {
    if (number[i] == 0) continue;
    out.attributes.push_back(components.attributes[i - 1]);
    number[i] = static_cast<Component>(out.attributes.size());
  }
  const auto renumber = [&](auto& list) {
    for (auto& entry : list) entry.second = number[entry.second];
  };
  for_each_dimension(renumber, out.selection);
  out.features = active(out.selection, components.features);
  return out;
}

}  // namespace cnrg
