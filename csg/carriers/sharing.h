// Which leaves may share a curved surface, at a glance.
#pragma once

#include <cstdint>
#include <vector>

#include "csg/leaves/leaf.h"

namespace cnrg {

/// Of each instance a number: how leaves are drawn by `with_common_lines` depends on no leaf with another number.
/// Leaves without curved surfaces have numbers of their own. It may say that more share something than do.
std::vector<std::uint32_t> sharing_groups(const std::vector<LeafInstance>& instances);

}  // namespace cnrg
