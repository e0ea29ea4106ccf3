// A mesh of tetrahedra brought to the true surfaces: points on curved faces are moved to them, and elements are
// made quadratic, with nodes in the middles of their edges.
//
// A mesh of facets is as far from a curved solid as the facets are, and its volume is off by the square of their
// size. Quadratic elements whose middles of edges lie on the surfaces follow these to the third power. Points and
// middles on a face lie on its surface, those on an edge between faces on all of their surfaces, as a common point
// found by Newton's method; where that finds none, and on faces that have no true surface, they stay where they
// were. Moved nodes may fold an element. So each one is proven to be turned right everywhere (second_order.h), or
// it and what it shares with others goes back: first middles to the straight edges, then points to where they
// were. An element with two sides on one smooth surface can never bend: it is left out where nothing else is at
// the edge between them.
#pragma once

#include "csg/mesh/tetrahedra.h"

namespace cnrg {

/// The bound of quality to ask for where none is given: thin tetrahedra cannot bend.
inline constexpr double kCurvedQuality = 1.4;

/// `view` has parameters (ResultView::parameters). The mesh becomes one of second order, volumes of regions are
/// those of the quadratic elements, to the accuracy of doubles. Throws Stopped; then the mesh is of no use.
CurvedReport curve(const ResultView& view, TetrahedralMesh& made, const Watch& watch = {});

}  // namespace cnrg
