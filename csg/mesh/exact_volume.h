// Sums of volumes of tetrahedra between points of doubles, exactly.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

/// The coordinates are integers in units of one power of two, so each volume is a determinant of integers.
class ExactVolume {
 public:
  explicit ExactVolume(const std::vector<std::array<double, 3>>& points);
  void clear() { six_ = 0; }
  /// Adds det(b - a, c - a, d - a) / 6, negative where d is on the back of a, b, c.
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
  Rational value() const;

 private:
  std::vector<Integer> scaled_;  ///< three for each point
  std::int64_t exponent_ = 0;    ///< the unit is 2^exponent
  Integer six_ = 0;
  // They keep their memory: of numbers of two words or three, making and freeing them is the dearest part.
  std::array<std::array<Integer, 3>, 3> edges_;
  Integer minor_;
};

}  // namespace cnrg
