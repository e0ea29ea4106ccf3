// Abaqus's input format, as Abaqus and CalculiX read it: nodes, elements, and sets of them by the names of groups,
// for `*INCLUDE` in a deck that brings materials, sections and steps.
//
// A triangle on the boundary of a region is no element: in a solver it would be a shell that stiffens the solid,
// or that has no section. What asks for such faces (pressure, contact) takes a surface, made of sides of
// tetrahedra. Shells are triangles that stand for something: sheets, walls of which something is said, and all
// triangles of a mesh without tetrahedra. Wires are trusses.
//
// Labels have 80 characters of few kinds, and case does not tell them apart. A line holds 16 numbers, a number 20
// characters.
#include <algorithm>
#include <cctype>
#include <map>

#include "csg/formats/element_plan.h"
#include "csg/formats/formats.h"
#include "csg/formats/group_names.h"
#include "csg/formats/narrow_numbers.h"
#include "csg/mesh/periodic.h"
#include "csg/mesh/second_order.h"
#include "csg/text/escape.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;

class AbaqusWriter {
 public:
  explicit AbaqusWriter(const Mesh& mesh)
      : mesh_(mesh), plan_(mesh), names_(distinct_names(mesh, {plain_label, 80})) {}

  std::string run() {
    text_ = "*HEADING\nnode " + cut(shown(mesh_.node), 70) + ", written by cnrg\n";
    add_legend();
    const auto points = narrow_points(mesh_, Column::abaqus, "Abaqus's format");
    text_ += "*NODE\n";
    for (std::size_t p = 0; p < points.size(); ++p) {
      text_ += std::to_string(p + 1);
      for (const std::string& x : points[p]) text_ += ", " + x;
      text_ += '\n';
    }
    add_references();
    const bool straight = mesh_.middles.empty();
    add_elements(3, straight ? "C3D4" : "C3D10", mesh_.tetrahedra, kSecondOrderEdges);
    add_elements(2, straight ? "S3" : "STRI65", plan_.shells(), kSecondOrderTriangle);
    add_elements(2, "S4", mesh_.quads, kSecondOrderPoint);
    add_elements(1, straight ? "T3D2" : "T3D3", plan_.bars(), kSecondOrderLine);
    add_elements(3, "COH3D6", mesh_.wedges, kSecondOrderPoint);
    add_sets();
    add_equations();
    return std::move(text_);
  }

 private:
  const Mesh& mesh_;
  const ElementPlan plan_;
  const std::array<std::vector<std::string>, 4> names_;
  std::string text_;
  std::size_t elements_ = 0;
  std::map<std::pair<std::size_t, Index>, std::vector<std::size_t>> sets_;  ///< elements by dimension and group

  void add_legend() {
    for (std::size_t d = 4; d-- > 0;) {
      for (std::size_t g = 0; g < names_[d].size(); ++g) {
        if (names_[d][g] != mesh_.groups[d][g])
          text_ += "** " + names_[d][g] + " is " + cut(shown(mesh_.groups[d][g]), 150) + "\n";
      }
    }
  }

  template <class Simplices, class Ends>
  void add_elements(std::size_t dimension, const std::string& type, const Simplices& simplices, const Ends& ends) {
    if (simplices.empty()) return;
    text_ += "*ELEMENT, TYPE=" + type + "\n";
    for (const auto& s : simplices) {
      text_ += std::to_string(++elements_);
      std::vector<Index> nodes = mesh_.nodes(s, ends);
      if (dimension == 1 && nodes.size() == 3) std::swap(nodes[1], nodes[2]);  // the middle stands in the middle
      for (const Index p : nodes) text_ += ", " + std::to_string(p + 1);
      text_ += '\n';
      for (const Index group : mesh_.entities[dimension][s.entity].groups)
        sets_[{dimension, group}].push_back(elements_);
    }
  }

  void add_list(const std::string& head, const std::vector<std::size_t>& numbers) {
    text_ += head + "\n";
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      text_ += std::to_string(numbers[i]) + (i + 1 == numbers.size() ? "\n" : i % 16 == 15 ? ",\n" : ", ");
    }
  }

  /// Of a mesh that repeats, by axis: a node whose displacement is that of the far side less that of the near one.
  std::size_t reference(std::size_t axis) const { return mesh_.points.size() + 1 + axis; }
  void add_references() {
    for (std::size_t k = 0; k < 3; ++k)
      if (mesh_.periodic[k]) text_ += std::to_string(reference(k)) + ", 0., 0., 0.\n";
  }
  void add_equations() {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!mesh_.periodic[k]) continue;
      std::string label = std::string("periodic-") + char('x' + k);
      while (is_taken(label)) label += '_';
      add_list("*NSET, NSET=" + label, {reference(k)});
    }
    for (const auto& [far, near, axes] : periodic_nodes(mesh_)) {
      for (const char* const freedom : {"1", "2", "3"}) {
        std::string terms;
        const auto add = [&](std::size_t node, const char* factor) {
          terms += (terms.empty() ? "" : ", ") + std::to_string(node) + ", " + freedom + ", " + factor;
        };
        add(far + 1, "1."), add(near + 1, "-1.");
        for (std::size_t k = 0; k < 3; ++k)
          if (axes[k]) add(reference(k), "-1.");
        text_ += "*EQUATION\n" + std::to_string(2 + std::ranges::count(axes, true)) + "\n" + terms + "\n";
      }
    }
  }
  bool is_taken(const std::string& label) const {
    const auto upper = [](char c) { return std::toupper(static_cast<unsigned char>(c)); };
    return std::ranges::any_of(names_, [&](const auto& of) {
      return std::ranges::any_of(
          of, [&](const std::string& name) { return std::ranges::equal(name, label, {}, upper, upper); });
    });
  }

  void add_sets() {
    for (const auto& [key, elements] : sets_)
      add_list("*ELSET, ELSET=" + names_[key.first][key.second - 1], elements);
    for (std::size_t d = 0; d < 4; ++d) {
      const auto nodes = group_nodes(mesh_, d);
      for (std::size_t g = 0; g < nodes.size(); ++g) {
        if (!nodes[g].empty()) add_list("*NSET, NSET=" + names_[d][g], nodes[g]);
      }
    }
    const auto surfaces = plan_.sides();
    for (std::size_t g = 0; g < surfaces.size(); ++g) {
      if (surfaces[g].empty()) continue;
      text_ += "*SURFACE, TYPE=ELEMENT, NAME=" + names_[2][g] + "\n";
      for (const auto& [tetrahedron, side] : surfaces[g])
        text_ += std::to_string(tetrahedron + 1) + ", S" + std::to_string(side) + "\n";
    }
  }
};

}  // namespace

std::string abaqus_text(const Mesh& mesh) { return AbaqusWriter(mesh).run(); }

}  // namespace cnrg
