// Elements of second order as Gmsh has them: the ends of the edges whose middles follow the corners, by dimension.
#pragma once

#include <array>
#include <cstddef>

namespace cnrg {

using EdgeOfCorners = std::array<std::size_t, 2>;
inline constexpr std::array<EdgeOfCorners, 0> kEdges0{};
inline constexpr std::array<EdgeOfCorners, 1> kEdges1{{{0, 1}}};
inline constexpr std::array<EdgeOfCorners, 3> kEdges2{{{0, 1}, {1, 2}, {0, 2}}};
inline constexpr std::array<EdgeOfCorners, 6> kEdges3{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}}};

}  // namespace cnrg
