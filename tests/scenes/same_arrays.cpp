#include "tests/scenes/same_arrays.h"

namespace cnrg::scenes {
namespace {

template <class A>
bool same(const A& a, const A& b) {
  if constexpr (requires { a.raw(); }) {
    return a.raw() == b.raw();
  } else if constexpr (requires { a.offsets(); }) {
    return a.offsets() == b.offsets() && a.values() == b.values();
  } else {
    return a == b;
  }
}

}  // namespace

bool same_arrays(const Complex& a, const Complex& b) {
  if (!same(a.vertices, b.vertices)) return false;
  for (const VertexId v : a.vertices)
    if (a.points.exact(v) != b.points.exact(v)) return false;
  return same(a.sheet_plane, b.sheet_plane) && same(a.vertex_edges, b.vertex_edges) &&
         same(a.vertex_faces, b.vertex_faces) && same(a.vertex_region, b.vertex_region) &&
         same(a.edge_ends, b.edge_ends) && same(a.edge_uses, b.edge_uses) && same(a.edge_region, b.edge_region) &&
         same(a.edge_segments, b.edge_segments) && same(a.segment_ends, b.segment_ends) &&
         same(a.segment_faces, b.segment_faces) && same(a.segment_wires, b.segment_wires) &&
         same(a.face_sheet, b.face_sheet) && same(a.face_loops, b.face_loops) && same(a.loop, b.loop) &&
         same(a.face_vertices, b.face_vertices) && same(a.face_cover, b.face_cover) && same(a.covers, b.covers) &&
         same(a.face_regions, b.face_regions) && a.region_count == b.region_count &&
         same(a.region_labels, b.region_labels) && same(a.label_sets, b.label_sets) &&
         same(a.region_faces, b.region_faces) && same(a.region_wires, b.region_wires) &&
         same(a.region_vertices, b.region_vertices) && same(a.isolated_leaves, b.isolated_leaves) &&
         same(a.leaf_regions, b.leaf_regions);
}

}  // namespace cnrg::scenes
