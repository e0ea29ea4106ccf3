// Segments cut into edges: equal pieces of different segments are one edge.
#pragma once

#include "kernel/refine/subdivision.h"

namespace cnrg {

/// Cuts every segment at the points in its interior (`inner`, ascending). Edges are numbered by their
/// end of the smaller id, then by the other one. Most segments have no such point: they are edges in order
/// already, and only the pieces of the others are sorted.
EdgeTable cut_segments(const PointTable& points, const SegmentTable& segments,
                       const Csr<SegmentId, VertexId>& inner);

/// The faces that have a segment on their boundary, ascending; `segments`: how many there are.
Csr<SegmentId, SourceId> faces_along(const Csr<SourceId, SegmentId>& sides, std::size_t segments);

}  // namespace cnrg
