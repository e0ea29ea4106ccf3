// Fans (fans.h) of so many triangles that to take all pairs of them, if only for a glance, is too much: the side
// of a cone, the poles of a ball. Their triangles meet in the middle of the fan and in the sides that neighbours
// share, so all that is left to find is which neighbours are coplanar.
#pragma once

#include <utility>
#include <vector>

#include "kernel/refine/input.h"

namespace cnrg {

class LargeFans {
 public:
  /// `fans` by vertex, of `embedded_fans`. Those found here that look along no axis are added to it.
  LargeFans(const RefineInput& input, std::vector<char>& fans);
  bool at(VertexId v) const { return large_[v.index()] != 0; }
  /// The faces on both sides of each edge from the middle of such a fan.
  std::vector<std::pair<SourceId, SourceId>> neighbours() const;

 private:
  const RefineInput& in_;
  std::vector<char> large_;
};

}  // namespace cnrg
