// Areas of the plane: what OpenSCAD's 2D modules make, until an extrusion makes a solid of them.
//
// OpenSCAD (2021.01) unites, cuts and cleans areas on a grid of 1/65536 by Clipper. So corners go onto that grid,
// towards zero, before a Boolean. The Boolean here is exact: edges are split where they meet, and a piece bounds
// the result if the result is on one side of it only. What the grid does not have is then rounded to it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace cnrg::openscad {

using Point2 = std::array<double, 2>;
using Loop = std::vector<Point2>;

/// The points that the loops go round an odd number of times.
struct Area {
  std::vector<Loop> loops;
  /// Loops are simple, touch in corners at most, and have the inside on their left.
  bool is_clean = false;
};

/// Whether a point is in the result, by whether it is in each operand.
using Membership = std::function<bool(const std::vector<bool>& in)>;

/// A clean area on the grid.
Area combine(const std::vector<Area>& operands, const Membership& membership);
/// The same area, clean; on the grid, if it was not clean.
Area cleaned(const Area& area);
/// The least convex area around all; empty, if all points are on a line.
Area hull(const std::vector<Area>& operands);
/// p -> M p, M two rows of three.
Area transformed(const Area& area, const std::array<std::array<double, 3>, 2>& matrix);

/// True if the area is one convex polygon.
bool is_convex(const Area& area);
/// Triangles over the corners of all loops of a clean area, counted one loop after the other; counter-clockwise.
std::vector<std::array<std::uint32_t, 3>> triangles(const Area& area);

}  // namespace cnrg::openscad
