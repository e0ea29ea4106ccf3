// Gmsh's format 4.1 in text: entities with what bounds them, groups by name in every dimension, and by entity
// nodes and elements.
//
// Of a surface mesh Gmsh can make a mesh of its own (`gmsh -3 FILE`): every piece of an edge and every facet has
// its parametrization in the file, which is affine, and every region its boundary. A dangling face inside of a
// region is listed with the boundary of the region, and Gmsh's mesh conforms to it. The format has no place for a
// wire or a point inside of a region: they are entities with elements; to make Gmsh conform to them, merge the
// file in a script and say `Curve {..} In Volume {..};`. Tetrahedra of ours conform.
//
// Other programs read these files by meshio, which is stricter than Gmsh: either every element is in a group or
// none is, a name means one group in all dimensions, and it goes through a splitter of words in which a backslash
// may be no letter. So edges and vertices of faces are in groups of their own. Gmsh itself refuses long names.
#include <algorithm>
#include <cmath>
#include <set>

#include "csg/formats/formats.h"
#include "csg/formats/gmsh_order.h"
#include "csg/formats/group_names.h"
#include "csg/mesh/mesh.h"
#include "csg/text/escape.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"
#include "kernel/refine/box.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;
using Vector = DoubleVector;

constexpr std::size_t kLongestName = 100;  // Gmsh has room for 127 bytes

/// A name as Gmsh and meshio read it.
std::string gmsh_name(std::string_view text) {
  std::string name(text);
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name[i] == '\\' && (i + 1 == name.size() || name[i + 1] == '\\')) name[i] = '/';
  }
  return cut(name, kLongestName);
}

class MshWriter {
 public:
  explicit MshWriter(const Mesh& mesh)
      : mesh_(mesh), names_(distinct_names(mesh, {gmsh_name, kLongestName, " (", ")", true})) {
    for (const auto& names : names_) given_.insert(names.begin(), names.end());
    for (std::size_t d = 4; d-- > 0;) name_groups(d);
  }

  std::string run() {
    std::string comment = shown(mesh_.node);
    std::replace(comment.begin(), comment.end(), '$', ' ');  // it begins a section
    text_ =
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\nnode " + comment + ", written by cnrg\n$EndComments\n";
    add_names();
    find_boxes();
    add_entities();
    add_nodes();
    add_elements();
    if (mesh_.flat) add_parametrizations();
    add_fields();
    add_properties();
    return std::move(text_);
  }

 private:
  const Mesh& mesh_;
  std::string text_;
  std::array<std::vector<Box>, 4> boxes_;
  std::array<std::vector<std::string>, 4> names_;          ///< of groups
  std::array<std::vector<std::vector<Index>>, 4> groups_;  ///< of entities
  std::set<std::string> given_;

  /// A name that the groups have left over.
  std::string unused(const std::string& first) {
    std::string name = first;
    for (int n = 2; !given_.insert(name).second; ++n) name = first + " (" + std::to_string(n) + ")";
    return name;
  }

  /// The groups of the mesh, and one for cells of the result in none of these, one for what is no such cell.
  void name_groups(std::size_t d) {
    static constexpr const char* kRest[] = {"vertices", "edges", "faces", "regions"};
    std::array<Index, 2> rest{};
    for (const auto& entity : mesh_.entities[d]) {
      groups_[d].push_back(entity.groups);
      if (!entity.groups.empty()) continue;
      Index& group = rest[entity.feature];
      if (group == 0) {
        names_[d].push_back(unused(std::string(kRest[d]) + (entity.feature ? "" : " of facets")));
        group = Index(names_[d].size());
      }
      groups_[d].back().push_back(group);
    }
  }

  void add(std::int64_t number) { text_ += std::to_string(number); }

  void add_names() {
    std::size_t n = 0;
    for (const auto& names : names_) n += names.size();
    if (n == 0) return;
    text_ += "$PhysicalNames\n" + std::to_string(n) + "\n";
    for (std::size_t d = 0; d < 4; ++d) {
      for (std::size_t g = 0; g < names_[d].size(); ++g) {
        text_ += std::to_string(d) + " " + std::to_string(g + 1) + " \"" + names_[d][g] + "\"\n";
      }
    }
    text_ += "$EndPhysicalNames\n";
  }

  template <class Simplices, class Edges>
  void extend(std::size_t dimension, const Simplices& simplices, const Edges& edges) {
    for (const auto& s : simplices) {
      for (const Index p : mesh_.nodes(s, edges))
        boxes_[dimension][s.entity].extend(mesh_.points[p], mesh_.points[p]);
    }
  }
  /// The box of each entity; that of a region is the box of what bounds it.
  void find_boxes() {
    for (std::size_t d = 0; d < 4; ++d) boxes_[d].resize(mesh_.entities[d].size());
    extend(0, mesh_.vertices, kEdges0);
    extend(1, mesh_.segments, kEdges1);
    extend(2, mesh_.triangles, kEdges2);
    extend(2, mesh_.quads, kEdges0);
    for (std::size_t i = 0; i < boxes_[3].size(); ++i) {
      for (const std::int32_t b : mesh_.entities[3][i].boundary)
        boxes_[3][i].extend(boxes_[2][std::size_t(std::abs(b)) - 1]);
    }
  }

  void add_entities() {
    text_ += "$Entities\n";
    for (std::size_t d = 0; d < 4; ++d) text_ += (d == 0 ? "" : " ") + std::to_string(mesh_.entities[d].size());
    text_ += '\n';
    for (std::size_t d = 0; d < 4; ++d) {
      for (std::size_t i = 0; i < mesh_.entities[d].size(); ++i) {
        const auto& entity = mesh_.entities[d][i];
        add(std::int64_t(i + 1));
        text_ += ' ';
        append(text_, boxes_[d][i].lo);
        if (d > 0) {
          text_ += ' ';
          append(text_, boxes_[d][i].hi);
        }
        const std::vector<Index>& groups = groups_[d][i];
        text_ += ' ' + std::to_string(groups.size()) + ' ';
        for (const Index g : groups) text_ += std::to_string(g) + ' ';
        if (d > 0) {
          text_ += std::to_string(entity.boundary.size()) + ' ';
          for (const std::int32_t b : entity.boundary) text_ += std::to_string(b) + ' ';
        }
        text_ += '\n';
      }
    }
    text_ += "$EndEntities\n";
  }

  /// A node belongs to the entity of least dimension that has it.
  void add_nodes() {
    struct Place {
      std::uint32_t dimension = 4, entity = 0, point = 0;
      auto operator<=>(const Place&) const = default;
    };
    std::vector<Place> places(mesh_.points.size());
    for (Index p = 0; p < places.size(); ++p) places[p].point = p;
    const auto claim = [&](std::uint32_t d, const auto& simplices, const auto& edges) {
      for (const auto& s : simplices)
        for (const Index p : mesh_.nodes(s, edges)) {
          if (places[p].dimension != d) places[p] = {d, s.entity, p};
        }
    };
    claim(3, mesh_.tetrahedra, kEdges3);
    claim(2, mesh_.triangles, kEdges2);
    claim(2, mesh_.quads, kEdges0);
    claim(1, mesh_.segments, kEdges1);
    claim(0, mesh_.vertices, kEdges0);
    std::sort(places.begin(), places.end());
    std::size_t blocks = 0;
    const auto same = [&](std::size_t i, std::size_t j) {
      return places[i].dimension == places[j].dimension && places[i].entity == places[j].entity;
    };
    for (std::size_t i = 0; i < places.size(); ++i) blocks += i == 0 || !same(i, i - 1);
    const std::string n = std::to_string(places.size());
    text_ += "$Nodes\n" + std::to_string(blocks) + " " + n + (places.empty() ? " 0 " : " 1 ") + n + "\n";
    for (std::size_t i = 0, end = 0; i < places.size(); i = end) {
      while (end < places.size() && same(i, end)) ++end;
      text_ += std::to_string(places[i].dimension) + " " + std::to_string(places[i].entity + 1) + " 0 " +
               std::to_string(end - i) + "\n";
      for (std::size_t k = i; k < end; ++k) text_ += std::to_string(places[k].point + 1) + "\n";
      for (std::size_t k = i; k < end; ++k) {
        append(text_, mesh_.points[places[k].point]);
        text_ += '\n';
      }
    }
    text_ += "$EndNodes\n";
  }

  template <class Simplices>
  static std::size_t blocks_of(const Simplices& simplices) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < simplices.size(); ++i) {
      n += i == 0 || simplices[i].entity != simplices[i - 1].entity;
    }
    return n;
  }
  template <class Simplices, class Edges>
  void add_blocks(int dimension, int type, const Simplices& simplices, const Edges& edges, std::size_t& number) {
    for (std::size_t i = 0, end = 0; i < simplices.size(); i = end) {
      while (end < simplices.size() && simplices[end].entity == simplices[i].entity) ++end;
      text_ += std::to_string(dimension) + " " + std::to_string(simplices[i].entity + 1) + " " +
               std::to_string(type) + " " + std::to_string(end - i) + "\n";
      for (std::size_t k = i; k < end; ++k) {
        text_ += std::to_string(++number);
        for (const Index p : mesh_.nodes(simplices[k], edges)) text_ += " " + std::to_string(p + 1);
        text_ += '\n';
      }
    }
  }
  std::size_t count() const {
    return mesh_.vertices.size() + mesh_.segments.size() + mesh_.triangles.size() + mesh_.quads.size() +
           mesh_.tetrahedra.size();
  }
  void add_elements() {
    const std::size_t blocks = blocks_of(mesh_.vertices) + blocks_of(mesh_.segments) + blocks_of(mesh_.triangles) +
                               blocks_of(mesh_.quads) + blocks_of(mesh_.tetrahedra);
    const std::size_t n = count();
    text_ += "$Elements\n" + std::to_string(blocks) + " " + std::to_string(n) + (n == 0 ? " 0 " : " 1 ") +
             std::to_string(n) + "\n";
    std::size_t number = 0;
    const bool straight = mesh_.middles.empty();
    add_blocks(0, 15, mesh_.vertices, kEdges0, number);
    add_blocks(1, straight ? 1 : 8, mesh_.segments, kEdges1, number);
    add_blocks(2, straight ? 2 : 9, mesh_.triangles, kEdges2, number);
    add_blocks(2, 3, mesh_.quads, kEdges0, number);
    add_blocks(3, straight ? 4 : 11, mesh_.tetrahedra, kEdges3, number);
    text_ += "$EndElements\n";
  }

  /// Discontinuous fields, by element and node. Tetrahedra are the last elements.
  void add_fields() {
    const std::size_t before = count() - mesh_.tetrahedra.size();
    for (const Mesh::Field& field : mesh_.fields) {
      text_ += "$ElementNodeData\n1\n\"" + shown_in_quotes(field.name) + "\"\n1\n0\n3\n0\n1\n" +
               std::to_string(mesh_.tetrahedra.size()) + "\n";
      for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
        std::vector<double> values(field.values.begin() + static_cast<std::ptrdiff_t>(4 * t),
                                   field.values.begin() + static_cast<std::ptrdiff_t>(4 * t + 4));
        if (!mesh_.middles.empty()) {
          for (const auto& [i, j] : kEdges3) values.push_back((values[i] + values[j]) / 2);
        }
        text_ += std::to_string(before + t + 1) + " " + std::to_string(values.size());
        for (const double value : values) {
          text_ += ' ';
          append(text_, value);
        }
        text_ += '\n';
      }
      text_ += "$EndElementNodeData\n";
    }
  }

  /// A number for each element, not a number where nothing is said: meshio wants one for all or for none.
  void add_properties() {
    const std::size_t n = count();
    for (const Mesh::Property& property : mesh_.properties) {
      text_ += "$ElementData\n1\n\"" + unused(gmsh_name(shown_in_quotes(property.key))) + "\"\n1\n0\n3\n0\n1\n" +
               std::to_string(n) + "\n";
      std::size_t number = 0;
      const auto add_all = [&](std::size_t dimension, const auto& simplices) {
        for (const auto& s : simplices) {
          const double value = property.values[dimension][s.entity];
          text_ += std::to_string(++number) + ' ';
          if (std::isnan(value)) text_ += "nan";
          else append(text_, value);
          text_ += '\n';
        }
      };
      add_all(0, mesh_.vertices), add_all(1, mesh_.segments);
      add_all(2, mesh_.triangles), add_all(2, mesh_.quads);
      add_all(3, mesh_.tetrahedra);
      text_ += "$EndElementData\n";
    }
  }

  /// A piece of an edge runs from 0 to 1; a facet has two coordinates in its plane, in the unit of the model.
  void add_parametrizations() {
    text_ += "$Parametrizations\n" + std::to_string(mesh_.segments.size()) + " " +
             std::to_string(mesh_.entities[2].size()) + "\n";
    for (const auto& s : mesh_.segments) {
      text_ += std::to_string(s.entity + 1) + "\n2\n";
      append(text_, mesh_.points[s.points[0]]);
      text_ += " 0\n";
      append(text_, mesh_.points[s.points[1]]);
      text_ += " 1\n";
    }
    for (std::size_t i = 0, end = 0; i < mesh_.triangles.size(); i = end) {
      while (end < mesh_.triangles.size() && mesh_.triangles[end].entity == mesh_.triangles[i].entity) ++end;
      add_facet(i, end);
    }
    text_ += "$EndParametrizations\n";
  }

  void add_facet(std::size_t begin, std::size_t end) {
    std::vector<Index> points;
    Vector normal{}, along{};
    double most = -1;
    for (std::size_t t = begin; t < end; ++t) {
      const auto& corners = mesh_.triangles[t].points;
      points.insert(points.end(), corners.begin(), corners.end());
      const Vector &a = mesh_.points[corners[0]], &b = mesh_.points[corners[1]], &c = mesh_.points[corners[2]];
      const Vector n = cross(minus(b, a), minus(c, a));
      if (dot(n, n) <= most) continue;
      most = dot(n, n);
      normal = n;
      along = minus(b, a);
    }
    sort_unique(points);
    // Rounding may have laid all triangles on a line or a point.
    const auto direction = [](const Vector& x) { return dot(x, x) > 0 ? unit(x) : Vector{}; };
    const Vector u = direction(along), v = cross(direction(normal), u), origin = mesh_.points[points[0]];
    text_ += std::to_string(mesh_.triangles[begin].entity + 1) + "\n" + std::to_string(points.size()) + " " +
             std::to_string(end - begin) + "\n";
    for (const Index p : points) {
      append(text_, mesh_.points[p]);
      const Vector d = minus(mesh_.points[p], origin);
      for (const double coordinate : {dot(d, u), dot(d, v)}) {
        text_ += ' ';
        append(text_, coordinate);
      }
      text_ += " 0 0 0 0 0 0\n";
    }
    for (std::size_t t = begin; t < end; ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto place = std::lower_bound(points.begin(), points.end(), mesh_.triangles[t].points[k]);
        text_ += std::to_string(place - points.begin()) + (k < 2 ? ' ' : '\n');
      }
    }
  }
};

}  // namespace

std::string msh_text(const Mesh& mesh) { return MshWriter(mesh).run(); }

}  // namespace cnrg
