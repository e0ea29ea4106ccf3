// Which region of a result holds a point, told quickly in doubles: for what counts and proposes, not for what
// decides. (A Locator of the kernel decides, exactly.)
//
// The first triangle that a ray meets has the region on the side that it is met from. One ray in a direction that
// no model has is enough: where it passes an edge so closely that doubles miss both triangles, it is wrong once in
// a very long time, and a count of tetrahedra is not the worse for it.
#pragma once

#include <memory>
#include <vector>

#include "csg/result/rounding.h"

namespace cnrg {

class RegionLocator {
 public:
  using Vector = std::array<double, 3>;
  /// `flat` must outlive it. Points are those of `flat`, rounded.
  RegionLocator(const FlatComplex& flat, const RoundedPoints& points);
  ~RegionLocator();
  RegionLocator(RegionLocator&&) noexcept;

  /// The number of the region of a point that lies on no face; kNone if it has none. Any number of threads may
  /// ask.
  FlatComplex::Index at(const Vector& p) const;
  /// The shortest of some chords through a point from face to face, or `most`, if none is as short: how thick the
  /// region is there, within a tenth or two.
  double thickness(const Vector& p, double most) const;

  /// False only if no face passes through the box.
  bool meets_faces(const Vector& low, const Vector& high) const;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;

  /// How far it is from a point to the first face, at most so far; lengths are those of `along`.
  double free_way(const Vector& p, const Vector& along, double most) const;
};

}  // namespace cnrg
