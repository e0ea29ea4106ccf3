// Planes and half-spaces: leaves that go on forever.
//
// Refinement takes polygons only. So a plane is drawn as its section with the *frame*, a box around all other
// leaves and all places where planes meet; what reaches the frame stands for what reaches infinity. How large the
// frame must be is known when all leaves of a tree are: not the leaf makes its polygon, but `make_soup`.
#pragma once

#include "csg/leaves/leaf.h"
#include "kernel/complex/plane_cut.h"

namespace cnrg {

/// A plane or a half-space. It has no geometry of its own: `make_soup` adds its polygon in the frame.
class UnboundedLeaf final : public PreparedLeaf {
 public:
  /// `solid`: region 1 on the back of the plane.
  UnboundedLeaf(const RationalPoint& point, const RationalPoint& normal, bool solid);
  /// Adds an empty leaf.
  LeafId add_to(Soup& soup, const Transform& transform) const override;
  std::vector<Attributes> regions() const override;
  bool unbounded() const override { return true; }
  bool solid() const { return solid_; }
  /// The plane's image; its front stays the image of the front, also under reflections.
  ExactHalfspace image(const Transform& transform) const;

 private:
  RationalPoint point_, normal_;
  bool solid_;
};

/// A box that has strictly inside of it the box `points` (if not null), a point of every plane and of every line
/// common to two, and every point common to three: so its inside shows the whole arrangement of the planes. No
/// plane passes through its corner `high`. Cost: the cube of the number of different planes.
ExactBox frame_box(const ExactBox* points, const std::vector<ExactHalfspace>& planes);

}  // namespace cnrg
