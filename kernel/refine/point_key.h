// The symbol of a point where inputs meet, before the point has a vertex: its definition, not its coordinates.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>

#include "kernel/exact/points.h"
#include "kernel/refine/input.h"

namespace cnrg {

struct PointKey {
  enum class Kind : std::uint32_t {
    vertex,         ///< a: a vertex that exists
    segment_plane,  ///< a: an input segment, b: the face whose plane it crosses
    segments,       ///< a < b: two coplanar input segments that cross
    planes,         ///< a < b < c: faces, one per sheet, whose planes meet in the point
  };
  Kind kind = Kind::vertex;
  std::array<std::uint32_t, 3> id{0, 0, 0};

  static PointKey vertex(VertexId v) { return {Kind::vertex, {v.value(), 0, 0}}; }
  static PointKey segment_plane(SegmentId s, SourceId f) {
    return {Kind::segment_plane, {s.value(), f.value(), 0}};
  }
  static PointKey segments(SegmentId s, SegmentId t) {
    return {Kind::segments, {std::min(s, t).value(), std::max(s, t).value(), 0}};
  }
  static PointKey planes(SourceId f, SourceId g, SourceId h) {
    PointKey k{Kind::planes, {f.value(), g.value(), h.value()}};
    std::sort(k.id.begin(), k.id.end());
    return k;
  }
  friend bool operator==(const PointKey& a, const PointKey& b) {
    return a.head() == b.head() && a.tail() == b.tail();
  }
  /// By kind, then by ids.
  friend std::strong_ordering operator<=>(const PointKey& a, const PointKey& b) {
    return a.head() != b.head() ? a.head() <=> b.head() : a.tail() <=> b.tail();
  }
  std::uint64_t hash() const {
    std::uint64_t h = head() * 0x9e3779b97f4a7c15ull;
    h = (h ^ h >> 29 ^ tail()) * 0xbf58476d1ce4e5b9ull;
    return h ^ h >> 32;
  }

 private:
  std::uint64_t head() const { return std::uint64_t{static_cast<std::uint32_t>(kind)} << 32 | id[0]; }
  std::uint64_t tail() const { return std::uint64_t{id[1]} << 32 | id[2]; }
};

/// The definition on input points and planes; for Kind::vertex there is none.
inline Definition definition_of(const PointKey& key, const RefineInput& in) {
  Definition d;
  switch (key.kind) {
    case PointKey::Kind::vertex: break;
    case PointKey::Kind::segment_plane: {
      const auto& e = in.segment_ends[SegmentId(key.id[0])];
      d.kind = Definition::Kind::line_plane;
      d.points = {e[0], e[1], VertexId(), VertexId()};
      d.planes[0] = RefineInput::plane(SourceId(key.id[1]));
      break;
    }
    case PointKey::Kind::segments: {
      const auto &e = in.segment_ends[SegmentId(key.id[0])], &f = in.segment_ends[SegmentId(key.id[1])];
      d.kind = Definition::Kind::line_line;
      d.points = {e[0], e[1], f[0], f[1]};
      break;
    }
    case PointKey::Kind::planes:
      d.kind = Definition::Kind::three_planes;
      for (int i = 0; i < 3; ++i) d.planes[i] = RefineInput::plane(SourceId(key.id[i]));
      break;
  }
  return d;
}

}  // namespace cnrg
