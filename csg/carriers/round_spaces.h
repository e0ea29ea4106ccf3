// Spaces in which leaves are round.
//
// A ball that is stretched is none, but an ellipsoid and a stretched box touch where a ball and a box do. So what
// leaves have in common is decided before they are stretched: those whose transforms differ by a similarity are
// round in one space, which is that of the tree where they are not stretched at all.
#pragma once

#include "csg/carriers/extra_lines.h"
#include "csg/carriers/tangency.h"

namespace cnrg {

/// How a transform stretches, as a symmetric matrix: equal for transforms that differ by a similarity.
using Metric = std::array<Rational, 6>;
Metric metric_of(const Transform& transform);

struct RoundSpace {
  SharedTransform base{};                          ///< to the space of the tree
  Transform to_space{};                            ///< and back
  std::vector<std::uint32_t> instances;            ///< that share something or may do so, ascending
  std::vector<std::array<std::uint32_t, 2>> near;  ///< pairs that may have an axis in common
  Contacts contacts;                               ///< about no common axis
  /// The transform of an instance to this space.
  Transform relative(const Transform& transform) const {
    return base->identity() ? transform : to_space * transform;
  }
};

/// `revolved`: all revolved instances, with their transforms and boxes in the tree; `pairs`: those whose boxes
/// meet, each once; `near`: those of `near_axes`; `anew`: revolved ones that are to be drawn in any case; `extra`:
/// instances with further lines.
std::vector<RoundSpace> round_spaces(const std::vector<LeafInstance>& instances,
                                     const std::vector<RevolvedInstance>& revolved,
                                     const std::vector<std::array<std::uint32_t, 2>>& pairs,
                                     const std::vector<std::array<std::uint32_t, 2>>& near,
                                     const std::vector<std::uint32_t>& anew, const ExtraOfInstances& extra);

}  // namespace cnrg
