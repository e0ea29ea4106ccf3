// MEDIT's text format, as the remeshers of its family (Mmg) read it. A reference is the number of the first group;
// lines with `#` in front say their names. Edges of the result are ridges, and wires are required too, so that a
// remesher keeps them; vertices of the result are corners, and required.
//
// MEDIT and Mmg take the file word by word and pass over words that they do not know. meshio takes it line by
// line, refuses `RequiredEdges`, and passes over the line after `Identifier`: so that is where these stand. Mmg
// takes in 127 bytes of a comment, and what follows as words of the file.
#include "csg/formats/formats.h"
#include "csg/formats/group_names.h"
#include "csg/mesh/mesh.h"
#include "csg/text/digits.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;

Index reference(const Mesh::Entity& entity) { return entity.groups.empty() ? 0 : entity.groups[0]; }

/// A section of numbers, one to a line; left out when there are none.
void append_list(std::string& text, const char* name, const std::vector<std::size_t>& numbers) {
  if (numbers.empty()) return;
  text += std::string(name) + "\n" + std::to_string(numbers.size()) + "\n";
  append_lines(text, numbers.size(), [&](std::string& out, std::size_t i) { Line(out) << numbers[i] << '\n'; });
}

template <class Simplices>
void append_simplices(std::string& text, const char* name, const Simplices& simplices,
                      const std::vector<Mesh::Entity>& entities) {
  if (simplices.empty()) return;
  text += std::string(name) + "\n" + std::to_string(simplices.size()) + "\n";
  append_lines(text, simplices.size(), [&](std::string& out, std::size_t i) {
    Line line(out);
    for (const Index p : simplices[i].points) line << p + 1 << ' ';
    line << reference(entities[simplices[i].entity]) << '\n';
  });
}

}  // namespace

std::string medit_text(const Mesh& mesh) {
  std::string text = "MeshVersionFormatted 2\n";
  static constexpr const char* kKinds[] = {"vertices", "edges", "triangles", "tetrahedra"};
  for (std::size_t d = 0; d < 4; ++d) {
    // Groups of faces by their leaves are no references: they are never the first of a cell.
    const std::size_t count = mesh.groups[d].size() - (d == 2 ? mesh.sources : 0);
    for (std::size_t g = 0; g < count; ++g) {
      text +=
          "# " + std::string(kKinds[d]) + " " + std::to_string(g + 1) + " " + cut(mesh.groups[d][g], 90) + "\n";
    }
  }
  text += "Dimension 3\nVertices\n" + std::to_string(mesh.points.size()) + "\n";
  std::vector<Index> references(mesh.points.size(), 0);
  std::vector<std::size_t> corners, ridges, required;
  for (const auto& v : mesh.vertices) {
    const auto& entity = mesh.entities[0][v.entity];
    if (!entity.feature) continue;
    references[v.points[0]] = reference(entity);
    corners.push_back(v.points[0] + 1);
  }
  append_lines(text, mesh.points.size(), [&](std::string& out, std::size_t p) {
    Line(out) << mesh.points[p] << ' ' << references[p] << '\n';
  });
  std::vector<Mesh::Simplex<2>> edges;
  for (const auto& s : mesh.segments) {
    const auto& entity = mesh.entities[1][s.entity];
    if (!entity.feature) continue;
    edges.push_back(s);
    (entity.wire ? required : ridges).push_back(edges.size());
  }
  append_simplices(text, "Edges", edges, mesh.entities[1]);
  append_simplices(text, "Triangles", mesh.triangles, mesh.entities[2]);
  append_simplices(text, "Quadrilaterals", mesh.quads, mesh.entities[2]);
  append_simplices(text, "Tetrahedra", mesh.tetrahedra, mesh.entities[3]);
  append_list(text, "Corners", corners);
  append_list(text, "RequiredVertices", corners);
  append_list(text, "Ridges", ridges);
  if (!required.empty()) {
    text += "Identifier\nRequiredEdges " + std::to_string(required.size());
    for (const std::size_t edge : required) text += " " + std::to_string(edge);
    text += '\n';
  }
  return text + "End\n";
}

}  // namespace cnrg
