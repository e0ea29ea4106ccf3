// Solids that reach the plane z = 0 from below or above in a face, an edge or a vertex at the origin.
//
// They are about 1 wide and more than 1 high. Each is sheared along the plane by its own numbers and gets wider or
// narrower: sides of two of them are in no common plane, and nothing of the contact stays when one of them moves.
#pragma once

#include "bench/cases/solids.h"

namespace cnrg::bench {

enum class Side { below, above };

/// Ends in the polygon; its other end is larger or smaller.
Model slab(const Polygon& end, Side side, Random& random);
/// Ends in the edge from (0, low, 0) to (0, high, 0); its section has `corners`, one of them on that edge.
Model ridge(std::size_t corners, const Rational& low, const Rational& high, Side side, Random& random);
/// Ends in the origin: a pyramid over a polygon of `corners`.
Model spike(std::size_t corners, Side side, Random& random);

/// Polygons of a part of the face that `polygon` (of `random_polygon`, at least four corners) is.
Polygon part_inside(std::size_t corners, Random& random);
Polygon part_across(std::size_t corners, Random& random);  ///< partly outside
Polygon part_at_edge(const Polygon& polygon);              ///< one edge is half of the polygon's first one

}  // namespace cnrg::bench
