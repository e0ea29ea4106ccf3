// Directions about axes that are parallel but not one, for surfaces of which one touches the other from inside.
//
// A pin of radius r in a bore of radius R, R - r off its axis, touches it along a line. The line alone does not
// keep them apart: chords of the bore beside it cut into the pin. What does is a similarity. About the point of
// contact, in a plane across the axes, it takes the circle of the pin to that of the bore, and the corner of the
// pin in some direction from its axis to that of the bore in the same direction from its own. So if the bore has
// all directions of the pin, the polygon of the pin made larger by R / r about one of its corners is inscribed in
// that of the bore. A convex polygon lies in its image, so the pin is in the bore, exactly and at any fineness.
// Sides next to the contact lie on their images, though, and two strips of the surfaces would be one. So the bore
// has one direction more between that of the contact and each of its neighbours: its corner there lies outside of
// the image, and what the two have in common is the line.
//
// The same holds for a ball in a tube: about the axis through its centre that is parallel to that of the tube, and
// with a circle across it through its centre, it is in its shadow along the axis, which is a polygon as above.
// A tube that touches a larger ball is inside of it in the plane across, and leaves it above and below.
//
// A ball beside the inner half of a torus or in a cone is inside of the cone that touches both. About its own axis
// it has such a cone, too, moved along the line in which they touch; with the same directions the one is in the
// other.
#pragma once

#include <memory>
#include <vector>

#include "csg/carriers/family.h"

namespace cnrg {

/// By their places in a list; `direction`: of the contact, from either axis, exactly a unit vector.
struct NestedFamilies {
  std::size_t inner = 0, outer = 0;
  RationalPoint direction;
};

/// Solves the directions of all families, what is inside before what is around it. Families in a circle, of which
/// each touches the next one from inside, cannot all be finer than the next: one of them, always the same, is not.
void solve_turns(const std::vector<std::shared_ptr<Family>>& families, const std::vector<NestedFamilies>& nested);

}  // namespace cnrg
