// True surfaces under a transform, and the common point of several of them.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "csg/curves/surface_math.h"
#include "csg/geometry/transform.h"
#include "csg/leaves/leaf.h"

namespace cnrg {

class PlacedSurface final : public Surface {
 public:
  PlacedSurface(std::shared_ptr<const LeafSurfaces> leaf, std::uint32_t patch, const Transform& transform);
  /// True if the patch is flat: then nothing else may be asked.
  bool flat() const { return surface_ == nullptr; }
  SurfaceJet<double> at(double u, double v) const override;
  SurfaceJet<Interval> over(const Interval& u, const Interval& v) const override;
  std::optional<SurfaceBend> bend_over(const Interval& u, const Interval& v) const override;
  std::optional<Vector3<Interval>> fan_over(std::size_t around, double pole, const Interval& u,
                                            const Interval& v) const override;
  std::optional<Revolution> revolution() const override;

 private:
  template <class N>
  SurfaceJet<N> moved(const SurfaceJet<N>& jet) const;

  std::shared_ptr<const LeafSurfaces> leaf_;  // holds the surface
  const Surface* surface_ = nullptr;
  bool shifted_;                                                       // no more than that
  std::array<Vector3<surface_math::Constant>, 3> linear_, cofactors_;  // rows
  Vector3<surface_math::Constant> offset_;
};

/// The surfaces and curves of a leaf where a transform put them; of a leaf that has none, none. `complete`: its
/// facets went with them.
SurfaceSource moved(const SurfaceSource& leaf, const Transform& transform, bool complete = true);

/// A surface with a place on it, or a plane where `surface` is null.
struct SurfaceSite {
  const PlacedSurface* surface = nullptr;
  std::array<double, 2> at{0, 0};
  std::array<double, 2> reach{0, 0};                ///< no step of a search is longer, in each parameter
  Vector3<double> point{0, 0, 0}, normal{0, 0, 0};  ///< of the plane
};
/// The point that lies on all of up to three surfaces, near to `point`: by the points of each that are next to it
/// and the planes that touch there, over and over. Moves `at` of the sites along. Nothing if it does not converge.
std::optional<Vector3<double>> find_common(std::span<SurfaceSite> sites, const Vector3<double>& point);

}  // namespace cnrg
