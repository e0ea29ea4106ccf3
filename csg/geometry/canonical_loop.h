// Closed walks of numbered points in a form of their own: whoever has the same walks writes the same lists.
#pragma once

#include <cstdint>
#include <vector>

namespace cnrg {

using PointLoop = std::vector<std::uint32_t>;

/// Rotates a cyclic list to its lexicographically least form.
void rotate_to_least(PointLoop& loop);
/// Outer loop first (of a planar face it is the one with the least point), then the others in order.
void put_in_order(std::vector<PointLoop>& loops);

}  // namespace cnrg
