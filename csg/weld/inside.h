// Is a point within some distance of a polygon, as seen along its normal? Do polygons lie on each other?
#pragma once

#include "csg/weld/planes.h"

namespace cnrg::welding {

/// True for a point over the polygon (enclosed by its loops an odd number of times), and within `d` of its border
/// in space. In doubles: at the border itself either answer is a good one. `normal` of any length.
bool is_in(const WeldModel::Loops& loops, const std::vector<Vector>& points, const Vector& normal, const Vector& p,
           double d);

/// True for two convex polygons of nearly one plane that have more in common than a strip of width d; of others
/// that are not convex true also where only their hulls have. Their outer loops decide.
bool overlap(const WeldModel::Loops& a, const WeldModel::Loops& b, const std::vector<Vector>& points,
             const Vector& normal, double d);

}  // namespace cnrg::welding
