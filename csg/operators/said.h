// What is said of cells of lower dimension: of faces, edges and vertices.
//
// A group has regions, and each has its attributes. Of entities one cannot say "this face is of leaf a, so it has
// what is said of a": where `a` is rock, its faces are where rock ends, and no sheet of rock. What has attributes
// is what *stands for itself*: a sheet, which is a face that bounds no region, a wire, an isolated point. It has
// them wherever it goes: a fault stays what it is when it becomes the wall between two blocks of rock.
//
// A sheet is said of all cells in its closure. So what two sheets have in common, an edge in the interior of both,
// knows what it is of.
#pragma once

#include <memory>
#include <vector>

#include "csg/materials/attributes.h"
#include "csg/operators/dominance.h"

namespace cnrg {

/// What is said of a cell that stands for itself, or lies in the closure of such cells.
struct Said {
  Attributes attributes{};
  int dimension = 2;  ///< of what it is said of: 2 a sheet, 1 a wire, 0 a point
  friend bool operator==(const Said&, const Said&) = default;
};
/// nullptr: the cell is but a wall of solids, or lies in one. Sheets, wires and points of which nobody has said
/// anything have empty attributes.
using SaidPointer = std::shared_ptr<const Said>;

/// What is said of a cell that two operands have. One that says nothing yields; at a place where a wire lies in a
/// sheet it is the wire, the thing of lower dimension; else the dominant one counts, and of two equals the left
/// one is filled in from the right one.
SaidPointer merged(const SaidPointer& left, const SaidPointer& right, Dominance dominance);

/// What of `right` gives way to `left` at a cell of a dimension without being dominated: only where both are
/// things of this dimension. Wires that cross in a point are not at odds.
std::vector<Yielded> at_odds(const SaidPointer& left, const SaidPointer& right, int dimension);

}  // namespace cnrg
