// Gmsh's format 4.1 in text: entities with what bounds them, groups by name in every dimension, and by entity
// nodes and elements. Format 2.2 has nodes and elements alone, each element with its first group.
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
#include <span>

#include "csg/formats/formats.h"
#include "csg/formats/group_names.h"
#include "csg/mesh/periodic.h"
#include "csg/text/digits.h"
#include "csg/text/escape.h"
#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;
using Vector = DoubleVector;
/// Around an entity: by axis a point that is least there, and one that is greatest.
using Extent = std::array<std::array<Index, 3>, 2>;
constexpr Extent kNowhere{{{kNone, kNone, kNone}, {kNone, kNone, kNone}}};

constexpr std::size_t kLongestName = 100;  // Gmsh has room for 127 bytes

/// A name as Gmsh and meshio read it.
std::string gmsh_name(std::string_view text) {
  std::string name(text);
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name[i] == '\\' && (i + 1 == name.size() || name[i + 1] == '\\')) name[i] = '/';
  }
  return cut(name, kLongestName);
}

enum class Version : std::uint8_t { two, four };

class MshWriter {
 public:
  MshWriter(const Mesh& mesh, Version version)
      : one_group_(version == Version::two || mesh.one_group),
        version_(version),
        mesh_(mesh),
        texts_(mesh.points),
        names_(distinct_names(mesh, {gmsh_name, kLongestName, " (", ")", true})) {
    for (const auto& names : names_) given_.insert(names.begin(), names.end());
    for (std::size_t d = 4; d-- > 0;) name_groups(d);
  }

  std::string run() {
    std::string comment = shown(mesh_.node);
    std::replace(comment.begin(), comment.end(), '$', ' ');  // it begins a section
    constexpr std::size_t kElement = 256;                    // bytes; what is not needed is not touched
    text_.reserve(kElement * (mesh_.vertices.size() + mesh_.segments.size() + mesh_.triangles.size()));
    text_ += "$MeshFormat\n" + std::string(version_ == Version::two ? "2.2" : "4.1") +
             " 0 8\n$EndMeshFormat\n$Comments\nnode " + comment + ", written by cnrg\n$EndComments\n";
    add_names();
    if (version_ == Version::two) {
      add_mere_nodes();
    } else {
      find_boxes();
      add_entities();
      add_nodes();
    }
    add_elements();
    add_links();
    if (mesh_.flat && version_ == Version::four) add_parametrizations();
    add_twins();
    add_fields();
    add_properties();
    return std::move(text_);
  }

 private:
  const bool one_group_;
  const Version version_;
  const Mesh& mesh_;
  std::string text_;
  const PointTexts texts_;
  std::array<std::vector<Extent>, 4> boxes_;
  std::array<std::vector<std::string>, 4> names_;  ///< of groups
  std::array<std::array<Index, 2>, 4> rest_{};     ///< groups of cells in none, by `feature`
  std::set<std::string> given_;
  std::size_t elements_ = 0;

  /// A name that the groups have left over.
  std::string unused(const std::string& first) {
    std::string name = first;
    for (int n = 2; !given_.insert(name).second; ++n) name = first + " (" + std::to_string(n) + ")";
    return name;
  }

  /// The groups of the mesh, and one for cells of the result in none of these, one for what is no such cell.
  void name_groups(std::size_t d) {
    static constexpr const char* kRest[] = {"vertices", "edges", "faces", "regions"};
    for (const auto& entity : mesh_.entities[d]) {
      if (!entity.groups.empty()) continue;
      Index& group = rest_[d][entity.feature];
      if (group != 0) continue;
      names_[d].push_back(unused(std::string(kRest[d]) + (entity.feature ? "" : " of facets")));
      group = Index(names_[d].size());
    }
  }
  std::span<const Index> groups(std::size_t d, std::size_t entity) const {
    const Mesh::Entity& of = mesh_.entities[d][entity];
    if (of.groups.empty()) return {&rest_[d][of.feature], 1};
    return {of.groups.begin(), one_group_ ? 1 : of.groups.size()};
  }

  void add_names() {
    std::size_t n = 0;
    std::string lines;
    for (std::size_t d = 0; d < 4; ++d) {
      std::vector<char> used(names_[d].size(), !one_group_);
      for (std::size_t i = 0; one_group_ && i < mesh_.entities[d].size(); ++i) used[groups(d, i)[0] - 1] = 1;
      for (std::size_t g = 0; g < names_[d].size(); ++g) {
        if (!used[g]) continue;
        Line(lines) << d << ' ' << g + 1 << " \"" << names_[d][g] << "\"\n";
        ++n;
      }
    }
    if (n > 0) text_ += "$PhysicalNames\n" + std::to_string(n) + "\n" + lines + "$EndPhysicalNames\n";
  }

  /// Of the points of lists of indices, `low` and `high` ones.
  void extend(Extent& box, const std::array<Index, 3>& low, const std::array<Index, 3>& high) const {
    for (std::size_t k = 0; k < 3; ++k) {
      Index &lo = box[0][k], &hi = box[1][k];
      if (lo == kNone || mesh_.points[low[k]][k] < mesh_.points[lo][k]) lo = low[k];
      if (hi == kNone || mesh_.points[high[k]][k] > mesh_.points[hi][k]) hi = high[k];
    }
  }
  /// The box of each entity; that of a region is the box of what bounds it.
  void find_boxes() {
    for (std::size_t d = 0; d < 4; ++d) boxes_[d].assign(mesh_.entities[d].size(), kNowhere);
    mesh_.for_each_kind([&](std::size_t, std::size_t d, const auto& simplices, const auto& edges) {
      for (std::size_t i = 0; d < 3 && i < simplices.size(); ++i) {
        Extent& box = boxes_[d][simplices[i].entity];
        mesh_.for_each_node(simplices[i], edges, [&](Index p) { extend(box, {p, p, p}, {p, p, p}); });
      }
    });
    for (std::size_t i = 0; i < boxes_[3].size(); ++i) {
      for (const std::int32_t b : mesh_.entities[3][i].boundary) {
        const auto& [low, high] = boxes_[2][std::size_t(std::abs(b)) - 1];
        extend(boxes_[3][i], low, high);
      }
    }
  }

  void add_entities() {
    text_ += "$Entities\n";
    for (std::size_t d = 0; d < 4; ++d) text_ += (d == 0 ? "" : " ") + std::to_string(mesh_.entities[d].size());
    text_ += '\n';
    for (std::size_t d = 0; d < 4; ++d) {
      append_lines(text_, mesh_.entities[d].size(), [&](std::string& out, std::size_t i) {
        Line line(out);
        line << i + 1;
        for (std::size_t end = 0; end < (d == 0 ? 1 : 2); ++end) {
          for (std::size_t k = 0; k < 3; ++k) {
            require(boxes_[d][i][end][k] != kNone, "msh: an entity without an element");
            line << ' ' << texts_.coordinate(boxes_[d][i][end][k], k);
          }
        }
        const auto add = [&](const auto& numbers) {
          line << ' ' << numbers.size();
          for (const auto n : numbers) line << ' ' << n;
        };
        add(groups(d, i));
        if (d > 0) add(mesh_.entities[d][i].boundary);
        line << " \n";
      });
    }
    text_ += "$EndEntities\n";
  }

  /// Of version 2.2, which has no entities.
  void add_mere_nodes() {
    text_ += "$Nodes\n" + std::to_string(mesh_.points.size()) + "\n";
    append_lines(text_, mesh_.points.size(),
                 [&](std::string& out, std::size_t p) { Line(out) << p + 1 << ' ' << texts_[p] << '\n'; });
    text_ += "$EndNodes\n";
  }

  /// A node belongs to the entity of least dimension that has it.
  void add_nodes() {
    struct Place {
      std::uint32_t dimension = 4, entity = 0, point = 0;
      auto operator<=>(const Place&) const = default;
    };
    std::vector<Place> places(mesh_.points.size());
    for (Index p = 0; p < places.size(); ++p) places[p].point = p;
    mesh_.for_each_kind([&](std::size_t, std::size_t d, const auto& simplices, const auto& edges) {
      for (const auto& s : simplices) {
        mesh_.for_each_node(s, edges, [&](Index p) {
          if (places[p].dimension == 4) places[p] = {std::uint32_t(d), s.entity, p};
        });
      }
    });
    std::sort(places.begin(), places.end());
    std::size_t blocks = 0;
    const auto same = [&](std::size_t i, std::size_t j) {
      return places[i].dimension == places[j].dimension && places[i].entity == places[j].entity;
    };
    for (std::size_t i = 0; i < places.size(); ++i) blocks += i == 0 || !same(i, i - 1);
    const std::string n = std::to_string(places.size());
    text_ += "$Nodes\n" + std::to_string(blocks) + " " + n + (places.empty() ? " 0 " : " 1 ") + n + "\n";
    append_lines(text_, places.size(), [&](std::string& out, std::size_t i) {
      Line line(out);
      if (i == 0 || !same(i, i - 1)) {
        std::size_t end = i;
        while (end < places.size() && same(i, end)) ++end;
        line << places[i].dimension << ' ' << places[i].entity + 1 << " 0 " << end - i << '\n';
        for (std::size_t k = i; k < end; ++k) line << places[k].point + 1 << '\n';
      }
      line << texts_[places[i].point] << '\n';
    });
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
  void add_blocks(std::size_t dimension, int type, const Simplices& simplices, const Edges& edges,
                  std::size_t& number) {
    append_lines(text_, simplices.size(), [&](std::string& out, std::size_t i) {
      Line line(out);
      const Index entity = simplices[i].entity;
      const bool first = i == 0 || simplices[i - 1].entity != entity;
      if (first && version_ == Version::four) {
        std::size_t end = i;
        while (end < simplices.size() && simplices[end].entity == entity) ++end;
        line << dimension << ' ' << entity + 1 << ' ' << type << ' ' << end - i << '\n';
      }
      line << number + i + 1;
      if (version_ == Version::two)
        line << ' ' << type << " 2 " << groups(dimension, entity)[0] << ' ' << entity + 1;
      mesh_.for_each_node(simplices[i], edges, [&](Index p) { line << ' ' << p + 1; });
      line << '\n';
    });
    number += simplices.size();
  }
  void add_elements() {
    std::size_t blocks = 0, number = 0;
    mesh_.for_each_kind([&](std::size_t, std::size_t, const auto& simplices, const auto&) {
      blocks += blocks_of(simplices), elements_ += simplices.size();
    });
    text_ += "$Elements\n";
    if (version_ == Version::two) Line(text_) << elements_ << '\n';
    else Line(text_) << blocks << ' ' << elements_ << (elements_ == 0 ? " 0 " : " 1 ") << elements_ << '\n';
    static constexpr std::array<int, 6> kFirstOrder{15, 1, 2, 3, 4, 6}, kSecondOrder{15, 8, 9, 3, 11, 6};
    const auto& types = mesh_.middles.empty() ? kFirstOrder : kSecondOrder;
    mesh_.for_each_kind([&](std::size_t kind, std::size_t dimension, const auto& simplices,
                            const auto& edges) { add_blocks(dimension, types[kind], simplices, edges, number); },
                        kGmshEdges);
    text_ += "$EndElements\n";
  }

  /// Of a mesh that repeats: pairs of entities and of their nodes, with the affine map from the second to the
  /// first.
  void add_links() {
    const std::vector<PeriodicLink> links = periodic_links(mesh_);
    if (links.empty()) return;
    text_ += "$Periodic\n" + std::to_string(links.size()) + "\n";
    for (const PeriodicLink& link : links) {
      Line line(text_);
      line << link.dimension << ' ' << link.far + 1 << ' ' << link.near + 1
           << (version_ == Version::two ? "\nAffine" : "\n16");
      for (std::size_t k = 0; k < 16; ++k) line << ' ' << (k % 5 == 0 ? 1 : k % 4 == 3 ? link.shift[k / 4] : 0);
      line << '\n' << link.nodes.size() << '\n';
      for (const auto& [far, near] : link.nodes) line << far + 1 << ' ' << near + 1 << '\n';
    }
    text_ += "$EndPeriodic\n";
  }

  /// Of a split mesh; meshio reads data of all nodes only.
  void add_twins() {
    if (mesh_.twins.empty()) return;
    text_ += "$NodeData\n1\n\"twin\"\n1\n0\n3\n0\n1\n" + std::to_string(mesh_.twins.size()) + "\n";
    append_lines(text_, mesh_.twins.size(), [&](std::string& out, std::size_t p) {
      Line(out) << p + 1 << ' ' << mesh_.twins[p] + 1 << '\n';
    });
    text_ += "$EndNodeData\n";
  }

  /// Discontinuous fields, by element and node. A mesh of tetrahedra has no quadrilaterals.
  void add_fields() {
    const std::size_t before = mesh_.vertices.size() + mesh_.segments.size() + mesh_.triangles.size();
    for (const Mesh::Field& field : mesh_.fields) {
      text_ += "$ElementNodeData\n1\n\"" + shown_in_quotes(field.name) + "\"\n1\n0\n3\n0\n1\n" +
               std::to_string(mesh_.tetrahedra.size()) + "\n";
      for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
        std::vector<double> values(field.values.begin() + static_cast<std::ptrdiff_t>(4 * t),
                                   field.values.begin() + static_cast<std::ptrdiff_t>(4 * t + 4));
        if (!mesh_.middles.empty()) {
          for (const auto& [i, j] : kGmshEdges) values.push_back((values[i] + values[j]) / 2);
        }
        Line line(text_);
        line << before + t + 1 << ' ' << values.size();
        for (const double value : values) line << ' ' << value;
        line << '\n';
      }
      text_ += "$EndElementNodeData\n";
    }
  }

  /// A number for each element, not a number where nothing is said: meshio wants one for all or for none.
  void add_properties() {
    for (const Mesh::Property& property : mesh_.properties) {
      text_ += "$ElementData\n1\n\"" + unused(gmsh_name(shown_in_quotes(property.key))) + "\"\n1\n0\n3\n0\n1\n" +
               std::to_string(elements_) + "\n";
      std::size_t number = 0;
      mesh_.for_each_kind([&](std::size_t, std::size_t dimension, const auto& simplices, const auto&) {
        for (const auto& s : simplices) {
          const double value = property.values[dimension][s.entity];
          Line line(text_);
          line << ++number << ' ';
          if (std::isnan(value)) line << "nan\n";
          else line << value << '\n';
        }
      });
      text_ += "$EndElementData\n";
    }
  }

  /// A piece of an edge runs from 0 to 1; a facet has two coordinates in its plane, in the unit of the model.
  void add_parametrizations() {
    text_ += "$Parametrizations\n" + std::to_string(mesh_.segments.size()) + " " +
             std::to_string(mesh_.entities[2].size()) + "\n";
    append_lines(text_, mesh_.segments.size(), [&](std::string& out, std::size_t i) {
      const auto& s = mesh_.segments[i];
      Line(out) << s.entity + 1 << "\n2\n" << texts_[s.points[0]] << " 0\n" << texts_[s.points[1]] << " 1\n";
    });
    append_lines(text_, mesh_.triangles.size(), [&](std::string& out, std::size_t i) {
      const Index entity = mesh_.triangles[i].entity;
      if (i > 0 && mesh_.triangles[i - 1].entity == entity) return;
      std::size_t end = i;
      while (end < mesh_.triangles.size() && mesh_.triangles[end].entity == entity) ++end;
      add_facet(out, i, end);
    });
    text_ += "$EndParametrizations\n";
  }

  void add_facet(std::string& out, std::size_t begin, std::size_t end) const {
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
    Line line(out);
    line << mesh_.triangles[begin].entity + 1 << '\n' << points.size() << ' ' << end - begin << '\n';
    for (const Index p : points) {
      const Vector d = minus(mesh_.points[p], origin);
      line << texts_[p] << ' ' << dot(d, u) << ' ' << dot(d, v) << " 0 0 0 0 0 0\n";
    }
    for (std::size_t t = begin; t < end; ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto place = std::lower_bound(points.begin(), points.end(), mesh_.triangles[t].points[k]);
        line << place - points.begin() << (k < 2 ? ' ' : '\n');
      }
    }
  }
};

}  // namespace

std::string msh_text(const Mesh& mesh) { return MshWriter(mesh, Version::four).run(); }
std::string msh2_text(const Mesh& mesh) { return MshWriter(mesh, Version::two).run(); }

}  // namespace cnrg
