// Groups on a cubical grid, and the rules of csg/SEMANTICS.md#the-tables by brute force, without the kernel.
//
// A cell is a point of {0 .. 2n}^3: an odd coordinate is an open unit interval, an even one a grid point. A group
// holds which cubes are inside and which lower cells are entities; the outermost layer of cubes stays outside, so
// that every cell of a group has all its neighbours. Everything is a plain loop over all cells.
#pragma once

#include <array>
#include <random>
#include <vector>

namespace cubical {

using Cell = int;  // x + m (y + m z)

class Grid {
 public:
  explicit Grid(int n);
  int n() const { return n_; }
  int cells() const { return static_cast<int>(dimension_.size()); }
  std::array<int, 3> position(Cell c) const { return {c % m_, c / m_ % m_, c / (m_ * m_)}; }
  Cell at(int x, int y, int z) const { return x + m_ * (y + m_ * z); }
  int dimension(Cell c) const { return dimension_[c]; }
  /// Cells of one dimension less on the boundary, of one more around.
  const std::vector<Cell>& boundary(Cell c) const { return boundary_[c]; }
  const std::vector<Cell>& around(Cell c) const { return around_[c]; }
  /// The cubes whose closure holds the cell (less than all on the rim of the grid).
  const std::vector<Cell>& cubes(Cell c) const { return cubes_[c]; }
  bool on_rim(Cell c) const;

 private:
  int n_, m_;
  std::vector<int> dimension_;
  std::vector<std::vector<Cell>> boundary_, around_, cubes_;
};

struct Group {
  std::vector<char> inside;  // by cell; cubes only
  std::vector<char> entity;  // by cell; dimensions 0 to 2, closed
  std::vector<int> region;   // by cell; cubes only; detected, from 1
  std::vector<char> cut;     // by cell, or empty: entities in the interior of a maximal rectangle, no features
  int region_count = 0;
  friend bool operator==(const Group&, const Group&) = default;
};

/// Closes the entities under boundary, adds missing walls between inside and outside, detects regions.
void complete(const Grid& grid, Group& g);
/// Boxes (or noise) of a few regions, extra faces (cracks, sheets), wires and points, `loose` times as many as
/// usual.
Group random_group(const Grid& grid, std::mt19937_64& random, bool noise, double loose = 1);
/// The region that holds a cell that is no entity (all around it is one), or -1 where there is none such.
int region_around(const Grid& grid, const Group& g, Cell c);

enum class Op { unite, intersect, subtract };
/// The tables; `dominant`: a dominates b.
Group boolean_operation(const Grid& grid, Op op, bool dominant, const Group& a, const Group& b);
Group complement(const Grid& grid, const Group& g);
Group regularize(const Grid& grid, const Group& g);

/// Counts of active cells by dimension after merging all that is coplanar or collinear of one state; `state` by
/// cell, 0: inactive (the rim must be inactive).
std::array<std::size_t, 4> canonical_counts(const Grid& grid, const std::vector<int>& state);

/// A face as a rectangle of the grid: position of its lower corner, extents in units (0 along its normal), regions
/// on the side of the positive axis and of the negative one.
struct Rectangle {
  std::array<int, 3> low, extent;
  int axis, front, back;
};
/// Faces of the group as rectangles, maximal ones if `large` (their regions are the same all over).
std::vector<Rectangle> rectangles(const Grid& grid, const Group& g, bool large);
/// Marks as `cut` the edges and vertices that lie in the interior of a maximal rectangle and on no border of one,
/// nor on a wire: what a group of maximal rectangles does not name.
void mark_cuts(const Grid& grid, Group& g);
/// Edges that bound no face of the group, as unit segments or maximal ones (start, axis, length).
struct Segment {
  std::array<int, 3> low;
  int axis, length;
};
std::vector<Segment> wires(const Grid& grid, const Group& g, bool large);
/// Vertices that bound no edge of the group.
std::vector<std::array<int, 3>> points(const Grid& grid, const Group& g);

}  // namespace cubical
