// Names of groups. Several components may have one name (the parts of a block that a fault has split): each of
// these pieces is a group, called by the name and its number, and all of them together are the group of the name.
// Those on one side of a surface that parts them are a group, too.
#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "csg/mesh/mesh.h"
#include "csg/result/cell_tags.h"
#include "csg/text/escape.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;

/// What the components with active regions are called.
struct RegionName {
  std::string piece;    ///< unlike the names of all other components
  std::string name;     ///< of this one and others; empty: no other component has it
  Component first = 0;  ///< the first component of that name
};

std::map<Component, RegionName> region_names(const ResultView& view, const FlatComplex& flat) {
  std::map<Component, RegionName> names;
  std::map<std::string, std::vector<Component>> uses;
  for (const auto& region : flat.regions) {
    if (region.component == 0 || names.count(region.component) != 0) continue;
    std::string name = shown_in_quotes(attributes_of(view, region.component).name.text());
    if (!name.empty()) uses[name].push_back(region.component);
    names[region.component] = {{}, name, region.component};
  }
  std::set<std::string> given;
  for (auto& [name, components] : uses) {
    given.insert(name);
    std::sort(components.begin(), components.end());
  }
  for (auto& [component, of] : names) {
    const auto use = uses.find(of.name);
    if (use != uses.end()) of.first = use->second[0];
    if (use != uses.end() && use->second.size() == 1) {
      of.piece = std::move(of.name);
      of.name.clear();
      continue;
    }
    of.piece = (of.name.empty() ? "region" : of.name) + " " + std::to_string(component);
    while (!given.insert(of.piece).second) of.piece += "'";
  }
  return names;
}

class Grouper {
 public:
  Grouper(const ResultView& view, const FlatComplex& flat)
      : view_(view), flat_(flat), regions_(region_names(view, flat)) {}

  MeshGroups run() {
    group_regions();
    group(2, flat_.faces, [&](const auto& f) { return keys_of_face(f); });
    group(1, flat_.edges, [&](const auto& e) {
      return e.wire ? shared({{1, "wire" + of_leaf(e.origin, 1)}}) : &none_;
    });
    group(0, flat_.vertices, [&](const auto& v) {
      return v.free ? shared({{1, "point" + of_leaf(v.origin, 0)}}) : &none_;
    });
    group_by_attributes(0, flat_.vertices), group_by_attributes(1, flat_.edges);
    group_by_attributes(2, flat_.faces), group_by_attributes(3, flat_.regions);
    group_sources();
    return std::move(groups_);
  }

 private:
  /// Rank and name of groups.
  using Keys = std::vector<std::pair<std::size_t, std::string>>;
  const ResultView& view_;
  const FlatComplex& flat_;
  const std::map<Component, RegionName> regions_;
  MeshGroups groups_;
  std::array<std::set<std::string>, 4> used_;
  // Cells share their keys: strings for each would cost more than all else.
  const Keys none_;
  std::set<Keys> keys_;
  std::map<std::array<Component, 2>, const Keys*> keys_beside_;  // by the components on the sides of a face

  const Keys* shared(Keys keys) { return &*keys_.insert(std::move(keys)).first; }

  /// Regions by component, then by the names of several components, then by the sides that part these.
  void group_regions() {
    std::map<Component, Index> piece, named;  // by component, and by the first one of a name
    std::map<Component, std::vector<Index>> on_sides;
    for (const auto& [component, of] : regions_) piece[component] = add_group(3, of.piece);
    for (const auto& [component, of] : regions_) {
      if (!of.name.empty() && of.first == component) named[component] = add_group(3, of.name);
    }
    std::map<std::pair<std::string, std::string>, Index> side_groups;  // by name of pieces, and side
    const std::vector<std::vector<NamedSide>> sides = named_sides(view_);
    for (const auto& [component, of] : regions_) {
      for (const NamedSide& side : sides[component - 1]) {
        if (!side.tells) continue;
        const std::pair key(of.name.empty() ? "region" : of.name,
                            side.key() + (' ' + shown_in_quotes(side.surface)));
        const auto [group, fresh] = side_groups.try_emplace(key, 0);
        if (fresh) group->second = add_group(3, key.first + ' ' + key.second);
        on_sides[component].push_back(group->second);
      }
    }
    for (const auto& region : flat_.regions) {
      auto& groups = groups_.of[3].emplace_back();
      if (region.component == 0) continue;
      const RegionName& of = regions_.at(region.component);
      groups.push_back(piece.at(region.component));
      if (!of.name.empty()) groups.push_back(named.at(of.first));
      if (const auto on = on_sides.find(region.component); on != on_sides.end())
        groups.append(on->second.begin(), on->second.end());
    }
  }

  /// What is said of a cell: of a region what is said of its component.
  const Attributes* said(const FlatComplex::Region& region) const {
    return region.component == 0 ? nullptr : &attributes_of(view_, region.component);
  }
  template <class Cell>
  const Attributes* said(const Cell& cell) const {
    return cell.component == 0 ? nullptr : cell.origin.said;
  }

  /// A group more for each material, in the tree's order, and then for each property with a text.
  template <class Cells>
  void group_by_attributes(std::size_t dimension, const Cells& cells) {
    std::map<std::pair<std::string, std::string>, Index> numbers;  // by key, empty for materials, and value
    const auto for_each = [&](const auto& cell, const auto& see) {
      const Attributes* of = said(cell);
      if (of == nullptr) return;
      if (!of->material.empty()) see(std::pair(std::string(), of->material.name()));
      for (const auto& [key, value] : of->properties) {
        if (const auto* text = std::get_if<std::string>(&value)) see(std::pair(key, *text));
      }
    };
    for (const auto& cell : cells) {
      for_each(cell, [&](const auto& group) { numbers[group] = 0; });
    }
    for (const auto& m : view_.materials) {
      const auto it = numbers.find({"", m.name});
      if (it != numbers.end()) it->second = add_group(dimension, "material " + shown_in_quotes(m.name));
    }
    for (auto& [group, of] : numbers) {
      if (group.first.empty()) continue;
      of = add_group(dimension, shown_in_quotes(group.first) + " " + shown_in_quotes(group.second));
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      for_each(cells[i], [&](const auto& group) {
        if (const Index n = numbers.at(group)) groups_.of[dimension][i].push_back(n);
      });
    }
  }

  /// The number of a new group; its name is made unlike the others of its dimension.
  Index add_group(std::size_t dimension, std::string name) {
    while (!used_[dimension].insert(name).second) name += "'";
    groups_.names[dimension].push_back(std::move(name));
    return Index(groups_.names[dimension].size());
  }

  template <class Cells, class KeysOf>
  void group(std::size_t dimension, const Cells& cells, const KeysOf& keys_of) {
    std::map<std::string, Index> given;               // names that people gave
    std::map<typename Keys::value_type, Index> made;  // and the others, by rank and text
    std::vector<const Keys*> keys;
    std::map<const Keys*, std::vector<Index>> numbers;  // of their groups
    for (const auto& cell : cells) {
      keys.push_back(cell.component == 0 ? &none_ : keys_of(cell));
      const Attributes* of = said(cell);
      if (of != nullptr && !of->name.empty()) {
        given[shown_in_quotes(of->name.text())] = 0;
        if (!is_wall(cell)) keys.back() = &none_;  // of a wall with a name one may ask for both
      }
      numbers[keys.back()];
    }
    for (const auto& [list, unused] : numbers) {
      for (const auto& key : *list) made[key] = 0;
    }
    for (auto& [name, number] : given) number = add_group(dimension, name);
    for (auto& [key, number] : made) number = add_group(dimension, key.second);
    for (auto& [list, of] : numbers) {
      for (const auto& key : *list) of.push_back(made.at(key));
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      auto& of = groups_.of[dimension].emplace_back();
      const Attributes* what = said(cells[i]);
      if (what != nullptr && !what->name.empty()) of.push_back(given.at(shown_in_quotes(what->name.text())));
      const std::vector<Index>& further = numbers.at(keys[i]);
      of.append(further.begin(), further.end());
    }
  }

  bool is_wall(const FlatComplex::Face& face) const { return flat_.regions_bounded(face) != 0; }
  template <class Cell>
  bool is_wall(const Cell&) const {
    return false;
  }

  /// Faces once more, by the leaves that they came from, in the order of the node's subtree.
  void group_sources() {
    std::map<std::pair<std::uint32_t, LeafId>, Index> numbers;
    const auto in_order = [&](LeafId leaf) { return std::pair(view_.place(leaf), leaf); };
    for (const auto& face : flat_.faces) {
      for (const LeafId leaf : sources(face)) numbers[in_order(leaf)] = 0;
    }
    for (auto& [key, number] : numbers) {
      const LeafId leaf = key.second;
      // Two instances of a leaf, or a sheet that is called so.
      const std::string first = "from " + shown_in_quotes((*view_.leaves)[leaf.index()].name);
      std::string name = first;
      for (int n = 2; used_[2].count(name) != 0; ++n) name = first + " " + std::to_string(n);
      number = add_group(2, name);
      ++groups_.sources;
    }
    for (std::size_t i = 0; i < flat_.faces.size(); ++i) {
      for (const LeafId leaf : sources(flat_.faces[i])) groups_.of[2][i].push_back(numbers.at(in_order(leaf)));
    }
  }

  /// The leaves that have a face there, ascending; of an active face.
  std::vector<LeafId> sources(const FlatComplex::Face& face) const {
    std::vector<LeafId> leaves;
    if (face.component == 0 || view_.leaves == nullptr) return leaves;
    for (const LeafCell& cell : face.origin.cells) {
      const bool known = cell.dimension == 2 && cell.leaf.index() < view_.leaves->size();
      if (known && (leaves.empty() || leaves.back() != cell.leaf)) leaves.push_back(cell.leaf);
    }
    return leaves;
  }

  /// Boundaries by component, walls by their two components, and both once more by names of several components;
  /// dangling faces by leaf.
  const Keys* keys_of_face(const FlatComplex::Face& face) {
    const std::size_t n = view_.value->component_count() + 1;
    if (flat_.regions_bounded(face) == 0) return shared({{2 * n * n, "face" + of_leaf(face.origin, 2)}});
    std::array<Component, 2> beside{};
    for (std::size_t side = 0; side < 2; ++side) {
      if (flat_.active(face.regions[side])) beside[side] = flat_.regions[face.regions[side]].component;
    }
    const Keys*& keys = keys_beside_[beside];
    if (keys == nullptr) keys = shared(keys_of_sides(beside));
    return keys;
  }

  /// 0: no component.
  Keys keys_of_sides(const std::array<Component, 2>& of) const {
    std::vector<Component> beside(of.begin(), of.end());
    std::erase(beside, Component{0});
    const std::size_t n = view_.value->component_count() + 1;
    const bool pieces =
        std::any_of(beside.begin(), beside.end(), [&](Component c) { return !regions_.at(c).name.empty(); });
    Keys keys{key_of_sides(0, beside, [&](Component c) { return std::pair(c, regions_.at(c).piece); })};
    if (pieces) {
      keys.push_back(key_of_sides(n * n, beside, [&](Component c) {
        const RegionName& of = regions_.at(c);
        return std::pair(of.first, of.name.empty() ? of.piece : of.name);
      }));
    }
    return keys;
  }

  template <class NameOf>
  Keys::value_type key_of_sides(std::size_t before, const std::vector<Component>& beside,
                                const NameOf& name_of) const {
    std::vector<std::pair<Component, std::string>> sides;
    for (const Component c : beside) sides.push_back(name_of(c));
    std::sort(sides.begin(), sides.end());
    if (sides.size() == 1) return {before + sides[0].first, "boundary of " + sides[0].second};
    const std::size_t n = view_.value->component_count() + 1;
    return {before + sides[0].first * n + sides[1].first, "wall " + sides[0].second + " | " + sides[1].second};
  }

  /// ` of NAME`: the first leaf with a cell of the dimension there, or else the first leaf.
  std::string of_leaf(const FlatComplex::Provenance& origin, int dimension) const {
    const LeafId* leaf = origin.leaves.empty() ? nullptr : &origin.leaves[0];
    for (const LeafCell& cell : origin.cells) {
      if (cell.dimension != dimension) continue;
      leaf = &cell.leaf;
      break;
    }
    if (leaf == nullptr || view_.leaves == nullptr || leaf->index() >= view_.leaves->size()) return "";
    return " of " + shown_in_quotes((*view_.leaves)[leaf->index()].name);
  }
};

}  // namespace

MeshGroups mesh_groups(const ResultView& view, const FlatComplex& flat) { return Grouper(view, flat).run(); }

std::vector<std::string> region_labels(const FlatComplex& flat, const MeshGroups& groups) {
  std::map<Index, std::size_t> uses;
  for (const auto& of : groups.of[3]) {
    if (!of.empty()) ++uses[of[0]];
  }
  std::vector<std::string> names(flat.regions.size());
  for (Index r = 0; r < names.size(); ++r) {
    if (!flat.active(r)) continue;
    const Index group = groups.of[3][r][0];
    names[r] = groups.names[3][group - 1];
    if (uses[group] > 1) names[r] += " r" + std::to_string(r);
  }
  return names;
}

}  // namespace cnrg
