// XDMF: one uniform grid with its numbers in the XML itself, so that there is no second file.
//
// FEniCS reads simplices of one dimension from a grid, and marks on faces from another one on the same points;
// meshio takes one grid from a file. So a file holds one dimension, which its name says: NAME.xdmf the highest
// that the mesh has, NAME.faces.xdmf, NAME.edges.xdmf and NAME.points.xdmf the others, each if it is asked for.
// All number points alike: first those of tetrahedra, then those of triangles that no tetrahedron has, and so on.
// A file ends with the points of its own simplices, since FEniCS takes no point that is in no cell.
//
// `group` is the number of the first group of each simplex. FEniCS knows no names; `Information` has them as
// meshio writes and reads them. A group that is not everywhere the first has an array of its own, 1 where a
// simplex is in it. The numbers of a simplex are VTK's.
#include <algorithm>
#include <cmath>
#include <optional>

#include "csg/formats/formats.h"
#include "csg/formats/mesh_file.h"
#include "csg/mesh/mesh.h"
#include "csg/mesh/second_order.h"
#include "csg/text/digits.h"
#include "csg/text/file.h"
#include "csg/text/table.h"
#include "csg/text/xml.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;

constexpr const char* kWords[] = {".points", ".edges", ".faces", ""};

class XdmfWriter {
 public:
  XdmfWriter(const Mesh& mesh, std::size_t dimension) : mesh_(mesh), dimension_(dimension) {
    numbers_.assign(mesh.points.size(), kNone);
    number_points(mesh.tetrahedra, kSecondOrderEdges);
    if (dimension < 3) number_points(mesh.triangles, kSecondOrderTriangle);
    if (dimension < 3) number_points(mesh.quads, kSecondOrderPoint);
    if (dimension < 2) number_points(mesh.segments, kSecondOrderLine);
    if (dimension < 1) number_points(mesh.vertices, kSecondOrderPoint);
  }

  std::string run() {
    text_ =
        "<?xml version=\"1.0\"?>\n<!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
        "<Grid Name=\"Grid\" GridType=\"Uniform\">\n";
    add_geometry();
    switch (dimension_) {
      case 0: add_simplices("Polyvertex", mesh_.vertices, kSecondOrderPoint); break;
      case 1: add_simplices(straight() ? "Polyline" : "Edge_3", mesh_.segments, kSecondOrderLine); break;
      case 2:
        if (!mesh_.quads.empty()) add_mixed_faces();
        else add_simplices(straight() ? "Triangle" : "Triangle_6", mesh_.triangles, kSecondOrderTriangle);
        break;
      default: add_simplices(straight() ? "Tetrahedron" : "Tetrahedron_10", mesh_.tetrahedra, kSecondOrderEdges);
    }
    add_groups();
    for (const Mesh::Property& property : mesh_.properties) add_property(property);
    text_ += "</Grid>\n</Domain>\n</Xdmf>\n";
    return std::move(text_);
  }

 private:
  const Mesh& mesh_;
  const std::size_t dimension_;
  std::string text_;
  std::vector<Index> entities_;  ///< of each simplex
  static constexpr Index kNone = 0xffffffff;
  std::vector<Index> numbers_;  ///< in the file, of each point of the mesh
  std::vector<Index> points_;   ///< of the file: numbers in the mesh

  /// Those of these simplices that have no number yet, in the order of the mesh.
  template <class Simplices, class Ends>
  void number_points(const Simplices& simplices, const Ends& ends) {
    std::vector<Index> fresh;
    for (const auto& s : simplices) {
      for (const Index p : mesh_.nodes(s, ends)) {
        if (numbers_[p] == kNone) fresh.push_back(p);
      }
    }
    sort_unique(fresh);
    for (const Index p : fresh) {
      numbers_[p] = Index(points_.size());
      points_.push_back(p);
    }
  }

  bool straight() const { return mesh_.middles.empty(); }

  void begin_item(const std::string& type, const std::string& dimensions) {
    text_ +=
        "<DataItem DataType=\"" + type + "\" Dimensions=\"" + dimensions + "\" Format=\"XML\" Precision=\"8\">\n";
  }
  void end_item() { text_ += "</DataItem>\n"; }

  void add_geometry() {
    text_ += "<Geometry GeometryType=\"XYZ\">\n";
    begin_item("Float", std::to_string(points_.size()) + " 3");
    append_lines(text_, points_.size(),
                 [&](std::string& out, std::size_t i) { Line(out) << mesh_.points[points_[i]] << '\n'; });
    end_item();
    text_ += "</Geometry>\n";
  }

  template <class Simplices, class Ends>
  void add_simplices(const std::string& type, const Simplices& simplices, const Ends& ends) {
    const std::size_t corners = std::tuple_size_v<decltype(simplices[0].points)>;
    const std::size_t nodes = corners + (straight() ? 0 : ends.size());
    text_ += "<Topology TopologyType=\"" + type + "\" NumberOfElements=\"" + std::to_string(simplices.size()) +
             "\" NodesPerElement=\"" + std::to_string(nodes) + "\">\n";
    begin_item("Int", std::to_string(simplices.size()) + " " + std::to_string(nodes));
    for (const auto& s : simplices) {
      entities_.push_back(s.entity);
      const char* between = "";
      for (const Index p : mesh_.nodes(s, ends)) {
        text_ += between + std::to_string(numbers_[p]);
        between = " ";
      }
      text_ += '\n';
    }
    end_item();
    text_ += "</Topology>\n";
  }

  /// Triangles and quadrilaterals, each behind the number of its kind.
  void add_mixed_faces() {
    const auto add = [&](const auto& elements, const char* kind) {
      for (const auto& e : elements) {
        entities_.push_back(e.entity);
        text_ += kind;
        for (const Index p : e.points) text_ += " " + std::to_string(numbers_[p]);
        text_ += '\n';
      }
    };
    text_ += "<Topology TopologyType=\"Mixed\" NumberOfElements=\"" +
             std::to_string(mesh_.triangles.size() + mesh_.quads.size()) + "\">\n";
    begin_item("Int", std::to_string(4 * mesh_.triangles.size() + 5 * mesh_.quads.size()));
    add(mesh_.triangles, "4");
    add(mesh_.quads, "5");
    end_item();
    text_ += "</Topology>\n";
  }

  template <class Value>
  void add_array(const std::string& name, const std::string& type, const Value& value) {
    text_ += "<Attribute Name=\"" + name + "\" AttributeType=\"Scalar\" Center=\"Cell\">\n";
    begin_item(type, std::to_string(entities_.size()));
    for (const Index entity : entities_) {
      value(mesh_.entities[dimension_][entity]);
      text_ += '\n';
    }
    end_item();
    text_ += "</Attribute>\n";
  }

  static std::string array_name(const std::string& name) { return name == "group" ? "group'" : in_xml(name); }

  void add_groups() {
    const std::vector<std::string>& names = mesh_.groups[dimension_];
    if (!names.empty()) {
      text_ += "<Information Name=\"groups\" Value=\"" + std::to_string(names.size()) + "\"><![CDATA[<main>";
      for (std::size_t g = 0; g < names.size(); ++g) {
        text_ += "<map key=\"" + in_xml(names[g]) + "\" dim=\"" + std::to_string(dimension_) + "\">" +
                 std::to_string(g + 1) + "</map>";
      }
      text_ += "</main>]]></Information>\n";
    }
    add_array("group", "Int", [&](const Mesh::Entity& entity) {
      text_ += std::to_string(entity.groups.empty() ? 0 : entity.groups[0]);
    });
    std::vector<char> further(names.size() + 1, 0);
    for (const Mesh::Entity& entity : mesh_.entities[dimension_]) {
      for (std::size_t k = 1; k < entity.groups.size(); ++k) further[entity.groups[k]] = 1;
    }
    for (Index g = 1; g <= names.size(); ++g) {
      if (!further[g]) continue;
      add_array(array_name(names[g - 1]), "Int", [&](const Mesh::Entity& entity) {
        text_ += std::find(entity.groups.begin(), entity.groups.end(), g) != entity.groups.end() ? '1' : '0';
      });
    }
  }

  void add_property(const Mesh::Property& property) {
    const std::vector<double>& values = property.values[dimension_];
    add_array(array_name(property.key), "Float", [&](const Mesh::Entity& entity) {
      const double value = values[static_cast<std::size_t>(&entity - mesh_.entities[dimension_].data())];
      if (std::isnan(value)) text_ += "nan";
      else Line(text_) << value;
    });
  }
};

using Counts = std::array<std::size_t, 4>;
Counts counts_of(const Mesh& mesh) {
  return {mesh.vertices.size(), mesh.segments.size(), mesh.triangles.size() + mesh.quads.size(),
          mesh.tetrahedra.size()};
}
std::size_t highest(const Counts& counts) {
  std::size_t dimension = 3;
  while (dimension > 0 && counts[dimension] == 0) --dimension;
  return dimension;
}

/// By the name of a file, if that says one.
std::optional<std::size_t> dimension_said(const std::string& path) {
  const std::string before = extension_of(path.substr(0, path.size() - extension_of(path).size()));
  for (std::size_t d = 0; d < 3; ++d)
    if (before == kWords[d]) return d;
  return {};
}

}  // namespace

std::vector<FurtherFile> further_files(const std::string& path, const Mesh& mesh) {
  const std::string extension = extension_of(path), name = path.substr(0, path.size() - extension.size());
  if (extension != ".xdmf" || dimension_said(path)) return {};
  const Counts counts = counts_of(mesh);
  std::vector<FurtherFile> out;
  for (std::size_t d = highest(counts); d-- > 0;) {
    if (counts[d] == 0) continue;
    const std::string one = d == 0 ? "point" : d == 1 ? "segment" : mesh.quads.empty() ? "triangle" : "face";
    out.push_back({name + kWords[d] + extension, counted(counts[d], one, one + "s")});
  }
  return out;
}

std::string xdmf_text(const std::string& path, const Mesh& mesh) {
  const Counts counts = counts_of(mesh);
  const std::size_t dimension = dimension_said(path).value_or(highest(counts));
  if (counts[dimension] == 0) {
    throw InputError(std::string("the mesh has no ") +
                     (dimension == 0   ? "points of its own"
                      : dimension == 1 ? "edges"
                                       : "faces") +
                     " for a grid of them; leave this file out");
  }
  return XdmfWriter(mesh, dimension).run();
}

}  // namespace cnrg
