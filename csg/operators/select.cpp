// Each cell is asked once; what is around it is read off the complex. What is picked of a group is marked with its
// closure (subgroup.h), and one pass over the lists of the group takes what is marked.
#include "csg/operators/select.h"

#include <algorithm>

#include "csg/operators/cell_sources.h"
#include "csg/operators/component_lists.h"
#include "csg/operators/subgroup.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

template <class T>
bool one_of(const std::vector<T>& wanted, const T& value) {
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), value) != wanted.end();
}

bool has(const CellSet& set, VertexId v) {
  return std::binary_search(set.vertices.begin(), set.vertices.end(), v);
}
bool has(const CellSet& set, EdgeId e) { return std::binary_search(set.edges.begin(), set.edges.end(), e); }
bool has(const CellSet& set, FaceId f) { return std::binary_search(set.faces.begin(), set.faces.end(), f); }
bool has(const CellSet& set, RegionId r) { return std::binary_search(set.regions.begin(), set.regions.end(), r); }

constexpr int dimension_of(VertexId) { return 0; }
constexpr int dimension_of(EdgeId) { return 1; }
constexpr int dimension_of(FaceId) { return 2; }
constexpr int dimension_of(RegionId) { return 3; }

// What the two kinds of values call the component of a 3-cell, and what is said of one.
Component component_at(const Group& group, RegionId r) { return group.region_of(r); }
Component component_at(const Components& x, RegionId r) {
  const std::size_t k = place_in(x.selection.regions, r);
  return k == x.selection.regions.size() ? 0 : x.selection.regions[k].second;
}
const RegionAttributes& attributes(const Group& group, Component i) { return group.regions[i - 1]; }
const RegionAttributes& attributes(const Components& x, Component i) { return x.attributes[i - 1]; }

template <class Value>
class Picker {
 public:
  Picker(const Complex& complex, const Value& value, const Criteria& criteria)
      : complex_(complex), value_(value), criteria_(criteria) {
    // The cells whose closure meets the set.
    if (criteria.touching) touching_ = star(complex, *criteria.touching);
  }

  /// A cell that came from `origin` and of which `said` is said, if anything; its component, or 0 for an entity of
  /// a group.
  template <class IdT>
  bool picks(IdT cell, const Attributes* said, LeafSetId origin, Component own) const {
    return one_of(criteria_.dimensions, dimension_of(cell)) && says(said) &&
           comes_from(cell, value_.origins.sets[origin]) && is_in_place(cell) && is_among_regions(cell, own);
  }

  /// A region of a group, with its 3-cells.
  bool picks_region(Component region, std::span<const RegionId> cells) const {
    const RegionAttributes& said = attributes(value_, region);
    const auto inside = [&](RegionId r) { return has(*criteria_.inside, r); };
    const auto touches = [&](RegionId r) { return has(touching_, r); };
    return one_of(criteria_.dimensions, 3) && criteria_.between.empty() && criteria_.source_faces.empty() &&
           says(&said) && is_wanted(region) && from(said.leaves) &&
           (!criteria_.inside || std::all_of(cells.begin(), cells.end(), inside)) &&
           (!criteria_.touching || std::any_of(cells.begin(), cells.end(), touches));
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
    return one_of(criteria_.names, said->name) && one_of(criteria_.materials, said->material.name()) &&
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
    std::vector<LeafId> wanted;
    std::set_intersection(leaves.begin(), leaves.end(), criteria_.leaves.begin(), criteria_.leaves.end(),
                          std::back_inserter(wanted));
    const std::vector<LeafCell> cells = leaf_cells(complex_, cell, wanted);
    return std::any_of(cells.begin(), cells.end(), [&](const LeafCell& of) {
      return of.dimension == 2 && one_of(criteria_.source_faces, of.number);
    });
  }

  template <class IdT>
  bool is_in_place(IdT cell) const {
    return (!criteria_.inside || has(*criteria_.inside, cell)) && (!criteria_.touching || has(touching_, cell));
  }

  template <class IdT>
  bool is_among_regions(IdT cell, Component own) const {
    const bool any_region = criteria_.regions.empty() && criteria_.region_numbers.empty();
    if (any_region && criteria_.between.empty()) return true;
    const std::vector<Component> around = components_around(cell);
    const auto wanted = [&](Component component) { return is_wanted(component); };
    return (any_region || is_wanted(own) || std::any_of(around.begin(), around.end(), wanted)) &&
           is_between(around);
  }
  /// By name or number; 0 is no region.
  bool is_wanted(Component component) const {
    if (criteria_.regions.empty() && criteria_.region_numbers.empty()) return true;
    const auto is = [&](const auto& list, const auto& value) {
      return std::find(list.begin(), list.end(), value) != list.end();
    };
    return component != 0 &&
           (is(criteria_.region_numbers, component) || is(criteria_.regions, attributes(value_, component).name));
  }

  /// Those that the 3-cells around a cell are of, ascending and unique; 0 is none.
  template <class IdT>
  std::vector<Component> components_around(IdT cell) const {
    std::vector<RegionId> cells;
    add_star(cell, cells);
    std::vector<Component> components;
    components.reserve(cells.size());
    for (const RegionId r : cells) components.push_back(component_at(value_, r));
    sort_unique(components);
    return components;
  }
  static void add_star(RegionId r, std::vector<RegionId>& out) { out = {r}; }
  void add_star(FaceId f, std::vector<RegionId>& out) const {
    out.assign(complex_.face_regions[f].begin(), complex_.face_regions[f].end());
  }
  void add_star(EdgeId e, std::vector<RegionId>& out) const { complex_.star_regions(e, out); }
  void add_star(VertexId v, std::vector<RegionId>& out) const { complex_.star_regions(v, out); }

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
};

}  // namespace

Group select(const Complex& complex, const Group& group, const Criteria& criteria) {
  const Picker picker(complex, group, criteria);
  const GroupSources sources(complex, group);
  WantedEntities wanted(complex);
  const auto want = [&](const auto& cells, const auto& origins) {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (picker.picks(cells[k], sources.said(cells[k]), origins[k], 0)) wanted.add(cells[k]);
    }
  };
  want(group.faces, group.origins.faces);
  want(group.edges, group.origins.edges);
  want(group.vertices, group.origins.vertices);

  std::vector<std::vector<RegionId>> cells_of(group.regions.size());
  for (const auto& [cell, region] : group.cells) cells_of[region - 1].push_back(cell);
  std::vector<Component> number(group.regions.size() + 1, 0);  // in the selection; 0: not picked
  std::vector<RegionAttributes> regions;
  for (Component region = 1; region <= group.regions.size(); ++region) {
    if (!picker.picks_region(region, cells_of[region - 1])) continue;
    regions.push_back(group.regions[region - 1]);
    number[region] = static_cast<Component>(regions.size());
    for (const RegionId cell : cells_of[region - 1]) {
      for (const HalfFace h : complex.region_faces[cell]) wanted.add(h.face());
      for (const EdgeId e : complex.region_wires[cell]) wanted.add(e);
      for (const VertexId v : complex.region_vertices[cell]) wanted.add(v);
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
  Components out;
  LeafSetMap map(components.origins.sets, out.origins.sets);
  std::vector<Component> number(components.attributes.size() + 1, 0);
  const auto pick = [&](auto& to, auto& to_origins, const auto& cells, const auto& origins) {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const auto& [cell, component] = cells[k];
      if (!picker.picks(cell, said(cell, component), origins[k], component)) continue;
      to.push_back(cells[k]);
      to_origins.push_back(map(origins[k]));
      number[component] = 1;
    }
  };
  for_each_list(out, components, [&](auto& to, auto& to_origins, const auto& cells, const auto& origins) {
    pick(to, to_origins, cells, origins);
  });
  for (Component i = 1; i < number.size(); ++i) {
    if (number[i] == 0) continue;
    out.attributes.push_back(components.attributes[i - 1]);
    number[i] = static_cast<Component>(out.attributes.size());
  }
  for_each_list(out, [&](auto& list, const auto&) {
    for (auto& entry : list) entry.second = number[entry.second];
  });
  out.features = active(out.selection, components.features);
  return out;
}

}  // namespace cnrg
