// The soup made ready: one vertex per distinct point, cleaned faces with their planes, one segment per edge.
#pragma once

#include <algorithm>

#include "kernel/exact/plane_filter.h"
#include "kernel/exact/points.h"
#include "kernel/refine/report.h"
#include "kernel/refine/soup.h"

namespace cnrg {

/// Faces keep their SourceId; a face without area has no corners.
struct RefineInput {
  PointTable points;                ///< the vertices of the input; PlaneId(f) is the plane of face f
  std::vector<VertexId> vertex_of;  ///< by PointId
  Csr<SourceId, VertexId> corners;  ///< loop after loop, none() between two loops
  Csr<SourceId, SegmentId> sides;   ///< same places: the segment from a corner to the next of its loop
  /// Ends of each input edge and wire, the lexicographically smaller first. Segments are numbered by their end of
  /// the smaller id, then by the other one.
  IdVector<SegmentId, std::array<VertexId, 2>> segment_ends;
  /// By vertex: the first of the segments of which it is the end of the smaller id; at the end, their number.
  std::vector<std::uint32_t> segment_begin;
  IdVector<SegmentId, char> paired;     ///< sides of exactly two faces, in opposite directions
  std::vector<PlaneFilter> filters;     ///< by SourceId; freed once sheets are known
  std::vector<SegmentId> wire_segment;  ///< by WireId; none() for a wire of length zero
  std::vector<SegmentId> wires;         ///< segments that are wires, ascending and unique
  std::vector<VertexId> isolated;       ///< isolated points (also ends of zero-length wires), unique

  bool dropped(SourceId f) const { return corners[f].empty(); }
  static PlaneId plane(SourceId f) { return PlaneId(f.index()); }
  static std::uint64_t key(VertexId a, VertexId b) {
    const std::uint64_t x = a.value(), y = b.value();
    return x < y ? x << 32 | y : y << 32 | x;
  }
  /// The input segment between two vertices, or none().
  SegmentId find_segment(VertexId a, VertexId b) const;
};

/// No coordinate of v is more than this above its lower bound; 0 for a point of doubles, may be infinite.
inline double width_of(const PointTable& t, VertexId v) {
  if (t.is_double(v)) return 0;
  const double* lo = t.lower(v);
  return std::max({t.upper(v, 0) - lo[0], t.upper(v, 1) - lo[1], t.upper(v, 2) - lo[2]}) * (1 + 0x1p-50);
}

/// Throws InputError for a face that is not planar. `report.zero_area` gets the faces that were dropped.
RefineInput prepare_input(const Soup& soup, RefineReport& report);

}  // namespace cnrg
