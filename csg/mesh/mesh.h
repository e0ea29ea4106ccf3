// A mesh of simplices that knows which cell of the result each simplex lies in: what writers for meshers write.
//
// Two meshes of a result:
//   the surface mesh    triangles, segments and points; the solid regions are there as entities without
//                       tetrahedra, so that a mesher can fill them. Its entities are flat: a face on one plane is
//                       one, a face of a curved patch is one for each facet, an edge is one for each straight
//                       piece. A face with a slit or a point in its interior is one for each triangle, so that
//                       these are on borders.
//   tetrahedra          as tetrahedra.h has it; its entities are the cells of the simplified result.
//
// Groups are what people call the entities: first by their names, then by what they are, then by material and by
// each property that has a text. In dimension 3 a region by its name; in dimension 2 a sheet by the name that
// somebody gave it, `boundary of rock`, `wall rock | ore`, `face of fault` (dangling, without a name); wires and
// free points by their name, or else by their leaf. Then `material steel`, `section round`. Faces come once more
// by the leaves that they came from, `from fault`, whatever they part. Names are distinct within a dimension; a
// format that has one group for a cell takes the first.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "csg/mesh/second_order.h"
#include "csg/result/cell_tags.h"
#include "csg/result/result.h"
#include "csg/result/rounding.h"
#include "kernel/base/short_list.h"

namespace cnrg {

struct Mesh {
  using Index = std::uint32_t;
  struct Entity {
    ShortList<Index, 2> groups;  ///< numbers of groups of its dimension, from 1
    /// What bounds it, of one dimension less: number + 1, negative when it runs the other way.
    ShortList<std::int32_t, 4> boundary;
    bool feature = true;  ///< a cell of the result; false: between the facets of one patch
    bool wire = false;    ///< dimension 1: no face has it on its boundary
    CellTags tags;        ///< of the cell of the result that it is or is a part of
    bool side = false;    ///< dimension 2: of a face that was split (split.h)
  };
  template <std::size_t N>
  struct Simplex {
    std::array<Index, N> points;
    Index entity = 0;
  };

  std::string node;         ///< its name
  bool one_group = false;   ///< .msh says the first group of each element alone
  PeriodicAxes periodic{};  ///< along which it repeats (periodic.h)
  bool flat = false;        ///< entities are straight pieces and facets: the surface mesh
  std::vector<std::array<double, 3>> points;
  std::array<std::vector<std::string>, 4> groups;  ///< names by dimension; group g is at g - 1
  std::size_t sources = 0;  ///< how many groups of faces by their leaves there are: the last ones
  std::array<std::vector<Entity>, 4> entities;  ///< by dimension
  // By entity, ascending.
  std::vector<Simplex<1>> vertices;
  std::vector<Simplex<2>> segments;
  std::vector<Simplex<3>> triangles;  ///< counter-clockwise as seen from the front of the face
  /// In place of triangles, in one plane but for rounding: convex, corners in turn, counter-clockwise as these.
  /// Only of a mesh of first order without tetrahedra.
  std::vector<Simplex<4>> quads{};
  std::vector<Simplex<4>> tetrahedra;  ///< det(b - a, c - a, d - a) > 0
  /// Of a split mesh (split.h): by point the first one at its place that it was parted from, or itself; else
  /// empty.
  std::vector<Index> twins{};
  /// Without thickness: a triangle behind, and the one in front of it; of entities of dimension 3 of their own.
  std::vector<Simplex<6>> wedges{};

  /// Of a mesh of second order (curved_mesh.h): the point in the middle of each edge of its simplices, by the
  /// ends, the lower number first; ascending. Empty for all others.
  std::vector<std::pair<std::array<Index, 2>, Index>> middles;
  Index middle(Index a, Index b) const;
  /// The corners of a simplex, and of a mesh of second order the middles of its edges, which `edges` lists.
  template <std::size_t N, std::size_t M>
  std::vector<Index> nodes(const Simplex<N>& simplex,
                           const std::array<std::array<std::size_t, 2>, M>& edges) const {
    std::vector<Index> result;
    for_each_node(simplex, edges, [&](Index p) { result.push_back(p); });
    return result;
  }
  template <std::size_t N, std::size_t M, class See>
  void for_each_node(const Simplex<N>& simplex, const std::array<std::array<std::size_t, 2>, M>& edges,
                     const See& see) const {
    for (const Index p : simplex.points) see(p);
    if (middles.empty()) return;
    for (const auto& [i, j] : edges) see(middle(simplex.points[i], simplex.points[j]));
  }

  /// Calls see(kind, dimension, simplices, edges) for all: kinds count from 0, `edges` is for `for_each_node`.
  /// `tetrahedron`: the order of such edges.
  template <class See>
  void for_each_kind(const See& see, const TetrahedronEdges& tetrahedron = kSecondOrderEdges) const {
    see(0, 0, vertices, kSecondOrderPoint);
    see(1, 1, segments, kSecondOrderLine);
    see(2, 2, triangles, kSecondOrderTriangle);
    see(3, 2, quads, kSecondOrderPoint);
    see(4, 3, tetrahedra, tetrahedron);
    see(5, 3, wedges, kSecondOrderPoint);
  }

  /// Properties that are numbers: of each entity by dimension, not a number where nothing is said.
  struct Property {
    std::string key;
    std::array<std::vector<double>, 4> values;
  };
  std::vector<Property> properties;

  /// A number at each corner of each tetrahedron, four by four: it may jump where regions meet.
  struct Field {
    std::string name;
    std::vector<double> values;
  };
  std::vector<Field> fields;  ///< fractions of graded materials
};

/// The sides of a tetrahedron as they are seen from outside, by the corner opposite.
inline constexpr std::array<std::array<std::size_t, 3>, 4> kOutsides{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
/// True if an odd exchange puts three points in ascending order: triangles on the same points run alike if it is
/// so of both, or of neither.
inline bool is_odd(const std::array<Mesh::Index, 3>& c) {
  return ((c[0] > c[1]) + (c[0] > c[2]) + (c[1] > c[2])) % 2 != 0;
}

/// Names of groups, and the groups of each active cell of a flattened result by its dimension and number.
struct MeshGroups {
  std::array<std::vector<std::string>, 4> names;
  std::size_t sources = 0;  ///< how many groups of faces by their leaves there are: the last ones
  std::array<std::vector<ShortList<Mesh::Index, 2>>, 4> of;
};
MeshGroups mesh_groups(const ResultView& view, const FlatComplex& flat);
/// By region: the name of its first group, with its number (`r3`) behind it where several regions have that name;
/// empty for an inactive one.
std::vector<std::string> region_labels(const FlatComplex& flat, const MeshGroups& groups);

/// The surface mesh of a closed and bounded result.
Mesh surface_mesh(const ResultView& view, const FlatComplex& flat, const RoundedPoints& points);

/// All that a closed result draws.
Drawing drawing_of(const FlatComplex& flat);

}  // namespace cnrg
