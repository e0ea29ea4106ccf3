// The cells to which two operands alone are refined (pereira2012 2.2): the overlay of their simplified values.
//
// The complex is cut by all leaves of a tree, and an operand still has the cuts of what was removed from it. What
// a Boolean does is counted and told in the cells that its two operands make of each other, so that nothing else
// in the tree matters. The complex has these cells in pieces; here is which pieces are of one cell.
#pragma once

#include <optional>
#include <vector>

#include "csg/operators/cell_sources.h"
#include "csg/operators/group.h"
#include "kernel/complex/by_dimension.h"
#include "kernel/selection/merging.h"

namespace cnrg {

class PairRefinement {
 public:
  explicit PairRefinement(const Complex& complex);

  /// Of the entities of two groups. Of each group they may be a part, if with a cell it has all entities of that
  /// group in the star of the cell: what a Boolean removes is such a part. Replaces what was refined before.
  void refine(const Group& a, const Group& b);

  /// The cell that holds an entity: the smallest of its pieces that have its dimension.
  Location place(FaceId f) const { return {2, {}, {}, faces_.find(f).first, {}}; }
  Location place(EdgeId e);
  Location place(VertexId v);

  /// False for an edge inside of a face.
  bool is_kept(EdgeId e) const { return face_of_edge_[e] == 0; }
  /// True for one of the pieces of each cell.
  bool is_first(FaceId f) const { return faces_.find(f).first == f; }
  bool is_first(EdgeId e) { return is_kept(e) && chains_.find(e) == e; }
  bool is_first(VertexId v) const { return edge_of_vertex_[v] == 0 && face_of_vertex_[v] == 0; }

 private:
  using Fate = Merging::Fate;
  /// Those of the operand that is looked at.
  class Sources : public CellSources {
   public:
    std::optional<GroupSources> of;
    bool marks_anything() const override { return true; }
    std::uint32_t mark(FaceId f) const override { return of->mark(f); }
    std::uint32_t mark(EdgeId e) const override { return of->mark(e); }
    std::uint32_t mark(VertexId v) const override { return of->mark(v); }
    void leaves_of(FaceId f, std::vector<LeafId>& out) const override { of->leaves_of(f, out); }
    void leaves_of(EdgeId e, std::vector<LeafId>& out) const override { of->leaves_of(e, out); }
  };

  void simplify(const Group& operand, std::uint8_t flag);
  void decide(EdgeId e);
  void decide(VertexId v);
  FaceId common_face(VertexId v) const;
  void clear();

  const Complex& complex_;
  Sources sources_;
  Merging merging_;  // of one operand after the other
  CellSet cells_;    // of both
  OfEntities<Marks> of_;
  OrientedSets faces_;
  SparseSets<EdgeId> chains_;
  // Of entities in the interior of a larger cell: 1 + a piece of that.
  Scratch<EdgeId, std::uint32_t> face_of_edge_;
  Scratch<VertexId, std::uint32_t> edge_of_vertex_, face_of_vertex_;
};

}  // namespace cnrg
