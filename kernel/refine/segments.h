// All lines of the arrangement: input edges, wires, and traces where two sheets meet.
#pragma once

#include <algorithm>
#include <vector>

#include "kernel/refine/point_key.h"

namespace cnrg {

struct SegmentTable {
  IdVector<SegmentId, std::array<VertexId, 2>> ends;  ///< the lexicographically smaller first
  /// For a trace, two sheets that it lies in; none() for input segments. Traces follow the input segments.
  IdVector<SegmentId, std::array<SheetId, 2>> trace_sheets;
  std::size_t input_count = 0;

  bool is_trace(SegmentId s) const { return s.index() >= input_count; }
  /// A sheet of the trace other than `sheet`: the planes of the two meet in the line of the trace.
  SheetId other_sheet(SegmentId s, SheetId sheet) const {
    return trace_sheets[s][0] == sheet ? trace_sheets[s][1] : trace_sheets[s][0];
  }
};

/// Facts that are known by symbol: segments on which a vertex lies, and sheets.
struct KnownIncidence {
  Csr<VertexId, SegmentId> segments;
  Csr<VertexId, SheetId> sheets;

  bool on(VertexId v, SegmentId s) const { return holds(segments[v], s); }
  bool in(VertexId v, SheetId s) const { return holds(sheets[v], s); }

 private:
  template <class IdT>
  static bool holds(std::span<const IdT> list, IdT id) {
    return list.size() < 16 ? std::find(list.begin(), list.end(), id) != list.end()
                            : std::binary_search(list.begin(), list.end(), id);
  }
};

/// A sheet that needs work: what lies in its plane.
struct SheetContent {
  SheetId sheet;
  PlaneId plane;
  Projection axes;
  std::span<const SourceId> faces;
  std::span<const SegmentId> segments;  ///< unique
  std::span<const VertexId> points;     ///< unique; may also be ends of segments
};

/// A crossing of the interiors of two segments.
struct Crossing {
  PointKey point;
  SegmentId s, t;
  friend auto operator<=>(const Crossing&, const Crossing&) = default;
};

/// Finds in one sheet all crossings, and all points (ends of segments, isolated points) in the interior of a
/// segment. `representative` maps a sheet to the face that stands for it in keys.
void find_crossings(const SheetContent& content, const PointTable& points, const SegmentTable& segments,
                    const KnownIncidence& known, const IdVector<SheetId, SourceId>& representative,
                    std::vector<Crossing>& crossings, std::vector<std::pair<SegmentId, VertexId>>& incidences);

}  // namespace cnrg
