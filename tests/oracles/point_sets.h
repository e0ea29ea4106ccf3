// Point sets of scenes by definition: is a point in a leaf, exactly, by rays and nothing else.
#pragma once

#include "tests/scenes/scene.h"

namespace cnrg::properties {

enum class Side : std::uint8_t { outside, boundary, inside };

/// A point of the polygon's plane in a polygon with holes: inside of an odd number of loops.
Side side_in_plane(const std::vector<scenes::Polygon>& loops, const RationalPoint& p);
bool on_polygon(const std::vector<scenes::Polygon>& loops, const RationalPoint& p);
bool on_segment(const RationalPoint& a, const RationalPoint& b, const RationalPoint& p);
/// A closed solid of planar facets.
Side side(const scenes::Solid& solid, const RationalPoint& p);

/// Whether p is in |leaf|.
bool contains(const scenes::Leaf& leaf, const RationalPoint& p);
/// Whether p is on a face, a wire or a point of the leaf; elsewhere all around p is in |leaf|, or nothing is.
bool on_entity(const scenes::Leaf& leaf, const RationalPoint& p);

/// The volume inside of the facets.
Rational volume(const scenes::Solid& solid);
/// No corner lies in front of a facet.
bool convex(const scenes::Solid& solid);
/// The middle of all corners.
RationalPoint middle(const scenes::Solid& solid);

}  // namespace cnrg::properties
