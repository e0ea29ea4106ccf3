// One pass over the numbered cells: each tells for which values of each criterion it would be picked, and is
// counted there. What a cell says of itself are its tags; which regions are around it is read off the faces, which
// have their two sides, and passed on to the edges and vertices on their boundary.
#include "csg/topology/selectables.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "csg/result/cell_tags.h"
#include "csg/result/result_data.h"
#include "csg/text/escape.h"
#include "csg/text/table.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;

constexpr std::array<const char*, 9> kKeys{"dimension", "region",     "front of", "behind", "name",
                                           "material",  "attributes", "from",     "between"};
enum Key : std::uint8_t { dimension, region, front_of, behind, name, material, attributes, from, between };

/// As a tree has it: in quotes where the text alone would be something else, such as a number.
std::string typed(const std::string& text) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
           c == '.' || c == ' ' || c == '&' || c == '/' || static_cast<unsigned char>(c) >= 0x80;
  };
  static const std::set<std::string> kWords{"null", "Null",  "NULL",  "true", "True",
                                            "TRUE", "false", "False", "FALSE"};
  const bool letter =
      !text.empty() && (text[0] == '_' || (text[0] >= 'a' && text[0] <= 'z') ||
                        (text[0] >= 'A' && text[0] <= 'Z') || static_cast<unsigned char>(text[0]) >= 0x80);
  if (letter && text.back() != ' ' && !kWords.contains(text) && std::all_of(text.begin(), text.end(), plain))
    return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return out + '"';
}

std::string typed(const Property& value) {
  if (const auto* const text = std::get_if<std::string>(&value)) return typed(*text);
  return to_text(value);
}

class Lister {
 public:
  explicit Lister(const ResultView& view)
      : view_(view),
        flat_(flatten(view)),
        tagger_(view, flat_),
        of_group_(view.value->is_group() || view.of_group),
        sides_(named_sides(view)) {
    find_surroundings();
  }

  std::vector<Selectable> list() {
    for (Index i = 0; i < flat_.regions.size(); ++i) {
      if (flat_.regions[i].component != 0) count(3, tagger_.region(i), flat_.regions[i].origin, {i});
    }
    const auto count_all = [&](int dimension, const auto& cells, const auto& around, auto tags) {
      for (Index i = 0; i < cells.size(); ++i) {
        if (of_group_ ? cells[i].entity : cells[i].component != 0)
          count(dimension, tags(i), cells[i].origin, around[i]);
      }
    };
    count_all(2, flat_.faces, around_faces_, [&](Index i) { return tagger_.face(i); });
    count_all(1, flat_.edges, around_edges_, [&](Index i) { return tagger_.edge(i); });
    count_all(0, flat_.vertices, around_vertices_, [&](Index i) { return tagger_.vertex(i); });
    std::vector<Selectable> out;
    for (const auto& [criterion, cells] : cells_) {
      const auto& [key, order, value] = criterion;
      Selectable& s = out.emplace_back(Selectable{kKeys[key], value, cells, {}});
      if (key != from) continue;
      const std::set<std::uint32_t>& faces = source_faces_[value];
      s.source_faces.assign(faces.begin(), faces.end());
    }
    return out;
  }

 private:
  using Regions = std::vector<Index>;  // ascending, unique; kNone among them: outside of all that are listed

  void find_surroundings() {
    around_faces_.resize(flat_.faces.size());
    around_edges_.resize(flat_.edges.size());
    std::vector<Regions> around_points(flat_.points.size());
    const auto add = [](Regions& to, const Regions& regions) {
      to.insert(to.end(), regions.begin(), regions.end());
    };
    for (Index f = 0; f < flat_.faces.size(); ++f) {
      const FlatComplex::Face& face = flat_.faces[f];
      around_faces_[f] = {face.regions[0], face.regions[1]};
      for (const FlatComplex::Loop& loop : face.loops) {
        for (const Index point : loop) add(around_points[point], around_faces_[f]);
      }
      for (const Index point : face.isolated) add(around_points[point], around_faces_[f]);
    }
    for (Index e = 0; e < flat_.edges.size(); ++e) {
      const FlatComplex::Edge& edge = flat_.edges[e];
      if (edge.around.empty()) around_edges_[e] = {edge.region};
      for (const Index side : edge.around) add(around_edges_[e], around_faces_[side / 2]);
      for (const Index point : edge.points) add(around_points[point], around_edges_[e]);
    }
    for (const FlatComplex::Vertex& vertex : flat_.vertices) {
      Regions& around = around_vertices_.emplace_back(around_points[vertex.point]);
      if (around.empty()) around = {vertex.region};
    }
    for (std::vector<Regions>* const all : {&around_faces_, &around_edges_, &around_vertices_}) {
      for (Regions& regions : *all) sort_unique(regions);
    }
  }

  void count(int dimension_of_cell, const CellTags& tags, const FlatComplex::Provenance& origin,
             const Regions& around) {
    std::set<Criterion> holds{{dimension, 3 - dimension_of_cell, std::to_string(dimension_of_cell)}};
    std::set<Component> components;
    for (const Index r : around) {
      if (flat_.active(r)) components.insert(flat_.regions[r].component);
    }
    if (!of_group_ && tags.component != 0) components.insert(Component(tags.component));
    for (const Component c : components) {
      holds.insert(region_of(c));
      for (const NamedSide& side : sides_[c - 1])
        holds.insert({side.front ? front_of : behind, 0, typed(side.surface)});
    }
    if (tags.said != nullptr) {
      if (!tags.said->name.empty()) holds.insert({name, 0, typed(tags.said->name.text())});
      if (!tags.said->material.empty()) holds.insert({material, 0, typed(tags.said->material.name())});
      for (const auto& [key, value] : tags.said->properties) {
        holds.insert({attributes, 0, "{" + typed(key) + ": " + typed(value) + "}"});
      }
    }
    for (const LeafId leaf : origin.leaves) {
      const std::string leaf_name = typed((*view_.leaves)[leaf.index()].name);
      holds.insert({from, 0, leaf_name});
      for (const LeafCell& cell : origin.cells) {
        if (dimension_of_cell == 2 && cell.leaf == leaf && cell.dimension == 2)
          source_faces_[leaf_name].insert(cell.number);
      }
    }
    if (dimension_of_cell < 3) add_pairs(around, holds);
    for (const Criterion& criterion : holds) ++cells_[criterion][static_cast<std::size_t>(dimension_of_cell)];
  }

  using Criterion = std::tuple<Key, int, std::string>;  // its number for the order, then its value

  /// A region by its name, or by its number, if it has none.
  Criterion region_of(Component component) const {
    const std::string& called = attributes_of(view_, component).name;
    if (!called.empty()) return {region, 0, typed(called)};
    return {region, static_cast<int>(component), std::to_string(component)};
  }

  /// What may stand in `between`: names of regions, and their materials.
  void add_pairs(const Regions& around, std::set<Criterion>& holds) const {
    add_pairs(
        around, [](const RegionAttributes& said) -> const std::string& { return said.name; }, holds);
    add_pairs(
        around, [](const RegionAttributes& said) -> const std::string& { return said.material.name(); }, holds);
  }
  template <class Called>
  void add_pairs(const Regions& around, Called called, std::set<Criterion>& holds) const {
    std::vector<std::pair<Component, std::string>> sides;
    for (const Index r : around) {
      const Component component = flat_.active(r) ? flat_.regions[r].component : 0;
      const std::string& word = called(attributes_of(view_, component));
      if (component == 0 || !word.empty()) sides.emplace_back(component, component == 0 ? "null" : typed(word));
    }
    for (const auto& [first, first_name] : sides) {
      for (const auto& [second, second_name] : sides) {
        if (first == second || first == 0) continue;
        if (second != 0 && std::pair(second_name, second) < std::pair(first_name, first)) continue;
        holds.insert({between, 0, "[" + first_name + ", " + second_name + "]"});
      }
    }
  }

  const ResultView& view_;
  const FlatComplex flat_;
  const CellTagger tagger_;
  const bool of_group_;
  const std::vector<std::vector<NamedSide>> sides_;
  std::vector<Regions> around_faces_, around_edges_, around_vertices_;
  std::map<Criterion, std::array<std::size_t, 4>> cells_;
  std::map<std::string, std::set<std::uint32_t>> source_faces_;
};

/// `0-5, 8`, the first of them if there are many.
std::string ranges(const std::vector<std::uint32_t>& numbers) {
  constexpr std::size_t kMostRanges = 8;
  std::string text;
  std::size_t listed = 0;
  for (std::size_t i = 0; i < numbers.size(); ++listed) {
    if (listed == kMostRanges) return text + ", ...";
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += (text.empty() ? "" : ", ") + std::to_string(numbers[i]);
    if (last > i) text += "-" + std::to_string(numbers[last]);
    i = last + 1;
  }
  return text;
}

}  // namespace

std::vector<Selectable> selectables(const Result& result) {
  const ResultView view = result.data().view();
  return Lister(view).list();
}

std::string selectables_text(const std::vector<Selectable>& list) {
  Table table({"<criterion", "<value", "regions", "faces", "edges", "vertices", "<source face"});
  for (const Selectable& s : list) {
    table.add_row({s.key, shown(s.value), std::to_string(s.cells[3]), std::to_string(s.cells[2]),
                   std::to_string(s.cells[1]), std::to_string(s.cells[0]), ranges(s.source_faces)});
  }
  return table.text();
}

}  // namespace cnrg
