// Leaves of revolution that touch one another about one axis, tessellated together.
#pragma once

#include <map>

#include "csg/carriers/axes.h"
#include "csg/leaves/leaf.h"

namespace cnrg {

/// What an instance must have in its tessellation beside what it shares with others about its axis.
struct Marks {
  std::vector<RationalPoint> directions;  ///< at right angles to the axis: unit vectors, exactly
  std::vector<RationalPoint> points;      ///< on balls, whole ones or parts
  std::vector<MeridianPoint> circles;     ///< on arcs, as `place` (axes.h) has them
  bool needed = false;                    ///< some are no vertices of the leaf as it is
};

/// Replaces the instances concerned. `pairs`: instances whose boxes meet, each once; `marks`: by instance, in the
/// space of the tree.
void share_axes(std::vector<LeafInstance>& instances, const std::vector<std::array<std::uint32_t, 2>>& pairs,
                const std::map<std::uint32_t, Marks>& marks);

}  // namespace cnrg
