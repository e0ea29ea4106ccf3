// What is between the facets of a leaf and its true surfaces, from above.
//
// A cell of a patch has a map F to its facet and S to its surface (pieces.h). A point that is inside of one and
// not of the other is passed by (1 - t) F + t S for some t from 0 to 1. What all of a cell pass by has at most the
// volume of the integral of |(S - F) . n| over u, v and t, n the cross product of the derivatives there. S - F is
// 0 at the corners, or as near to it as they are to the surface, so bounds of its derivatives bound it in between.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "csg/curves/surface_placed.h"
#include "csg/leaves/leaf.h"
#include "csg/leaves/parameters.h"

namespace cnrg {

/// Between two planes at right angles to each of some directions.
class Slabs {
 public:
  static constexpr std::size_t kDirections = 13;  // to faces, edges and corners of a cube
  static Slabs everything();
  static Slabs nothing() { return {}; }
  /// `far`: as far around.
  void extend(const std::array<Interval, 3>& p, double far);
  Slabs hull(const Slabs& other) const;
  Slabs common(const Slabs& other) const;
  bool meets(const Slabs& other) const;
  bool inside(const Slabs& other) const;
  friend bool operator==(const Slabs&, const Slabs&) = default;

 private:
  Slabs();
  std::array<double, kDirections> low_, high_;
};

class SweptLeaf {
 public:
  explicit SweptLeaf(const LeafInstance& placed);
  /// False for one with curved faces of which only the facets are known, as of a CAD model.
  bool known() const { return known_; }
  /// Nothing is outside of them, neither of the facets nor of the surfaces.
  const Slabs& slabs() const { return slabs_; }
  /// Of what is swept; of cells that meet `within`, or parts of cells.
  double volume() const { return volume_; }
  double volume(const Slabs& within) const;

 private:
  struct Cell {
    std::array<std::array<Interval, 3>, 4> corners{};
    std::array<std::array<Interval, 2>, 4> at{};
    std::uint8_t corner_count = 0;
    double far = 0;                       ///< no point of the surface is farther from that of the facet
    double volume = 0;                    ///< from above
    std::array<double, 2> of_part{0, 0};  ///< the same of a part, per share of the sides 0 1 or 1 2
    Slabs slabs = Slabs::nothing();
  };
  /// `points` and `values`: by the numbers of the corners.
  void add(const std::vector<std::array<Interval, 3>>& points, const std::vector<Interval>& values,
           std::span<const LeafParameters::Corner> corners);
  static void finish(const PlacedSurface& surface, int parts, Cell& cell);
  std::vector<Cell> cells_;
  std::vector<std::unique_ptr<const PlacedSurface>> surfaces_;
  Slabs slabs_ = Slabs::nothing();
  double volume_ = 0;
  bool known_ = true;
};

}  // namespace cnrg
