// Tetrahedra of second order: whether one is turned right everywhere, and how much it holds.
//
// Ten nodes say where the corners and the middles of the edges are; in between the map from the straight
// tetrahedron is quadratic. Its determinant is a cubic polynomial, and a mesh is of use only where that is
// positive in all points. To look at the nodes or at points of quadrature is the usual way, and proves nothing
// about the points between. Written in Bernstein's form a polynomial is a mean of its 20 coefficients at each
// point, so if these are positive it is; if not, the same holds for the two halves of the tetrahedron, whose
// coefficients are nearer to the polynomial. Coefficients are intervals, so that rounding cannot prove what is
// wrong.
#pragma once

#include <array>
#include <cstddef>

namespace cnrg {

/// Corners 0 1 2 3, then the middles of 01, 12, 02, 03, 13, 23.
using SecondOrderNodes = std::array<std::array<double, 3>, 10>;

/// The ends of the edges whose middles are nodes 4 to 9.
using TetrahedronEdges = std::array<std::array<std::size_t, 2>, 6>;
inline constexpr TetrahedronEdges kSecondOrderEdges{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};
/// The same as Gmsh has them.
inline constexpr TetrahedronEdges kGmshEdges{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}}};
/// The same of triangles, lines and points.
inline constexpr std::array<std::array<std::size_t, 2>, 3> kSecondOrderTriangle{{{0, 1}, {1, 2}, {0, 2}}};
inline constexpr std::array<std::array<std::size_t, 2>, 1> kSecondOrderLine{{{0, 1}}};
inline constexpr std::array<std::array<std::size_t, 2>, 0> kSecondOrderPoint{};

/// True if the determinant is positive everywhere, proven; false if it is not or could not be proven.
bool has_positive_determinant(const SecondOrderNodes& nodes);

/// Six times the volume, and six times that of the corners' tetrahedron.
std::array<double, 2> six_volumes(const SecondOrderNodes& nodes);

}  // namespace cnrg
