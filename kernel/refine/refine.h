// The refinement of a soup: vertices, edges and faces that meet only along common boundaries (pereira2012 2.2).
#pragma once

#include "kernel/refine/subdivision.h"

namespace cnrg {

struct Refinement {
  RefineInput input;  ///< its `points` holds the constructed points too
  SegmentTable segments;
  Csr<SegmentId, SourceId> segment_faces;  ///< soup faces with the segment on their boundary (traces: none)
  EdgeTable edges;

  IdVector<SourceId, SheetId> sheet_of;  ///< none() for a dropped face
  Csr<SheetId, SourceId> sheet_faces;
  IdVector<SheetId, PlaneId> sheet_plane;
  IdVector<SheetId, Projection> sheet_projection;

  IdVector<FaceId, SheetId> face_sheet;
  Csr<FaceId, LoopId> face_loops;
  Csr<LoopId, HalfEdge> loops;
  Csr<FaceId, VertexId> face_vertices;
  Csr<FaceId, Cover> face_covers;
};

/// Refines the soup. Throws InputError for a face that is not planar.
Refinement refine(const Soup& soup, RefineReport& report, const Watch& watch = {});

}  // namespace cnrg
