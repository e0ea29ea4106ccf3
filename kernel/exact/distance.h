// The exact distance from points to a set of triangles, segments and points.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "kernel/exact/rational.h"

namespace cnrg {

/// A set of simplices by numbers of points, searched by a tree of boxes.
class DistanceTo {
 public:
  /// There must be one simplex at least. Triangles must not be degenerate.
  DistanceTo(std::span<const RationalPoint> points, std::span<const std::array<std::uint32_t, 1>> vertices,
             std::span<const std::array<std::uint32_t, 2>> segments,
             std::span<const std::array<std::uint32_t, 3>> triangles);
  ~DistanceTo();
  DistanceTo(DistanceTo&&) noexcept;
  /// The square of the Euclidean distance, exactly. Not for several threads at a time.
  Rational squared(const RationalPoint& p) const;

 private:
  struct Trees;
  std::unique_ptr<Trees> trees_;
};

/// The double nearest to the square root of a number that is not negative.
double nearest_root(const Rational& square);

}  // namespace cnrg
