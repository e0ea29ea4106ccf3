// Where a vertex may be, so that the tetrahedra at it stay positive: in front of all faces opposite to it.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "kernel/tetrahedra/tetrahedra.h"

namespace cnrg {

/// Bits of places that are tried, the shortest number first.
inline constexpr unsigned kPlaceBits[] = {16, 40, 80, 160};
/// The nearest fraction with 2^bits below.
Rational rounded(const Rational& x, unsigned bits);
/// A place, and those one double beside it along each axis.
std::array<std::array<double, 3>, 7> with_neighbours(const std::array<double, 3>& p);

class Room {
 public:
  Room(PointTable& points, const Tetrahedra& tetrahedra) : points_(points), tetrahedra_(tetrahedra) {}

  /// The double next to a vertex, added to the points, if it may be there; else none.
  VertexId near_double(VertexId v);
  /// Some double that the vertex may be at, on these lines through it but for the last digits; else none.
  VertexId far_double(VertexId v, std::span<const RationalPoint> ways);
  /// A point near the middle of where it may be on a line through it, if it is not near that already; else none.
  VertexId middle(VertexId v, const RationalPoint& way);

 private:
  PointTable& points_;
  const Tetrahedra& tetrahedra_;
  std::vector<Tetrahedra::Index> star_;

  std::optional<std::array<Rational, 2>> free_part(VertexId v, const RationalPoint& way);
};

}  // namespace cnrg
