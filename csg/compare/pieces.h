// A set of cells as people see it: connected pieces, each with its size and a point in it.
//
// A difference of two values is a set of cells of the refinement: the piece that a corner of a box sticks out has
// a 3-cell or many, faces, edges and vertices. People see one piece of some volume. So cells that meet are one
// piece, what bounds a larger cell of the piece is not counted by itself, and what is left is counted as it is
// after simplification.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "csg/compare/root_sum.h"
#include "kernel/selection/selection.h"

namespace cnrg {

/// A length or an area that may be infinite.
struct Extent {
  RootSum sum;
  bool unbounded = false;
  bool is_zero() const { return !unbounded && sum.is_zero(); }
};

/// How much there is of a set: of each dimension the cells that bound no larger one of the set.
struct Size {
  std::optional<Rational> volume = Rational(0);  ///< nothing: unbounded
  Extent area, length;
  std::size_t points = 0;
  void add(const Size& other);
};

struct SetPiece {
  CellSet cells;  ///< connected
  Size size;
  std::array<std::size_t, 4> counts{};  ///< by dimension, simplified: points, wires, faces, 3-cells
  RationalPoint at;                     ///< in a cell of the largest dimension, or between such cells in the piece
  int dimension() const { return counts[3] ? 3 : counts[2] ? 2 : counts[1] ? 1 : 0; }
};

/// The pieces of each of some disjoint sets, the largest first: by volume, then area, length and number of points;
/// equal ones by their point.
std::vector<std::vector<SetPiece>> pieces_of(const Complex& complex, const std::vector<CellSet>& sets);

}  // namespace cnrg
