// Names of groups. Two components may have one name (the parts of a block that a fault has split): then each has
// its number behind it.
#include <algorithm>
#include <map>

#include "csg/mesh/mesh.h"
#include "csg/text/escape.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;

/// The components with active regions, by name; distinct.
std::map<Component, std::string> region_names(const ResultView& view, const FlatComplex& flat) {
  std::map<Component, std::string> names;
  std::map<std::string, int> uses;
  for (const auto& region : flat.regions) {
    if (region.component == 0 || names.count(region.component) != 0) continue;
    std::string name = shown_in_quotes(attributes_of(view, region.component).name.text());
    if (name.empty()) name = "region";
    ++uses[name];
    names.emplace(region.component, name);
  }
  const std::map<std::string, int> first = uses;
  for (auto& [component, name] : names) {
    if (first.at(name) == 1 && name != "region") continue;
    std::string numbered = name + " " + std::to_string(component);
    while (uses.count(numbered) != 0) numbered += "'";
    uses[numbered] = 1;
    name = numbered;
  }
  return names;
}

/// Names in a fixed order: by rank, then by text; asked for first, numbered then.
class GroupList {
 public:
  void want(std::size_t rank, const std::string& name) { numbers_[{rank, name}] = 0; }
  void number(std::vector<std::string>& names) {
    for (auto& [key, n] : numbers_) {
      names.push_back(key.second);
      n = Index(names.size());
    }
  }
  Index operator()(std::size_t rank, const std::string& name) const { return numbers_.at({rank, name}); }

 private:
  std::map<std::pair<std::size_t, std::string>, Index> numbers_;
};

class Grouper {
 public:
  Grouper(const ResultView& view, const FlatComplex& flat)
      : view_(view), flat_(flat), regions_(region_names(view, flat)) {}

  MeshGroups run() {
    group_regions();
    group(2, flat_.faces, [&](const auto& f) { return key_of_face(f); });
    group(1, flat_.edges, [&](const auto& e) { return e.wire ? Key{1, "wire" + of_leaf(e.origin, 1)} : Key{}; });
    group(0, flat_.vertices, [&](const auto& v) {
      return v.free ? Key{1, "point" + of_leaf(v.origin, 0)} : Key{};
    });
    group_by_attributes(0, flat_.vertices), group_by_attributes(1, flat_.edges);
    group_by_attributes(2, flat_.faces), group_by_attributes(3, flat_.regions);
    group_sources();
    return std::move(groups_);
  }

 private:
  /// Rank and name of a group; rank 0: none.
  using Key = std::pair<std::size_t, std::string>;
  const ResultView& view_;
  const FlatComplex& flat_;
  const std::map<Component, std::string> regions_;
  MeshGroups groups_;

  /// Regions by component.
  void group_regions() {
    std::map<Component, Index> number;
    auto& names = groups_.names[3];
    for (const auto& [component, name] : regions_) {
      names.push_back(name);
      number[component] = Index(names.size());
    }
    for (const auto& region : flat_.regions) {
      auto& of = groups_.of[3].emplace_back();
      if (region.component != 0) of.push_back(number[region.component]);
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
    const auto number = [&](const std::string& name, Index& to) {
      groups_.names[dimension].push_back(distinct(dimension, name));
      to = Index(groups_.names[dimension].size());
    };
    for (const auto& m : view_.materials) {
      const auto it = numbers.find({"", m.name});
      if (it != numbers.end()) number("material " + shown_in_quotes(m.name), it->second);
    }
    for (auto& [group, of] : numbers) {
      if (!group.first.empty()) number(shown_in_quotes(group.first) + " " + shown_in_quotes(group.second), of);
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      for_each(cells[i], [&](const auto& group) {
        if (const Index n = numbers.at(group)) groups_.of[dimension][i].push_back(n);
      });
    }
  }

  /// A name unlike the other ones of its dimension.
  std::string distinct(std::size_t dimension, std::string name) const {
    const std::vector<std::string>& names = groups_.names[dimension];
    while (std::find(names.begin(), names.end(), name) != names.end()) name += "'";
    return name;
  }

  template <class Cells, class KeyOf>
  void group(int dimension, const Cells& cells, const KeyOf& key_of) {
    std::map<std::string, Index> given;  // names that people gave, in their order
    std::vector<Key> keys;
    GroupList list;
    for (const auto& cell : cells) {
      keys.push_back(cell.component == 0 ? Key{} : key_of(cell));
      const Attributes* of = said(cell);
      if (of != nullptr && !of->name.empty()) {
        given[shown_in_quotes(of->name.text())] = 0;
        if (!is_wall(cell)) keys.back() = Key{};  // of a wall with a name one may ask for both
      }
      if (keys.back().first != 0) list.want(keys.back().first, keys.back().second);
    }
    std::vector<std::string>& names = groups_.names[std::size_t(dimension)];
    std::vector<std::string> made;
    list.number(made);
    for (auto& [name, number] : given) {
      const bool taken = std::find(made.begin(), made.end(), name) != made.end();
      names.push_back(taken ? name + "'" : name);
      number = Index(names.size());
    }
    const auto before = Index(names.size());
    names.insert(names.end(), made.begin(), made.end());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      auto& of = groups_.of[std::size_t(dimension)].emplace_back();
      const Attributes* what = said(cells[i]);
      if (what != nullptr && !what->name.empty()) of.push_back(given.at(shown_in_quotes(what->name.text())));
      if (keys[i].first != 0) of.push_back(before + list(keys[i].first, keys[i].second));
    }
  }

  bool is_wall(const FlatComplex::Face& face) const { return flat_.regions_bounded(face) != 0; }
  template <class Cell>
  bool is_wall(const Cell&) const {
    return false;
  }

  /// Faces once more, by the leaves that they came from, in the order of the leaves.
  void group_sources() {
    std::map<LeafId, Index> numbers;
    for (const auto& face : flat_.faces) {
      for (const LeafId leaf : sources(face)) numbers[leaf] = 0;
    }
    auto& names = groups_.names[2];
    for (auto& [leaf, number] : numbers) {
      std::string name = "from " + shown_in_quotes((*view_.leaves)[leaf.index()].name);
      // Two instances of a leaf, or a region that is called so.
      const std::string first = name;
      for (int n = 2; std::find(names.begin(), names.end(), name) != names.end(); ++n) {
        name = first + " " + std::to_string(n);
      }
      names.push_back(name);
      number = Index(names.size());
      ++groups_.sources;
    }
    for (std::size_t i = 0; i < flat_.faces.size(); ++i) {
      for (const LeafId leaf : sources(flat_.faces[i])) groups_.of[2][i].push_back(numbers.at(leaf));
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

  /// Boundaries by component, walls by their two components, dangling faces by leaf.
  Key key_of_face(const FlatComplex::Face& face) const {
    const std::size_t n = view_.value->component_count() + 1;
    Component c[2];
    for (int k = 0; k < 2; ++k) {
      c[k] = flat_.active(face.regions[k]) ? flat_.regions[face.regions[k]].component : 0;
    }
    if (c[0] > c[1]) std::swap(c[0], c[1]);
    switch (flat_.regions_bounded(face)) {
      case 1: return {c[1], "boundary of " + regions_.at(c[1])};
      case 2: return {c[0] * n + c[1], "wall " + regions_.at(c[0]) + " | " + regions_.at(c[1])};
      default: return {n * n, "face" + of_leaf(face.origin, 2)};
    }
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
    const Index group = groups.of[3][r].at(0);
    names[r] = groups.names[3][group - 1];
    if (uses[group] > 1) names[r] += " r" + std::to_string(r);
  }
  return names;
}

}  // namespace cnrg
