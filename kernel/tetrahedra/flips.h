// Tetrahedra exchanged for others in the same hole, so that less is in the way of a segment or facet.
//
// Where a segment passes through a face, a new point on both would always do. But new points have edges of their
// own, which are in the way of what comes next: in a fan of a thousand thin triangles each had hundreds.
// Mostly other tetrahedra of the same points do as well, and cost nothing (freitag1997 has the moves).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "kernel/tetrahedra/tetrahedra.h"

namespace cnrg {

class Flips {
 public:
  using Index = Tetrahedra::Index;
  /// Is an edge, a face or a tetrahedron, by its corners, in the way?
  using InTheWay = std::function<bool(std::span<const VertexId>)>;
  /// Are edges next to one taken away first, where it cannot go before?
  enum class Deep { no, yes };
  /// May an edge go?
  using MayGo = std::function<bool(VertexId, VertexId)>;

  Flips(const PointTable& points, Tetrahedra& tetrahedra) : points_(points), tetrahedra_(tetrahedra) {}

  /// Takes an edge away, if other tetrahedra around it, with their edges and faces, are less in the way. Edges
  /// next to it go only if that puts no more in the way.
  bool remove_edge(VertexId a, VertexId b, const InTheWay& in_the_way, const MayGo& may_go, Deep deep = Deep::yes);
  /// Takes a face away by an edge that passes through it, likewise.
  bool remove_face(Tetrahedra::Face face, const InTheWay& in_the_way);

 private:
  const PointTable& points_;
  Tetrahedra& tetrahedra_;
  std::vector<Index> hole_;
  std::vector<VertexId> ring_;
  std::vector<Tetrahedra::Corners> fresh_;

  bool find_ring(VertexId a, VertexId b);
  bool remove(VertexId a, VertexId b, const InTheWay& in_the_way, int more);
};

}  // namespace cnrg
