// The cells to which two operands alone are refined (pereira2012 2.2): the overlay of their simplified values.
//
// The complex is cut by all leaves of a tree, and an operand still has the cuts of what was removed from it. What a
// Boolean does is counted and told in the cells that its two operands make of each other, so that nothing else in
// the tree matters. The complex has these cells in pieces; here is which pieces are of one cell.
#pragma once

#include "csg/operators/cell_sources.h"
#include "csg/operators/group.h"
#include "kernel/selection/merging.h"

namespace cnrg {

class PairRefinement {
 public:
  /// Of the entities of two groups, which must outlive this. Of each group they may be a part, if with a cell it
  /// has all entities of that group in the star of the cell: what a Boolean removes is such a part.
  PairRefinement(const Complex& complex, const Group& a, const Group& b);

  /// The cell that holds an entity: the smallest of its pieces that have its dimension.
  Location place(FaceId f);
  Location place(EdgeId e);
  Location place(VertexId v);

  /// True for one of the pieces of each cell.
  bool is_first(FaceId f) const { return faces_.find(f).first == f; }
  bool is_first(EdgeId e) { return is_kept(e) && chains_.find(e) == e; }
  bool is_first(VertexId v) const { return edge_of_vertex_[v] == 0 && face_of_vertex_[v] == 0; }

 private:
  using Fate = Merging::Fate;
  /// A group by itself.
  struct Operand {
    Operand(const Complex& complex, const Group& group);
    template <class IdT>
    bool has(IdT cell) const {
      return merging.state(cell) != 0;
    }
    const GroupSources sources;
    Merging merging;
  };

  void decide(EdgeId e);
  void decide(VertexId v);
  bool is_kept(EdgeId e) const { return face_of_edge_[e] == 0; }
  /// A cell of one operand, or of both, is of each of which `cell` is.
  template <class IdT, class OtherId>
  bool is_with(IdT cell, OtherId other) const {
    return (!a_.has(cell) || a_.has(other)) && (!b_.has(cell) || b_.has(other));
  }
  FaceId common_face(VertexId v) const;

  const Complex& complex_;
  Operand a_, b_;
  OrientedSets faces_;
  SparseSets<EdgeId> chains_;
  // Of entities in the interior of a larger cell: 1 + a piece of that.
  Scratch<EdgeId, std::uint32_t> face_of_edge_;
  Scratch<VertexId, std::uint32_t> edge_of_vertex_, face_of_vertex_;
};

}  // namespace cnrg
