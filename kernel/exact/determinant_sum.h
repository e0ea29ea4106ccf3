// Exact sums of determinants of points whose coordinates are doubles.
//
// All coordinates are multiples of one power of two, so in units of it every determinant is an integer, and so is
// their sum: no fraction and no rounding. Integers of any size would do, at the price of a call per product;
// mostly the coordinates span few enough bits for numbers of fixed size, which stay in registers.
#pragma once

#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

/// Points by index, as multiples of 2^scale.
class ScaledPoints {
 public:
  /// Appends a point; its coordinates must be finite. To be called before all that follows.
  void add(const double* xyz);
  std::size_t size() const { return size_; }
  /// To be called after the last `add`.
  void scale();
  /// The least exponent of a bit that is set in a coordinate; 0 if there is none.
  int exponent() const { return exponent_; }

 private:
  friend class DeterminantSum;
  std::size_t size_ = 0;
  std::vector<double> xyz_;  // until `scale`
  int exponent_ = 0;
  bool narrow_ = true;  // whether no multiple has more bits than numbers of fixed size are made for
  std::vector<__int128> narrow_xyz_;
  std::vector<Integer> large_xyz_;  // if one has
};

/// A sum of det(r, p, q) of scaled points, in units of 2^(3 exponent).
class DeterminantSum {
 public:
  explicit DeterminantSum(const ScaledPoints& points) : points_(&points) {}
  /// Adds det(r, p, q), or takes it off. Fewer than 2^60 may be added.
  void add(std::size_t r, std::size_t p, std::size_t q, bool plus);
  void add(const DeterminantSum& other);
  Integer value() const;

 private:
  /// (high 2^128 + middle) 2^128 + low.
  struct Wide {
    unsigned __int128 low, middle;
    __int128 high;
    void add(const Wide& other);
  };
  const ScaledPoints* points_;
  Wide sum_{};
  Integer large_ = 0;
};

}  // namespace cnrg
