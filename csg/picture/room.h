// Where in an area a text has most room.
#pragma once

#include "csg/picture/figure.h"

namespace cnrg {

/// The middle of nearly the largest disk in what the loops enclose, and its radius: the best place within
/// 1/50 of the area's extent (Agafonkin's quadtree search, "polylabel").
Figure::Label::Place place_with_room(const std::vector<std::vector<Point2>>& loops);

}  // namespace cnrg
