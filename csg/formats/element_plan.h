// Which simplices of a mesh are elements of a structural analysis, and what replaces the others.
#pragma once

#include <utility>
#include <vector>

#include "csg/mesh/mesh.h"

namespace cnrg {

/// Tetrahedra are solids. Triangles are shells, unless the mesh has tetrahedra and the face bounds regions and
/// nothing is said of it but what is said of one of these (quadrilaterals are, since there are none with
/// tetrahedra), or it was split (csg/mesh/split.h): of such faces a solver knows the sides of tetrahedra. Segments
/// of wires are bars; those on edges of faces are none.
class ElementPlan {
 public:
  explicit ElementPlan(const Mesh& mesh);
  const std::vector<Mesh::Simplex<3>>& shells() const { return shells_; }
  const std::vector<Mesh::Simplex<2>>& bars() const { return bars_; }

  /// A side of a tetrahedron: its place in Mesh::tetrahedra, and 1 to 4 for the corners 012, 013, 123, 023, which
  /// is how Abaqus counts them.
  using Side = std::pair<std::size_t, int>;
  /// By group of faces - 1: the sides on which its triangles lie, each once: of the tetrahedron behind the
  /// triangle, or else of the one in front; none where there are no tetrahedra at it.
  std::vector<std::vector<Side>> sides() const;

 private:
  const Mesh& mesh_;
  std::vector<Mesh::Simplex<3>> shells_;
  std::vector<Mesh::Simplex<2>> bars_;
};

/// By group of the dimension - 1: the numbers of its nodes from 1, middles of edges included, ascending.
std::vector<std::vector<std::size_t>> group_nodes(const Mesh& mesh, std::size_t dimension);

}  // namespace cnrg
