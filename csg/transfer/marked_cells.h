// Marks that keep cells of a value apart in its simplification.
#pragma once

#include <vector>

#include "kernel/complex/by_dimension.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

template <class IdT>
using CellMarks = IdVector<IdT, std::uint32_t>;

/// Cells merge with their like only (CellSources::mark); every leaf counts everywhere.
class MarkedCells : public CellSources, public OfEntities<CellMarks> {
 public:
  explicit MarkedCells(const Complex& complex) : OfEntities(complex) {
    for (const LeafId leaf : IdRange<LeafId>(complex.leaf_count)) all_.push_back(leaf);
  }
  bool marks_anything() const override { return true; }
  std::uint32_t mark(FaceId f) const override { return faces[f]; }
  std::uint32_t mark(EdgeId e) const override { return edges[e]; }
  std::uint32_t mark(VertexId v) const override { return vertices[v]; }
  void leaves_of(FaceId, std::vector<LeafId>& out) const override { out = all_; }
  void leaves_of(EdgeId, std::vector<LeafId>& out) const override { out = all_; }

 private:
  std::vector<LeafId> all_;
};

}  // namespace cnrg
