// The drawing of a result with some of its points moved, with joints in its segments and facets, refined.
#pragma once

#include <vector>

#include "csg/result/flat_drawing.h"
#include "csg/result/near.h"

namespace cnrg {

/// A point in the interior of a segment or facet that becomes a corner there, and where it goes.
struct Joint {
  Near on = Near::point_segment;  ///< point_segment: of a segment; point_facet: of a facet
  Parts::Index part = 0;
  RationalPoint at, to;
};

struct JoinMoves {
  std::vector<RationalPoint> to;                       ///< by point
  std::vector<Joint> joints{};                         ///< at different points of each part
  std::vector<NumberedDrawing::Triangle> triangles{};  ///< drawn in place of those of the parts, without joints
};

/// All pieces of edges, triangles and free points of the parts' result, moved. What collapses is left out. Throws
/// InputError if all does; Stopped, as the watch asks.
MovedDrawing move(const Parts& parts, const JoinMoves& moves, const Watch& watch = {});

}  // namespace cnrg
