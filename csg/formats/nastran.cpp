// Nastran's bulk data, fixed fields: points, solids, shells and rods with property ids, and sets.
//
// As in abaqus.cpp, a triangle that only bounds a region is no element (element_plan.h). An element has one
// property, for its first group; whatever else it is in, and the boundaries, are SET1 cards. Names are comments,
// since cards have numbers only. Material cards are left to the deck: a mesh knows what its materials are called,
// not how stiff they are. What the tree says as `thickness`, `area` or `diameter` becomes T of a PSHELL, A of a
// PROD.
//
// Points are in large fields of 16 characters, the most that the format has. Of second order there are solids and
// shells; a rod has two ends, so each segment becomes two.
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

#include "csg/formats/element_plan.h"
#include "csg/formats/formats.h"
#include "csg/formats/group_names.h"
#include "csg/formats/narrow_numbers.h"
#include "csg/mesh/second_order.h"
#include "csg/text/escape.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;

std::string field(const std::string& text, std::size_t width) {
  return std::string(text.size() < width ? width - text.size() : 0, ' ') + text;
}

/// A card in small fields, eight to a line.
void append_card(std::string& text, const std::string& name, const std::vector<std::size_t>& numbers) {
  text += name + std::string(8 - name.size(), ' ');
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && i % 8 == 0) text += "\n+       ";
    text += field(std::to_string(numbers[i]), 8);
  }
  text += '\n';
}

/// A card in large fields, of which there are four at most.
void append_large_card(std::string& text, const std::string& name, const std::vector<std::string>& fields) {
  std::string line = name + "*" + std::string(7 - name.size(), ' ');
  for (const std::string& f : fields) line += field(f, 16);
  while (line.back() == ' ') line.pop_back();
  text += line + "\n";
}

/// A number that the tree says of an entity.
std::optional<double> said_number(const Mesh::Entity& entity, const std::string& key) {
  if (entity.tags.said == nullptr) return std::nullopt;
  const auto it = entity.tags.said->properties.find(key);
  if (it == entity.tags.said->properties.end()) return std::nullopt;
  const auto* number = std::get_if<Rational>(&it->second);
  return number == nullptr ? std::nullopt : std::optional(to_double(*number));
}

/// T of a shell, A of a rod.
std::optional<double> size_of(const Mesh::Entity& entity, std::size_t dimension) {
  if (dimension == 2) return said_number(entity, "thickness");
  if (dimension != 1) return std::nullopt;
  if (const auto area = said_number(entity, "area")) return area;
  const auto diameter = said_number(entity, "diameter");
  return diameter ? std::optional(std::numbers::pi / 4 * *diameter * *diameter) : std::nullopt;
}

std::string in_comment(std::string_view name) { return cut(shown(name), 100); }

class NastranWriter {
 public:
  explicit NastranWriter(const Mesh& mesh)
      : mesh_(mesh), plan_(mesh), names_(distinct_names(mesh, {in_comment, 100, " (", ")", true})) {
    require_room(mesh.points.size());
    require_room(mesh.tetrahedra.size() + plan_.shells().size() + mesh.quads.size() + 2 * plan_.bars().size());
  }

  std::string run() {
    const bool straight = mesh_.middles.empty();
    add_elements(3, "CTETRA", mesh_.tetrahedra, kSecondOrderEdges);
    add_elements(2, straight ? "CTRIA3" : "CTRIA6", plan_.shells(), kSecondOrderTriangle);
    add_elements(2, "CQUAD4", mesh_.quads, kSecondOrderPoint);
    add_rods();
    std::string text = "$ node " + cut(shown(mesh_.node), 60) + ", written by cnrg\n";
    std::map<std::size_t, std::string> names;
    for (const auto& [name, number] : materials_) names[number] = name;
    for (const auto& [number, name] : names) {
      text += "$ material " + std::to_string(number) + ": " +
              (name.empty() ? "none was said" : cut(shown(name), 50)) + "; its MAT1 is not in this file\n";
    }
    text += "CEND\nBEGIN BULK\n";
    add_properties(text);
    for (std::size_t p = 0; const auto& [x, y, z] : narrow_points(mesh_, Column::nastran, "Nastran's format")) {
      text += "GRID*   " + field(std::to_string(++p), 16) + std::string(16, ' ') + field(x, 16) + field(y, 16) +
              "\n*       " + field(z, 16) + "\n";
    }
    text += elements_;
    add_sets(text);
    return text + "ENDDATA\n";
  }

 private:
  /// Dimension, first group (0: none), material, size; what its elements have in common.
  using Property = std::tuple<std::size_t, Index, std::string, std::optional<double>>;
  const Mesh& mesh_;
  const ElementPlan plan_;
  const std::array<std::vector<std::string>, 4> names_;
  std::string elements_;
  std::size_t count_ = 0;
  std::map<std::string, std::size_t> materials_;
  std::map<Property, std::size_t> properties_;
  std::map<std::pair<std::size_t, Index>, std::vector<std::size_t>> sets_;  ///< elements by dimension and group
  std::size_t set_count_ = 0;

  /// Numbers have eight characters.
  static void require_room(std::size_t count) {
    if (count < 100'000'000) return;
    throw InputError("Nastran's format numbers 99,999,999 points or elements; mesh coarser, or write .msh");
  }

  std::size_t property(const Mesh::Entity& entity, std::size_t dimension) {
    const Attributes* said = entity.tags.said;
    const std::string material = said == nullptr || said->material.empty() ? "" : said->material.name();
    materials_.try_emplace(material, materials_.size() + 1);
    const Property key{dimension, entity.groups.empty() ? 0 : entity.groups[0], material,
                       size_of(entity, dimension)};
    return properties_.try_emplace(key, properties_.size() + 1).first->second;
  }

  void add_element(const char* card, const Mesh::Entity& entity, std::size_t dimension,
                   const std::vector<Index>& nodes) {
    std::vector<std::size_t> numbers{++count_, property(entity, dimension)};
    for (const Index p : nodes) numbers.push_back(p + 1);
    append_card(elements_, card, numbers);
    for (std::size_t k = 1; k < entity.groups.size(); ++k) sets_[{dimension, entity.groups[k]}].push_back(count_);
  }
  template <class Simplices, class Ends>
  void add_elements(std::size_t dimension, const char* card, const Simplices& simplices, const Ends& ends) {
    for (const auto& s : simplices) {
      add_element(card, mesh_.entities[dimension][s.entity], dimension, mesh_.nodes(s, ends));
    }
  }
  void add_rods() {
    for (const auto& s : plan_.bars()) {
      const std::vector<Index> at = mesh_.nodes(s, kSecondOrderLine);
      const Mesh::Entity& entity = mesh_.entities[1][s.entity];
      if (at.size() == 2) {
        add_element("CROD", entity, 1, at);
      } else {
        add_element("CROD", entity, 1, {at[0], at[2]});
        add_element("CROD", entity, 1, {at[2], at[1]});
      }
    }
  }

  std::string name_of(std::size_t dimension, Index group) const {
    return group == 0 ? "in no group" : names_[dimension][group - 1];
  }

  void add_properties(std::string& text) const {
    static constexpr const char* kCards[] = {"", "PROD", "PSHELL", "PSOLID"};
    std::map<std::size_t, Property> by_number;
    for (const auto& [key, number] : properties_) by_number[number] = key;
    for (const auto& [number, key] : by_number) {
      const auto& [dimension, group, material, size] = key;
      text += "$ " + std::string(kCards[dimension]) + " " + std::to_string(number) + ": " +
              name_of(dimension, group) + "\n";
      const std::string of = std::to_string(materials_.at(material));
      std::vector<std::string> fields{std::to_string(number), of};
      if (dimension < 3) fields.push_back(size ? narrow_number(*size, Column::nastran).text : "");
      if (dimension == 2) fields.push_back(of);  // for bending
      append_large_card(text, kCards[dimension], fields);
      text += "*\n";
    }
  }

  void add_set(std::string& text, const std::string& what, std::vector<std::size_t> numbers) {
    text += "$ SET1 " + std::to_string(++set_count_) + ": " + what + "\n";
    numbers.insert(numbers.begin(), set_count_);
    append_card(text, "SET1", numbers);
  }

  /// Elements of groups that are not the first, points of all other groups.
  void add_sets(std::string& text) {
    std::array<std::vector<char>, 4> told;
    for (std::size_t d = 0; d < 4; ++d) told[d].resize(mesh_.groups[d].size() + 1);
    for (const auto& [key, number] : properties_) told[std::get<0>(key)][std::get<1>(key)] = 1;
    for (const auto& [key, elements] : sets_) {
      told[key.first][key.second] = 1;
      add_set(text, "elements of " + name_of(key.first, key.second), elements);
    }
    for (std::size_t d = 0; d < 4; ++d) {
      const auto nodes = group_nodes(mesh_, d);
      for (Index g = 1; g <= nodes.size(); ++g) {
        if (!told[d][g] && !nodes[g - 1].empty()) add_set(text, "points of " + name_of(d, g), nodes[g - 1]);
      }
    }
  }
};

}  // namespace

std::string nastran_text(const Mesh& mesh) { return NastranWriter(mesh).run(); }

}  // namespace cnrg
