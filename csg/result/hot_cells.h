// Cells of a uniform grid in which things are drawn together, and what passes through them.
//
// All is told in doubles, so what only touches a cell may be missed or told: who routes something through the
// centers of cells looks at what comes out.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "kernel/base/progress.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {

class HotCells {
 public:
  using Xyz = std::array<double, 3>;
  /// A cell, by its number, and where what passes is nearest to its center.
  struct Pass {
    std::size_t cell = 0;
    double along = 0;  ///< of a segment: the part of its length that lies before that place, in (0, 1)
    Xyz foot{};        ///< of a plane
  };

  /// The cells that hold the points; `size`: the length of an edge of a cell, a power of two (units of the model).
  HotCells(const std::vector<Xyz>& points, double size);

  const std::vector<Xyz>& centers() const { return centers_; }
  const Xyz& center(std::size_t cell) const { return centers_[cell]; }
  /// The first of the cells that the point lies in or on; nothing if there is none.
  std::optional<std::size_t> cell_of(const Xyz& p) const;
  /// The cells that a segment passes through, from a to b.
  std::vector<Pass> along(const Xyz& a, const Xyz& b) const;
  /// The cells that the plane of a triangle passes through and that meet the box around the triangle.
  std::vector<Pass> across(const Xyz& a, const Xyz& b, const Xyz& c) const;

 private:
  double size_;
  std::vector<Xyz> centers_;  // ascending
  BoxTree tree_;
};

/// The middles between segments without a common end that pass at most `within` from each other (units of the
/// model), there; not where an end is nearest.
std::vector<HotCells::Xyz> where_near(const std::vector<std::array<HotCells::Xyz, 2>>& segments, double within,
                                      const Watch& watch);

}  // namespace cnrg
