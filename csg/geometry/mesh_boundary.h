// Do polygons enclose a volume? Their edges, and the boundary of their sum.
//
// They do when their boundary, as a chain of directed edges with integer coefficients, is zero. It may be zero in
// space though not edge by edge: where one polygon has the edge a-b and its neighbours have a-m and m-b (a
// T-junction), the pieces cancel on the line. Both are decided here, exactly.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

/// An edge of a polygon, from `low` to `high` (low < high) if `forward`, else the other way.
struct PolygonSide {
  std::uint32_t low, high, face;
  bool forward;
};

/// The edges of polygons, those of equal ends next to each other.
class SideTable {
 public:
  /// `sides` in any order; `point_count` bounds their ends. Linear but for points of high degree.
  SideTable(const std::vector<PolygonSide>& sides, std::size_t point_count);
  /// All sides, sorted by (low, high).
  std::span<const PolygonSide> sides() const { return sides_; }
  /// Calls `visit(std::span<const PolygonSide>)` for every undirected edge.
  template <class Visit>
  void each_edge(Visit visit) const {
    for (std::size_t i = 0; i < sides_.size();) {
      std::size_t j = i + 1;
      while (j < sides_.size() && sides_[j].low == sides_[i].low && sides_[j].high == sides_[i].high) ++j;
      visit(std::span<const PolygonSide>(sides_.data() + i, j - i));
      i = j;
    }
  }

 private:
  std::vector<PolygonSide> sides_;
};

/// An edge with its coefficient in a chain, not zero.
struct ChainEdge {
  std::uint32_t from, to;
  std::int64_t coefficient;
};

/// The boundary edge by edge; modulo 2 with `parity` (then coefficients are 1).
std::vector<ChainEdge> boundary(const SideTable& table, bool parity);

/// True if collinear pieces of `chain` cancel everywhere, so that it is zero in space. `point` gives the exact
/// coordinates of an index; different indices must be different points. Mostly cheap for chains that are not zero.
/// On false, `example` (if not null) is an edge that does not cancel.
bool vanishes(const std::vector<ChainEdge>& chain, bool parity,
              const std::function<RationalPoint(std::uint32_t)>& point, ChainEdge* example = nullptr);

}  // namespace cnrg
