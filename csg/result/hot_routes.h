// A refined drawing, drawn to the centers of hot cells: each edge and face that passes through one gets a corner
// there. Boxes around the cells, refined together with the drawing, would cut it there, too; but their own corners
// are no doubles, and of two surfaces that nearly coincide each such corner crosses the other surface again.
//
// Faces are cut into triangles anew, and their diagonals are chosen by where the corners go, not where they are:
// three corners of a wide triangle may go to one line, and the longest side of that would cross what its middle
// corner is drawn to.
#pragma once

#include <array>
#include <vector>

#include "csg/result/hot_cells.h"
#include "kernel/base/progress.h"
#include "kernel/complex/complex.h"

namespace cnrg {

struct HotRoutes {
  /// Where each point goes: the vertices of the complex by their ids, then the new corners. What lies in a cell
  /// goes to its center, all else to its nearest doubles.
  std::vector<HotCells::Xyz> to;
  std::vector<std::vector<VertexId>> chains;                    ///< of each edge, its ends first and last
  std::vector<std::vector<std::array<VertexId, 3>>> triangles;  ///< of each face, with its direction
  double displacement = 0;                                      ///< no point goes farther (units of the model)
};

/// `settled`: of each vertex, whether it is doubles. The cells of those that are not are hot. So are those in
/// which a vertex or edge is that something else passes through: of all, if asked for, and else of what lies near
/// faces with vertices that are no doubles. `size`: of a cell; `grain`: new centers are multiples of it, a power
/// of two (units of the model). Throws InputError for coordinates beyond the range of doubles; Stopped, as the
/// watch asks.
HotRoutes route(const Complex& complex, const std::vector<char>& settled, bool everywhere, double size,
                double grain, const Watch& watch);

}  // namespace cnrg
