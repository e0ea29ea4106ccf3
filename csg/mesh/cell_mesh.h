// Meshes whose entities are the cells of a result, in the order of the flattened result: their entities, groups
// and tags before there are simplices, and the proof that simplices are those of the cells.
#pragma once

#include <algorithm>
#include <unordered_map>

#include "csg/mesh/mesh.h"

namespace cnrg {

/// The edges of a result by the two ends of each straight piece.
class EdgePieces {
 public:
  using Index = Mesh::Index;
  explicit EdgePieces(const FlatComplex& flat);
  /// The edge that a step of a boundary walk follows: number + 1, negative against the chain.
  std::int32_t step(Index a, Index b) const;

 private:
  struct Piece {
    Index edge;
    bool forward;  // the chain runs from the lower number to the higher one
  };
  std::unordered_map<std::uint64_t, Piece> pieces_;
};

/// A mesh without points and simplices: an entity for each vertex, edge and face, with what bounds it, and, for a
/// mesh that fills them, for each active region.
Mesh mesh_of_cells(const ResultView& view, const FlatComplex& flat, bool with_regions);

/// Simplices in the order of a mesh.
template <class Simplices>
void sort_by_entity(Simplices& simplices) {
  std::stable_sort(simplices.begin(), simplices.end(),
                   [](const auto& s, const auto& t) { return s.entity < t.entity; });
}

/// The pieces of every edge form a way between its ends through all of its points, or a closed one. Segments are
/// by entity; points of the result have the numbers that they have there. Throws InvariantError.
void prove_edges(const Mesh& mesh, const FlatComplex& flat);
/// The boundary of the triangles of a face over Z/2 is that of the face. After `prove_edges`.
void prove_faces(const Mesh& mesh, const FlatComplex& flat);
/// On the two sides of a triangle are the regions of its face; a wall is where regions differ. `region_entity`: of
/// each region of the result that of the mesh, or kNone. Throws InvariantError; Stopped.
void prove_sides(const Mesh& mesh, const FlatComplex& flat, const std::vector<Mesh::Index>& region_entity,
                 const Watch& watch);

/// The points that simplices use, in their order, become the points of the mesh.
void take_points(Mesh& mesh, const std::vector<std::array<double, 3>>& points);

}  // namespace cnrg
