// Which corners and sides a face has, looked up.
#pragma once

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "kernel/refine/input.h"

namespace cnrg {

/// Is a corner or a side one of a face's? Looked up where there are many, so that a disc with a wall at each of
/// its sides does not cost the square of their number.
class FaceBoundaries {
 public:
  explicit FaceBoundaries(const RefineInput& in) : in_(in) {
    for (const SourceId f : IdRange<SourceId>(in.corners.size())) {
      if (in.corners[f].size() <= kFew) continue;
      Sorted& sorted = large_[f.value()];
      sorted.corners.assign(in.corners[f].begin(), in.corners[f].end());
      sorted.sides.assign(in.sides[f].begin(), in.sides[f].end());
      std::sort(sorted.corners.begin(), sorted.corners.end());
      std::sort(sorted.sides.begin(), sorted.sides.end());
    }
  }
  bool has_corner(SourceId f, VertexId v) const {
    const auto corners = in_.corners[f];
    if (corners.size() <= kFew) return std::find(corners.begin(), corners.end(), v) != corners.end();
    const std::vector<VertexId>& sorted = large_.at(f.value()).corners;
    return std::binary_search(sorted.begin(), sorted.end(), v);
  }
  bool has_side(SourceId f, SegmentId s) const {
    const auto sides = in_.sides[f];
    if (sides.size() <= kFew) return std::find(sides.begin(), sides.end(), s) != sides.end();
    const std::vector<SegmentId>& sorted = large_.at(f.value()).sides;
    return std::binary_search(sorted.begin(), sorted.end(), s);
  }

 private:
  static constexpr std::size_t kFew = 16;
  struct Sorted {
    std::vector<VertexId> corners;
    std::vector<SegmentId> sides;
  };
  const RefineInput& in_;
  std::unordered_map<std::uint32_t, Sorted> large_;
};

}  // namespace cnrg
