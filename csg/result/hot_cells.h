// Cubes in which things are drawn together, and what passes through them.
//
// A uniform grid, as snap rounding has it, would take all that is in a cell to the middle of the cell, half a cell
// away, also where two things are a unit in the last place apart. Here a cube lies around a point of the drawing,
// and what is near goes there: nearly all stays where it is, and less of what is around is disturbed.
//
// Points within half a size of a center go there, so centers are farther apart than that. What passes by is drawn
// to a center from half as far only: else of two centers with cells that overlap an edge would be drawn to both,
// and turn between them by as much as they are apart.
//
// All is told in doubles, so what only touches a cell may be missed or told: who routes something through the
// centers of cells looks at what comes out.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "kernel/base/point_hash.h"
#include "kernel/base/progress.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {

class HotCells {
 public:
  using Xyz = std::array<double, 3>;
  /// A cell, by its number in the order of centers, and where what passes is nearest to its center.
  struct Pass {
    std::size_t cell = 0;
    double along = 0;  ///< of a segment: the part of its length that lies before that place, in (0, 1)
    Xyz foot{};        ///< of a plane
  };

  /// Each point that lies in no cell of a point before it becomes the center of one; so centers are more than half
  /// a size apart, and cells may overlap. `size`: the length of an edge of a cell (units of the model).
  HotCells(const std::vector<Xyz>& points, double size);

  const std::vector<Xyz>& centers() const { return centers_; }
  const Xyz& center(std::size_t cell) const { return centers_[cell]; }
  /// Of the cells that the point lies in or on that with the nearest center; nothing if there is none.
  std::optional<std::size_t> cell_of(const Xyz& p) const;
  /// A segment or plane passes through a cell when it comes so near to the center, in sizes, along each axis.
  static constexpr double kPass = 0.25;
  /// The cells that a segment passes through, from a to b.
  std::vector<Pass> along(const Xyz& a, const Xyz& b) const;
  /// The cells that the plane of a triangle passes through and that meet the box around the triangle.
  std::vector<Pass> across(const Xyz& a, const Xyz& b, const Xyz& c) const;

 private:
  double size_;
  std::vector<Xyz> centers_;
  std::unordered_map<Xyz, std::vector<std::uint32_t>, HashPoint> in_cube_;  // centers in each cube of a grid
  BoxTree tree_;

  const std::vector<Xyz>& choose_centers(const std::vector<Xyz>& points);
};

/// The middles between segments without a common end that pass at most `within` from each other (units of the
/// model), there; not where an end is nearest.
std::vector<HotCells::Xyz> where_near(const std::vector<std::array<HotCells::Xyz, 2>>& segments, double within,
                                      const Watch& watch);

}  // namespace cnrg
