// Which cells of a selection merge into which: the decisions of `simplify`.
//
// Only the *domain* is looked at: the closure of the active cells and of the features. Every other cell is
// inactive with an inactive star in which nothing is kept, so it lies in the interior of a merged inactive region
// (or on the frame), whatever happens elsewhere. The cost is that of the domain and its incidences: an inactive
// region may bound a whole complex.
//
// Notation: the *state* of a cell is its component. Faces are decided first, then edges, then vertices; a face
// that stays *remains*, an edge or vertex that is not in the interior of something larger is *kept*.
// A *use* is an entry of Complex::edge_uses: one face along one half-edge of its loops. `next` and `previous`
// follow the loop; `across` turns around a vertex inside a merged face, over the edges that vanished in it. Most
// faces merge with none and are not asked about: loops are linked when they are needed.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/selection/scratch.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

/// Disjoint sets of faces, each member with or against the orientation of the smallest one.
class OrientedSets {
 public:
  explicit OrientedSets(std::size_t n) : links_(n) {}
  /// Joins the sets of a and b, `flip`: a and b are oriented against each other. False if they are in one set
  /// already with the other orientation (the union would not be orientable).
  bool unite(FaceId a, FaceId b, bool flip);
  /// Called after the last union: then `find` is one step, and threads may ask.
  void settle();
  /// All are by themselves again.
  void reset();
  /// The smallest member of the set of x, and whether x is oriented against it.
  std::pair<FaceId, bool> find(FaceId x) const;
  /// All members but the smallest of each set, ascending; after `settle`.
  const std::vector<FaceId>& joined() const { return joined_; }

 private:
  struct Link {
    std::uint32_t parent;  // 1 + the parent; 0: none
    bool flip;
  };
  std::pair<FaceId, bool> shortened(FaceId x);
  Scratch<FaceId, Link> links_;
  std::vector<FaceId> joined_;
};

class Merging {
 public:
  enum class Fate : std::uint8_t {
    in_region,  ///< in the interior of a merged region; so are all cells off the domain
    in_face,    ///< in the interior of a merged face
    in_edge,    ///< in the interior of a chain of edges
    kept,       ///< a cell of the result
    hidden,     ///< on the frame
  };
  using Use = std::uint32_t;  ///< index into Complex::edge_uses.values()

  Merging(const Complex& complex, const Selection& selection, const Features& features, SimplifyMode mode,
          const CellSources* sources);

  /// Decides about one cell again, of a selection that changes (csg/operators/tally.h). Of what changed, and of
  /// all in its closure, faces are put first, then edges, then vertices. Cells put one by one are not united:
  /// `domain`, `region`, `face` and `chain` do not know of them.
  void put(FaceId f, Component state);
  void put(EdgeId e, Component state, bool feature);
  void put(VertexId v, Component state, bool feature);

  /// The closure of the active cells and the features, but for the frame.
  const CellSet& domain() const { return domain_; }
  Fate fate(FaceId f) const { return complex_.on_frame(f) ? Fate::hidden : face_fate_[f]; }
  Fate fate(EdgeId e) const { return complex_.on_frame(e) ? Fate::hidden : edge_fate_[e]; }
  Fate fate(VertexId v) const { return complex_.on_frame(v) ? Fate::hidden : vertex_fate_[v]; }
  Component state(VertexId v) const { return vertex_state_[v]; }
  Component state(EdgeId e) const { return edge_state_[e]; }
  Component state(FaceId f) const { return face_state_[f]; }
  Component state(RegionId r) const { return region_state_[r]; }

  /// Merges inactive regions over faces off the domain, too: a pass over the faces of the complex.
  void merge_inactive_regions();
  /// The smallest cell of the merged region; of inactive ones only after `merge_inactive_regions`.
  RegionId region(RegionId r) { return regions_.find(r); }
  /// The smallest face of the merged face, and whether f is oriented against it.
  std::pair<FaceId, bool> face(FaceId f) const { return faces_.find(f); }
  /// The edges of fate in_face, ascending.
  const std::vector<EdgeId>& inner_edges() const { return inner_edges_; }
  /// The smallest edge of the chain that holds a kept edge.
  EdgeId chain(EdgeId e) { return chains_.find(e); }
  /// A face in whose interior a vertex of fate in_face vanished.
  FaceId host(VertexId v) const { return vertex_host_[v]; }
  /// The faces in whose interior a kept vertex is isolated: merged ones by their smallest face, ascending.
  void isolating_faces(VertexId v, std::vector<FaceId>& out);

  bool remains(Use u) const { return fate(use(u).face) == Fate::kept; }
  bool walkable(EdgeId e) const { return fate(e) == Fate::kept || fate(e) == Fate::hidden; }
  const FaceUse& use(Use u) const { return complex_.edge_uses.values()[u]; }
  Use first_use(EdgeId e) const { return complex_.edge_uses.offsets()[e.index()]; }
  Use end_use(EdgeId e) const { return complex_.edge_uses.offsets()[e.index() + 1]; }
  /// The two faces that are one over an edge of fate in_face, each along the edge.
  std::pair<FaceUse, FaceUse> merged_over(EdgeId e) const;
  /// These lie in one plane and are pieces of different facets.
  bool between_coplanar_facets(EdgeId e) const;
  /// The uses of a remaining face along one of its loops, into `out`.
  void uses_along(FaceId f, LoopId l, std::vector<Use>& out) const;
  /// From a use of a walkable edge at v: the use of the walkable edge on the other side of the face's corner.
  /// Threads may ask at a time when they ask about different merged faces.
  Use across(Use u, VertexId v);

 private:
  struct UseTag;
  template <class IdT>
  std::uint32_t mark(IdT cell) const {
    return marks_ == nullptr ? 0 : marks_->mark(cell);
  }
  bool mergeable(Component state) const { return mode_ != SimplifyMode::raw || state == 0; }
  void collect_domain(const Selection& selection, const Features& features);
  void decide_faces();
  void decide_edges(const std::vector<EdgeId>& features);
  void decide_vertices(const std::vector<VertexId>& features);
  Fate decide(EdgeId e) const;
  bool pinned(VertexId v) const;
  Fate decide(VertexId v);
  bool continues(VertexId v, EdgeId a, EdgeId b);
  bool one_surface(FaceId f, FaceId g) const;
  bool one_curve(VertexId v, EdgeId a, EdgeId b) const;
  void link_loops(FaceId f);
  Use neighbour(Use u, VertexId v);
  Use twin_use(Use u) const;

  const Complex& complex_;
  SimplifyMode mode_;
  const CellSources* sources_;
  const CellSources* marks_;  // nullptr: no cell has a mark
  Scratch<VertexId, Component> vertex_state_;
  Scratch<EdgeId, Component> edge_state_;
  Scratch<FaceId, Component> face_state_;
  Scratch<RegionId, Component> region_state_;
  CellSet domain_;
  Scratch<FaceId, Fate> face_fate_;
  Scratch<EdgeId, Fate> edge_fate_;
  Scratch<VertexId, Fate> vertex_fate_;
  Scratch<VertexId, FaceId> vertex_host_;
  SparseSets<RegionId> regions_;
  OrientedSets faces_;
  SparseSets<EdgeId> chains_;
  std::vector<EdgeId> inner_edges_;
  Scratch<Id<UseTag>, Use> next_, previous_;  // 1 + the use; 0: the loops of its face are not linked yet
  std::vector<FaceId> around_;
};

}  // namespace cnrg
