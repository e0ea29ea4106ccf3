// Is a point within some distance of a polygon, as seen along its normal?
#pragma once

#include "csg/weld/planes.h"

namespace cnrg::welding {

/// True for a point over the polygon (enclosed by its loops an odd number of times), and within `d` of its border
/// in space. In doubles: at the border itself either answer is a good one. `normal` of any length.
bool is_in(const WeldModel::Loops& loops, const std::vector<Vector>& points, const Vector& normal, const Vector& p,
           double d);

}  // namespace cnrg::welding
