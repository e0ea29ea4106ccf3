// Two cells of surfaces of revolution about one axis, between the same half-planes: asked in a half-plane.
//
// Two balls nearly in one place cross at an angle of a thousandth, along a circle all around. To tell by normals
// that they do, cells would have to be a thousandth wide in both directions. But for all t a point of H is in the
// half-plane of its angle (piece_columns.cpp). There a cell is one curve, the same in all half-planes of a column
// but for a common factor of the distance from the axis. Where two such curves cross at an angle, or are apart,
// for all t, so are the cells.
//
// H is a Bernstein polynomial in t, and so are differences of points and products of tangents. They keep their
// sign if all their coefficients have it: two polygons are compared with each other, and two surfaces, which is
// much less than to compare all that is between a polygon and its surface.
//
// Axes, half-planes and corners are rounded. What is proven here holds with a margin that is far wider than that,
// and so it holds for what differs so little from it, derivatives included.
#pragma once

#include "csg/certify/piece_parts.h"

namespace cnrg {

enum class Coaxial : std::uint8_t {
  other,  ///< not about one axis, or not in one column or in two that are side by side
  open,
  apart,
  crossing,  ///< at an angle, wherever they meet
};
Coaxial ask_coaxial(const std::vector<Piece>& all, const Piece& a, const Piece& b, Between between);

}  // namespace cnrg
