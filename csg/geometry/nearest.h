// The nearest points of two points, segments and triangles, exactly: closest points of rational simplices are
// rational, and so is the square of their distance. Only what is nearest in the interior of both is asked for:
// where it is on a boundary, a pair of lower dimensions is as near (csg/result/near.h).
#pragma once

#include <optional>

#include "kernel/exact/exact_vectors.h"

namespace cnrg {

struct NearestPoints {
  RationalPoint a, b;  ///< on the first and on the second
  Rational squared;    ///< of their distance
};

NearestPoints nearest_of_points(const RationalPoint& a, const RationalPoint& b);
/// Of p and the open segment from a to b; nothing if p is nearest to an end.
std::optional<NearestPoints> nearest_in_segment(const RationalPoint& p, const RationalPoint& a,
                                                const RationalPoint& b);
/// Of p and the closed triangle; nothing unless p is straight above or below it. The triangle must have an area.
std::optional<NearestPoints> nearest_in_triangle(const RationalPoint& p, const RationalPoint& a,
                                                 const RationalPoint& b, const RationalPoint& c);
/// Of the open segments from a to b and from c to d; nothing if an end is as near, so also if they are parallel.
std::optional<NearestPoints> nearest_in_segments(const RationalPoint& a, const RationalPoint& b,
                                                 const RationalPoint& c, const RationalPoint& d);

}  // namespace cnrg
