// A complex that is built but for what its cells come from.
//
// Cells are a matter of points and incidence alone; which faces and wires of which leaves lie on them is said in
// arrays of their own. `build_complex` takes these from the soup and is done. A result whose points are rounded to
// doubles is refined from triangles that belong to no leaf, and is told later what its cells come from: until then
// it is a draft.
#pragma once

#include "kernel/complex/complex.h"

namespace cnrg {

/// What the cells of a complex come from; the members of Complex with the same names.
struct ComplexSources {
  IdVector<FaceId, SourceSetId> face_cover;
  Csr<SourceSetId, Cover> covers;
  IdVector<SourceId, Soup::Face> sources;
  Csr<EdgeId, SegmentId> edge_segments;
  IdVector<SegmentId, std::array<VertexId, 2>> segment_ends;
  Csr<SegmentId, SourceId> segment_faces;
  SparseLists<SegmentId, WireId> segment_wires;
  IdVector<WireId, Soup::Wire> wires;
  SparseLists<VertexId, LeafId> isolated_leaves, curve_ends;
  std::size_t leaf_count = 0;
  // Those of leaves that are not listed are none.
  IdVector<LeafId, Fill> fills;
  IdVector<LeafId, std::uint32_t> leaf_regions;
  IdVector<RegionId, LabelSetId> region_labels;  ///< empty: labels stay as they are
  Csr<LabelSetId, Label> label_sets;
  SparseLists<VertexId, LeafCell> vertex_leaf_cells;
  SparseLists<EdgeId, LeafCell> edge_leaf_cells;
  SparseLists<FaceId, LeafCell> face_leaf_cells;
  std::vector<RemovedFacet> removed_facets;
  SparseLists<EdgeId, std::uint32_t> edge_removed_facets;
};

class ComplexDraft {
 public:
  /// Refines the soup and builds its complex, as `build_complex` does.
  explicit ComplexDraft(const Soup& soup, const RefineOptions& options = {}, RefineReport* report = nullptr);
  const Complex& operator*() const { return *complex_; }
  const Complex* operator->() const { return complex_.get(); }

  /// Replaces what the cells come from.
  void set_sources(ComplexSources sources);
  /// Cells of leaves hold cells of the complex on which none of their faces and wires lies: adds them to
  /// Complex::face_leaf_cells and its like. The lists may be in any order.
  void hold(const std::vector<std::pair<FaceId, LeafCell>>& faces,
            const std::vector<std::pair<EdgeId, LeafCell>>& edges,
            const std::vector<std::pair<VertexId, LeafCell>>& vertices);
  /// Finds the labels of the regions anew, from the soup that it was made of.
  void label(const Soup& soup);
  /// The complex, constant from now on; the draft is empty.
  std::shared_ptr<const Complex> finish() { return std::move(complex_); }

 private:
  std::shared_ptr<Complex> complex_;
};

}  // namespace cnrg
