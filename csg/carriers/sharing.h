// Which leaves may be drawn with regard to each other, at a glance.
#pragma once

#include <cstdint>
#include <vector>

#include "csg/leaves/leaf.h"

namespace cnrg {

/// Of each instance a number: how leaves are drawn by `with_common_lines` depends on no leaf with another number.
/// Curved leaves may share a surface, and flat ones may touch a surface of revolution. It may say that more do
/// than do.
std::vector<std::uint32_t> sharing_groups(const std::vector<LeafInstance>& instances);

}  // namespace cnrg
