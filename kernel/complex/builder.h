// From a refinement to the complex: incidence, radial order, shells, regions, labels. Private to this room.
#pragma once

#include "kernel/base/union_find.h"
#include "kernel/complex/complex.h"
#include "kernel/refine/refine.h"

namespace cnrg {

class ComplexBuilder {
 public:
  ComplexBuilder(const Soup& soup, Refinement refinement) : soup_(soup), r_(std::move(refinement)) {}
  Complex build();

 private:
  void take_cells();
  void drop_unused_edges();
  void find_vertices();
  void find_uses();
  void order_radially();
  void join_shells();
  void nest_shells();
  void hang_wires();
  void number_regions();
  void mark_frame();

  const Soup& soup_;
  Refinement r_;
  Complex c_;
  UnionFind shells_;                             // half-faces that edges connect
  UnionFind space_;                              // half-faces, then one node per wire edge and vertex, then infinity
  std::uint32_t edge_node_ = 0, vertex_node_ = 0, infinity_ = 0;
};

/// Sets `label_sets`, `region_labels` and `leaf_regions` (labels.cpp). Throws InputError for sides that contradict
/// each other.
void label_regions(const Soup& soup, Complex& complex);

}  // namespace cnrg
