// Cells of a mesh that nearly touch at a tetrahedron: what makes it flat whatever a mesher does.
//
// Two cells touch if a point of the mesh is in the closure of both, for the mesh conforms to all cells. Between
// two that do not touch there is a gap, and a tetrahedron that spans it is as flat as the gap is narrow. How far
// its own corners on the two are from each other says little of that: they lie side by side, as far as edges are
// long. What counts is how far a corner on one cell is from the other cell.
#pragma once

#include <array>
#include <compare>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "csg/mesh/mesh.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {

/// Of a tetrahedron, by places of its corners; the last three are opposite to the first three, from behind.
inline constexpr std::size_t kEdges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

/// A vertex, an edge or a face of a mesh, and its place among the entities of its dimension; 3: inside of a
/// region.
struct MeshCell {
  int dimension = 3;
  Mesh::Index entity = 0;
  friend auto operator<=>(const MeshCell&, const MeshCell&) = default;
};

/// It keeps a reference to the mesh, which has no quadrilaterals. One thread at a time may ask.
class NearCells {
 public:
  explicit NearCells(const Mesh& mesh);

  struct Gap {
    MeshCell a, b;
    double width = 0;  ///< from a place of the tetrahedron on one of them to the nearest of the other (units)
  };
  /// Of the cells that corners, sides and edges of a tetrahedron are on, two that do not touch, and the narrowest
  /// gap between such at its corners and edges, if it is narrower than `most`.
  std::optional<Gap> narrowest(const Mesh::Simplex<4>& t, double most) const;

  /// The lowest that a point of the mesh is in.
  MeshCell cell_of_point(Mesh::Index p) const { return cell_of_point_[p]; }
  /// One of its points.
  Mesh::Index point_of(MeshCell cell) const;
  /// The face that the side opposite to a corner is on.
  std::optional<Mesh::Index> face(const Mesh::Simplex<4>& t, std::size_t opposite) const;
  /// Is a point of the mesh in the closure of both?
  bool touch(MeshCell a, MeshCell b) const;

 private:
  const Mesh& mesh_;
  std::vector<MeshCell> cell_of_point_;
  std::vector<std::pair<std::array<Mesh::Index, 3>, Mesh::Index>> faces_;  // of triangles by corners; sorted
  /// Of segments by ends, and of other sides of triangles; sorted.
  std::vector<std::pair<std::array<Mesh::Index, 2>, MeshCell>> edges_;
  std::vector<std::pair<MeshCell, Mesh::Index>> closures_;  // and their points; sorted
  mutable std::map<std::pair<MeshCell, MeshCell>, bool> touching_;
  mutable std::unique_ptr<BoxTree> tree_;  // of triangles, then of segments; made when it is asked

  double distance(const std::array<double, 3>& p, MeshCell cell, double most) const;
};

}  // namespace cnrg
