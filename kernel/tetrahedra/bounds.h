// Bounds on the tetrahedra of a mesh, and the cost of tetrahedra that break them.
#pragma once

#include <functional>

#include "kernel/tetrahedra/shapes.h"
#include "kernel/tetrahedra/stars.h"

namespace cnrg {

/// So many times as long as is wanted in its middle is an edge at most.
inline constexpr double kLongestEdge = 1.4;

/// The length of edges that is wanted at a place of a region.
using WantedLength = std::function<double(const CornerPoint&, std::int32_t region)>;

/// Is the longest edge longer than it may be beside what is wanted in its middle?
bool is_too_long(const CornerPoint& a, const CornerPoint& b, const CornerPoint& c, const CornerPoint& d,
                 std::int32_t region, const WantedLength& wanted);

struct Bounds {
  double shape = 0;        ///< to the third power, as `Stars::measure` has it, at least
  double radius_edge = 0;  ///< ratio of circumradius to shortest edge at most; 0: no bound
  double volume = 0;       ///< at most; 0: no bound
  WantedLength length{};   ///< empty: any

  /// What is in no region is nobody's care.
  bool keeps(const Stars& mesh, const Stars::Tetrahedron& t) const { return cost(mesh, t) == 0; }
  /// Beyond the volume or the length.
  bool is_large(const Stars& mesh, const Stars::Tetrahedron& t) const;
  /// 0 of one that keeps them. Each that does not counts as one, and one of a bad shape as the logarithm more of
  /// how many times worse than the bound it is: so one that is a little worse is given for two, but one that is
  /// a hundred times worse is not. None that is large is given for shapes.
  double cost(const Stars& mesh, const Stars::Tetrahedron& t) const;
};

}  // namespace cnrg
