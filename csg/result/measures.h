// Lengths, areas and volumes of the cells of a result, by their numbers in files.
//
// A volume is a fraction. Length and area of what is straight and flat are roots of fractions, whose squares are
// exact; of curves and curved faces they are sums of such roots, one for each straight or flat piece, told as the
// double nearest to a sum that is right to twenty digits.
#pragma once

#include <cstddef>
#include <optional>

#include "csg/result/arrays.h"

namespace cnrg {

/// Each with the arrays of its result.
class Measures {
 public:
  /// Both must outlive this.
  Measures(const Result& result, const ResultArrays& arrays) : result_(result), arrays_(arrays) {}

  /// Infinite for an edge that reaches infinity.
  double length(std::size_t edge) const;
  /// Nothing for an edge that is not straight or reaches infinity.
  std::optional<Rational> squared_length(std::size_t edge) const;

  /// Infinite for a face that reaches infinity.
  double area(std::size_t face) const;
  /// Nothing for a face that is not flat or reaches infinity.
  std::optional<Rational> squared_area(std::size_t face) const;
  /// The integral of the normal of the front over the face: of a flat face its normal, as long as the face has
  /// area; of a curved one what says how much of a uniform flow goes through. Nothing if it reaches infinity.
  std::optional<RationalPoint> area_vector(std::size_t face) const;

  /// In cubic units; nothing for a region that is not bounded.
  std::optional<Rational> volume(std::size_t region) const;
  /// The centre of mass; nothing for a region that is not bounded.
  std::optional<RationalPoint> centroid(std::size_t region) const;

  /// Of all edges, faces and regions, on all threads; vectors three by three, NaN where there is none.
  std::vector<double> lengths(const Watch& watch = {}) const;
  std::vector<double> areas(const Watch& watch = {}) const;
  std::vector<double> area_vectors(const Watch& watch = {}) const;
  std::vector<std::optional<Rational>> volumes(const Watch& watch = {}) const;
  std::vector<std::optional<RationalPoint>> centroids(const Watch& watch = {}) const;

 private:
  RationalPoint point(std::int32_t i) const;
  bool on_frame(std::int32_t point) const;
  bool reaches_frame(std::size_t face) const;
  RationalPoint area_vector(const NumberLists& loops, std::size_t first, std::size_t last) const;

  const Result& result_;
  const ResultArrays& arrays_;
};

}  // namespace cnrg
