// Leaves of revolution that touch one another about one axis, tessellated together.
#pragma once

#include <set>

#include "csg/carriers/drawn_leaves.h"
#include "csg/carriers/extra_lines.h"
#include "csg/carriers/round_spaces.h"
#include "csg/leaves/leaf.h"
#include "kernel/base/leaf_words.h"

namespace cnrg {

/// Balls that differ by this part of their size, place and radius together, are drawn about their common axis:
/// they cross at so small an angle that only facets of one kind tell where.
inline constexpr double kNearBalls = 0.03;

/// Of pairs of instances those that may have an axis in common, by doubles.
std::vector<std::array<std::uint32_t, 2>> near_axes(const std::vector<LeafInstance>& instances,
                                                    const std::vector<std::array<std::uint32_t, 2>>& pairs);

/// Replaces the instances of these spaces. `extra`: further lines, and `drawn` gets who has them. `notices`: of
/// banded leaves that stay as they are, `leaf 2, face 3 ...`. `known`: what was drawn before.
void share_axes(std::vector<LeafInstance>& instances, const std::vector<RoundSpace>& spaces,
                const ExtraOfInstances& extra, std::set<std::uint32_t>& drawn, std::vector<LeafWords>& notices,
                DrawnLeaves& known);

}  // namespace cnrg
