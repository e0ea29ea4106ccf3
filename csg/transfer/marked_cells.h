// Marks that keep cells of a value apart in its simplification.
#pragma once

#include <vector>

#include "kernel/selection/simplify.h"

namespace cnrg {

/// Cells merge with their like only (CellSources::mark); every leaf counts everywhere.
class MarkedCells : public CellSources {
 public:
  explicit MarkedCells(const Complex& complex)
      : faces(complex.face_count()), edges(complex.edge_count()), vertices(complex.points.size()) {
    for (const LeafId leaf : IdRange<LeafId>(complex.leaf_count)) all_.push_back(leaf);
  }
  bool marks_anything() const override { return true; }
  std::uint32_t mark(FaceId f) const override { return faces[f]; }
  std::uint32_t mark(EdgeId e) const override { return edges[e]; }
  std::uint32_t mark(VertexId v) const override { return vertices[v]; }
  void leaves_of(FaceId, std::vector<LeafId>& out) const override { out = all_; }
  void leaves_of(EdgeId, std::vector<LeafId>& out) const override { out = all_; }

  IdVector<FaceId, std::uint32_t> faces;
  IdVector<EdgeId, std::uint32_t> edges;
  IdVector<VertexId, std::uint32_t> vertices;

 private:
  std::vector<LeafId> all_;
};

}  // namespace cnrg
