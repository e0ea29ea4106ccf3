// A sphere that shares circles about several axes: its facets are the convex hull of the points of these circles
// and of points between them.
//
// A grid of meridians and parallels has circles about one axis only. The hull of points of a sphere has them all
// for vertices, and a chord of a circle for an edge as soon as no other point is nearer to its middle than its
// ends; so points between the circles keep that distance, and what decides is the set of points and no order.
#pragma once

#include "csg/carriers/axes.h"
#include "csg/curves/boundary_curves.h"

namespace cnrg {

/// Corners of a circle on a sphere, each joined to the next one, the last to the first.
using SphereCircle = std::vector<RationalPoint>;

struct BallHull {
  std::vector<RationalPoint> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from outside
  /// Chords that are no edges: circle and corner.
  std::vector<std::array<std::size_t, 2>> missed;
};

/// `points`: further ones to have, exactly, and `others`, but for those next to one that is there already. Between
/// all of these lie those of meridians and rows about the z axis, at parts of a turn and of the way from pole to
/// pole, that keep their distance.
BallHull hull_of(const Ball& ball, const std::vector<SphereCircle>& circles,
                 const std::vector<RationalPoint>& points, const std::vector<RationalPoint>& others,
                 const CurveSteps& around, const CurveSteps& up);

/// The hull as a leaf, with the parameters of a sphere about the z axis.
std::unique_ptr<PreparedLeaf> tessellate(const Ball& ball, const BallHull& hull, LeafParameters* record);

}  // namespace cnrg
