// From a refinement to the complex: incidence, radial order, shells, regions, labels. Private to this room.
#pragma once

#include "kernel/base/union_find.h"
#include "kernel/complex/complex.h"
#include "kernel/refine/refine.h"

namespace cnrg {

class ComplexBuilder {
 public:
  ComplexBuilder(const Soup& soup, Refinement refinement, const Watch& watch)
      : soup_(soup), r_(std::move(refinement)), watch_(watch) {}
  /// Called once, by `ComplexDraft` (draft.h) alone: the result may be written to until that hands it on as const.
  std::shared_ptr<Complex> build();

 private:
  // Cells and incidence (builder.cpp).
  void take_cells();
  void take_sparse_cells();
  void share_covers(Csr<FaceId, Cover> covers);
  void take_attributes();
  void find_uses();
  void drop_unused_edges();
  void find_vertices();
  void order_radially();
  void mark_frame();

  // Shells and regions (shells.cpp).
  void join_shells();
  void nest_shells();
  std::vector<FaceId> farthest_faces(UnionFind& surfaces) const;
  std::vector<FaceId> join_outermost(std::vector<FaceId> starts, UnionFind& surfaces);  // outermost.cpp
  void hang_wires();
  void number_regions();
  void list_region_faces(const std::vector<RegionId>& region_of);

  // Their order (region_order.cpp).
  std::vector<std::uint32_t> places_of_regions(const std::vector<RegionId>& region_of) const;

  std::uint32_t patch_side(HalfFace h) const { return front_side_[h.face()] ^ h.side(); }
  ShellId shell(HalfFace h) const { return side_shell_[patch_side(h)]; }

  const Soup& soup_;
  Refinement r_;
  const Watch& watch_;
  const std::shared_ptr<Complex> built_{new Complex};
  Complex& c_ = *built_;
  std::vector<EdgeId> wired_;                   // edges of wires, ascending
  std::vector<EdgeId> wires_;                   // edges with no face, ascending
  std::vector<EdgeId> junctions_;               // edges with faces, but not with two uses
  std::vector<VertexId> loose_;                 // vertices on no edge and in no face, ascending
  IdVector<FaceId, std::uint32_t> front_side_;  // 2 * patch + side of the front of each face (shells.cpp)
  std::vector<ShellId> side_shell_;             // the shell of each side of a patch; numbered by first half-faces
  std::size_t shell_count_ = 0;
  UnionFind space_;  // shells, then infinity, then `wires_`, then `loose_`
};

/// Gives the soup faces of curved patches the numbers that they have not got yet (surfaces.cpp).
void number_surfaces(Complex& complex);

/// Sets `label_sets`, `region_labels` and `leaf_regions` (labels.cpp). Throws InputError for sides that contradict
/// each other.
void label_regions(const Soup& soup, Complex& complex);

}  // namespace cnrg
