// Iterated snap rounding: a drawing whose vertices all become doubles and that stays a drawing.
//
// A round refines what there is exactly; where that makes vertices that are not doubles (rounding made triangles
// cross), all vertices are rounded, faces are triangulated and the next round begins. It ends when a refinement
// has doubles only: then nothing is left to round, and the refinement is embedded by construction.
//
//   * The first rounding takes each vertex to its nearest doubles.
//   * Later ones take each new vertex to a uniform grid, and with it the vertices of doubles in the same cell of
//     the grid. Doubles near zero are so dense that nearly coincident faces would cross again and again there; on a
//     grid they meet.
//   * The first cell is one unit in the last place of the largest coordinate. From the fourth round on cells grow
//     by the factor 4 each time, so that what still crosses meets in a few rounds. No proof bounds their number
//     (devillers2018 has an algorithm with a proof, of high degree; lazard2025 grows the grid for the same
//     reason): after kSnapRounds there is an error.
//
// A vertex that moves takes the triangles around it along; a point of a triangle moves no farther than its corners
// do, so no point of the drawing moves farther than the largest moves of all rounds together.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/complex/complex.h"

namespace cnrg {

/// The first grid, in units in the last place of the largest coordinate; how much coarser each next one is; how many.
inline constexpr double kSnapFirstCell = 4, kSnapGrowth = 16;
inline constexpr int kSnapAttempts = 9;

/// What is drawn, by numbers of points; triangles of one face share its number, pieces of one edge that.
struct NumberedDrawing {
  struct Triangle {
    std::array<std::uint32_t, 3> points;
    std::uint32_t face = 0;
  };
  struct Piece {
    std::array<std::uint32_t, 2> points;
    std::uint32_t edge = 0;
  };
  std::vector<VertexId> points;          ///< in the table that it is drawn with
  std::vector<Triangle> triangles;
  std::vector<Piece> pieces;             ///< of edges, on triangles or not
  std::vector<std::uint32_t> isolated;   ///< points that are drawn by themselves
};

struct SnappedDrawing {
  Complex complex;                       ///< each vertex is three doubles
  /// Of each face of the complex the faces of the drawing that lie on it, each as often as it does: 2 * face, and 1
  /// more where its front is the back here.
  Csr<FaceId, std::uint32_t> faces;
  Csr<EdgeId, std::uint32_t> edges;      ///< of each edge those edges of the drawing that run along it, ascending
  std::vector<VertexId> points;          ///< where each point is; none() if all that had it has collapsed
  int rounds = 0;                        ///< refinements
  bool plain = false;                    ///< rounding each point by itself was enough: nothing was cut, merged or lost
  double displacement = 0;               ///< no point of the drawing moved farther (units of the model)
};

/// The drawing must not be empty. Throws InputError when it does not become stable, and for coordinates beyond the
/// range of doubles.
SnappedDrawing snap(const PointTable& points, const NumberedDrawing& drawing);

}  // namespace cnrg
