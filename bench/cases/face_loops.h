// From the boundary walks of a planar face to the loops of a model's face.
//
// A walk has the face to its left; it may touch itself in points and go along an edge there and back (a slit).
// Loops are simple polygons: the walk is cut where it comes back to a point, and slits, which are inside of the
// point set, fall out.
#pragma once

#include "bench/cases/model.h"

namespace cnrg::bench {

using PointLoop = std::vector<std::uint32_t>;

/// The simple polygons of closed walks, the outer one first. A face is connected, so the outer loop is the only
/// one that runs as the face as a whole does.
std::vector<PointLoop> simple_loops(const std::vector<RationalPoint>& points, const std::vector<PointLoop>& walks);

/// Twice the area vector of a closed loop, by the right-hand rule.
RationalPoint doubled_area(const std::vector<RationalPoint>& points, const PointLoop& loop);

/// The face as seen from its front, by its own points; a face of three points is its own triangle. Coordinates may
/// be rounded, so that the face is only about planar. Throws InvariantError if its loops cross or two of its
/// points are at one place.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const std::vector<RationalPoint>& points,
                                                       const Model::Face& face);

/// Cuts faces that have holes into triangles, so that each has one loop.
void cut_holes(Model& model);

inline Rational dot(const RationalPoint& a, const RationalPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace cnrg::bench
