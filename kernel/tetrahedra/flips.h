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
  /// Is an edge or a face, by its two or three corners, in the way?
  using InTheWay = std::function<bool(std::span<const VertexId>)>;
  /// May an edge go?
  using MayGo = std::function<bool(VertexId, VertexId)>;

  Flips(const PointTable& points, Tetrahedra& tetrahedra) : points_(points), tetrahedra_(tetrahedra) {}

  /// Takes an edge away, if what comes with other tetrahedra around it has fewer edges and faces in the way. Where
  /// there are no such tetrahedra, edges next to it are taken away first, if that puts no more in the way.
  bool remove_edge(VertexId a, VertexId b, const InTheWay& in_the_way, const MayGo& may_go);
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
