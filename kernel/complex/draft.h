// A complex that is built but for what its cells come from.
//
// Cells are a matter of points and incidence alone; which faces and wires of which leaves lie on them is said in
// arrays of their own. `build_complex` takes these from the soup and is done. A result whose points are rounded to
// doubles is refined from triangles that belong to no leaf, and is told later what its cells come from: until then
// it is a draft.
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "kernel/base/sorted.h"
#include "kernel/complex/complex.h"

namespace cnrg {

/// Cells of leaves that hold cells of the complex on which none of their faces and wires lies
/// (Complex::face_leaf_cells and its like), in any order.
struct HeldCells {
  std::vector<std::pair<FaceId, LeafCell>> faces;
  std::vector<std::pair<EdgeId, LeafCell>> edges;
  std::vector<std::pair<VertexId, LeafCell>> vertices;
};

/// Lists of items, each once, by number.
template <class SetId, class Item>
class DistinctLists {
 public:
  /// The number of a list, in which order and repetitions do not matter.
  SetId operator()(std::vector<Item> list) {
    sort_unique(list);
    const auto [it, fresh] = known_.try_emplace(std::move(list), SetId(known_.size()));
    if (fresh) lists_.push_back(it->first);
    return it->second;
  }
  Csr<SetId, Item> take() { return std::move(lists_); }

 private:
  std::map<std::vector<Item>, SetId> known_;
  Csr<SetId, Item> lists_;
};

/// What the cells of a complex come from; the members of Complex with the same names. Pairs are in any order.
struct ComplexSources {
  IdVector<FaceId, SourceSetId> face_cover;
  Csr<SourceSetId, Cover> covers;
  IdVector<SourceId, Soup::Face> sources;
  Csr<EdgeId, SegmentId> edge_segments;
  IdVector<SegmentId, std::array<VertexId, 2>> segment_ends;
  Csr<SegmentId, SourceId> segment_faces;
  std::vector<std::pair<SegmentId, WireId>> segment_wires;
  IdVector<WireId, Soup::Wire> wires;
  std::vector<std::pair<VertexId, LeafId>> isolated_leaves, curve_ends;
  std::size_t leaf_count = 0;
  // Those of leaves that are not listed are none.
  IdVector<LeafId, Fill> fills;
  IdVector<LeafId, std::uint32_t> leaf_regions;
  IdVector<RegionId, LabelSetId> region_labels;  ///< empty: labels stay as they are
  Csr<LabelSetId, Label> label_sets;
  HeldCells held;
  std::vector<RemovedFacet> removed_facets;
  std::vector<std::pair<EdgeId, std::uint32_t>> edge_removed_facets;

  SegmentId add_segment(const std::array<VertexId, 2>& ends, std::span<const SourceId> faces,
                        std::span<const WireId> on) {
    segment_faces.push_back(faces);
    const SegmentId segment = segment_ends.push_back(ends);
    for (const WireId w : on) segment_wires.emplace_back(segment, w);
    return segment;
  }
};

class ComplexDraft {
 public:
  /// Refines the soup and builds its complex, as `build_complex` does.
  explicit ComplexDraft(const Soup& soup, const RefineOptions& options = {}, RefineReport* report = nullptr);
  const Complex& operator*() const { return *complex_; }
  const Complex* operator->() const { return complex_.get(); }

  /// Replaces what the cells come from.
  void set_sources(ComplexSources sources);
  /// Adds to what is held.
  void hold(HeldCells held);
  /// Finds the labels of the regions anew, from the soup that it was made of.
  void label(const Soup& soup);
  /// The complex, constant from now on; the draft is empty.
  std::shared_ptr<const Complex> finish() { return std::move(complex_); }

 private:
  std::shared_ptr<Complex> complex_;
};

}  // namespace cnrg
