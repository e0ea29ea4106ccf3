// Which region of a result holds a point, told quickly in doubles: for what counts and proposes, not for what
// decides. (A Locator of the kernel decides, exactly.)
//
// The first triangle that a ray meets has the region on the side that it is met from. One ray in a direction that
// no model has is enough: where it passes an edge so closely that doubles miss both triangles, it is wrong once in
// a very long time, and a count of tetrahedra is not the worse for it.
#pragma once

#include <memory>

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
  /// How far the face that is about parallel is from a point of a triangle, seen through a region along the unit
  /// vector that points into it; or `most`, if there is none as near, if it meets that of the triangle, or if
  /// another one is first. `triangle`: its place among all, face by face.
  double gap(const Vector& p, const Vector& into, FlatComplex::Index region, std::size_t triangle,
             double most) const;

  /// False only if no face passes through the box.
  bool meets_faces(const Vector& low, const Vector& high) const;

 private:
  struct Data;
  std::unique_ptr<const Data> data_;

  struct Wall;
  /// The first face on the way from a point, if it is nearer than `most`; lengths are those of `along`. `but`: not
  /// this triangle.
  Wall wall(const Vector& p, const Vector& along, double most, std::size_t but = std::size_t(-1)) const;
};

}  // namespace cnrg
