// A facet as a union of faces.
#pragma once

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "kernel/refine/box_tree.h"
#include "kernel/tetrahedra/tetrahedra.h"

namespace cnrg {

/// A facet among tetrahedra of which its border is made of edges: which edges pass through it, and once there are
/// none, which faces it is made of.
class Wall {
 public:
  using Index = Tetrahedra::Index;
  using Triangle = std::array<VertexId, 3>;
  using Ends = std::array<VertexId, 2>;

  /// `facet`: triangles of one plane, turned alike, that overlap nowhere. `border`: its sides, each with the facet
  /// on its left; they must be edges. `inside`: vertices inside of it.
  Wall(const PointTable& points, const Tetrahedra& tetrahedra, std::span<const Triangle> facet,
       std::vector<Ends> border, std::span<const VertexId> inside);

  /// The faces that are in it, turned as the facet.
  std::vector<Triangle> faces() const;
  /// The edges that pass through it, each from below the facet to above, ascending.
  std::vector<Ends> edges_through();
  /// Does an edge pass through it?
  bool is_crossed(VertexId a, VertexId b);

 private:
  const PointTable& points_;
  const Tetrahedra& tetrahedra_;
  std::span<const Triangle> facet_;
  std::vector<Ends> border_;       // sorted
  std::vector<VertexId> corners_;  // of facet and border, and inside; sorted
  std::optional<BoxTree> boxes_;   // of triangles, where they are many
  mutable std::unordered_map<VertexId, int> side_;

  int side(VertexId v) const;
  std::vector<Triangle> within_border(const std::vector<Triangle>& faces) const;
  bool pierced(Index t);
};

}  // namespace cnrg
