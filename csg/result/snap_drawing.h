// Iterated snap rounding: a drawing whose vertices all become doubles and that stays a drawing.
//
// A round refines what there is exactly; where that makes vertices that are not doubles (rounding made triangles
// cross), these are snapped and the next round begins. It ends when a refinement has doubles only: then nothing is
// left to round, and the refinement is embedded by construction.
//
//   * The first rounding takes each vertex to its nearest doubles. Most drawings are done with that.
//   * Where they are not, what is near the crossings is drawn together: cubes of one size around vertices, or the
//     middle between two edges, are *hot* (as pixels of a grid are, halperin2002) if they hold a new vertex, or if
//     something else passes through. All that is in a hot cell goes to its center, and each face and edge that
//     passes through one gets a corner there (hot_routes.h). So a vertex does not pass through an edge or a face
//     that lies nearer to it than half a cell: these come to it. Vertices that are doubles stay where they are.
//   * That is done near the crossings. Where they are many it is done everywhere first: then surfaces nearly
//     coincide, and where a part of one moves, its neighbours cross the other surface next.
//   * The first cells are 64 units in the last place of the largest coordinate: surfaces that should coincide, and
//     have been rounded, are some units apart. Cells become larger when the crossings do not become fewer; when
//     they grow, or that is done too often, all begins with the first rounding again and cells 16 times as large
//     (lazard2025 coarsens its grid, too). No proof bounds the number of rounds: devillers2018 has an algorithm
//     with a proof, of high degree.
//   * Some drawings whose crossings multiply from all starts come to rest in another way, the slower one: boxes of
//     the cells that hold new vertices, or corners of triangles that were cut, are refined together with the
//     drawing, so that all is cut on their boundaries, and what is in a cell goes to its center. Where surfaces
//     nearly coincide the corners of the cuts, which are no doubles, cross again. After its last start there is
//     an error.
//
// A vertex that moves takes the triangles around it along; a point of a triangle moves no farther than its corners
// do, so no point of the drawing moves farther than the largest moves of all rounds together.
#pragma once

#include "csg/result/moved_drawing.h"
#include "kernel/base/progress.h"

namespace cnrg {

/// The first cells, in units in the last place of the largest coordinate; how much larger those of each next
/// start are; and how many starts there are.
inline constexpr double kSnapFirstCell = 64, kSnapGrowth = 16;
inline constexpr int kSnapStarts = 9;
/// Cells grow by so much after a round that did not halve the number of crossings. A start is given up after so
/// many such rounds in turn, and at once when there are more than twice the fewest and kSnapFewCrossings: from
/// there on they multiply.
inline constexpr double kSnapLocalGrowth = 4;
inline constexpr int kSnapPatience = 3;
inline constexpr std::size_t kSnapFewCrossings = 32;
/// The same of the way by boxes, whose cells do not grow: the first ones, and rounds without fewer crossings than
/// ever before.
inline constexpr double kSnapFirstBox = 4;
inline constexpr int kSnapBoxPatience = 8;

/// The drawing must not be empty. Throws InputError when it does not become stable, and for coordinates beyond the
/// range of doubles; Stopped, as the watch asks. Each vertex of the complex is three doubles then.
MovedDrawing snap(const PointTable& points, const NumberedDrawing& drawing, const Watch& watch = {});

}  // namespace cnrg
