// Planes and half-spaces.
#pragma once

#include "csg/leaves/leaf.h"

namespace cnrg {

/// The plane { p : normal . p = offset }.
struct ExactHalfspace {
  RationalPoint normal;
  Rational offset;
};

/// A plane or a half-space. It has no geometry of its own: `make_soup`, which sees how far the other leaves
/// reach, adds its polygon in the frame.
class UnboundedLeaf final : public PreparedLeaf {
 public:
  /// `solid`: region 1 on the back of the plane.
  UnboundedLeaf(const RationalPoint& point, const RationalPoint& normal, bool solid);
  /// Adds an empty leaf.
  LeafId add_to(Soup& soup, const Transform& transform) const override;
  std::vector<LeafRegion> regions() const override;
  bool unbounded() const override { return true; }
  bool solid() const { return solid_; }
  /// The plane's image; its front stays the image of the front, also under reflections.
  ExactHalfspace image(const Transform& transform) const;

 private:
  RationalPoint point_, normal_;
  bool solid_;
};

/// An axis-parallel box.
struct ExactBox {
  RationalPoint low, high;
};

/// A box that holds strictly inside: `points` box (if not null), a point of every plane, of every line common to
/// two, and every point common to three; so that its inside shows the whole arrangement of the planes. No plane
/// passes through its corner `high`. Cost: the cube of the number of different planes.
ExactBox frame_box(const ExactBox* points, const std::vector<ExactHalfspace>& planes);

/// The polygon plane ∩ box, counter-clockwise as seen from the side of the normal; the plane meets the inside.
std::vector<RationalPoint> cut(const ExactHalfspace& plane, const ExactBox& box);

}  // namespace cnrg
