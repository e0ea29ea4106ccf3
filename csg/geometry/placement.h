// Products of many transforms.
//
// A product of k rotations has numbers of k times as many digits as one. As 12 fractions it costs a greatest
// common divisor of long numbers for each sum, which grows with the square of the digits. Here it is one integer
// matrix over one denominator, in lowest terms: a factor costs products of long by short numbers, and what cancels
// is found by short numbers, too (see `operator*`).
#pragma once

#include <array>

#include "csg/geometry/transform.h"

namespace cnrg {

class Placement {
 public:
  Placement() = default;  ///< the identity
  explicit Placement(const Transform& transform);
  /// First `inner`, then this. Fast when `inner` has short numbers, whatever this has.
  Placement operator*(const Placement& inner) const;
  Transform transform() const;
  /// How many bits the longest of its numbers has.
  std::size_t bits() const;

  /// Some order; equal ones are equal maps.
  friend bool operator<(const Placement& a, const Placement& b) { return a.numbers_ < b.numbers_; }

 private:
  const Integer& at(std::size_t row, std::size_t column) const { return numbers_[row * 4 + column]; }
  Integer& at(std::size_t row, std::size_t column) { return numbers_[row * 4 + column]; }
  const Integer& denominator() const { return numbers_[12]; }

  // Three rows of four, the last column is the offset; then the denominator, greater than 0. Together their
  // greatest common divisor is 1.
  std::array<Integer, 13> numbers_{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1};
};

}  // namespace cnrg
