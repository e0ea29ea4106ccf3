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
//     that lies nearer to it than a quarter of a cell: these come to it. Vertices that are doubles stay where they
//     are.
//   * That is done near the crossings. Where they are many it is done everywhere first: then surfaces nearly
//     coincide, and where a part of one moves, its neighbours cross the other surface next.
//   * The first cells are 64 units in the last place of the largest coordinate: surfaces that should coincide, and
//     have been rounded, are some units apart. Those that were rounded to fewer digits are farther apart, and
//     cross at angles so small that a unit moves their crossing lines by more than a cell: crossings multiply
//     then. As soon as they do, or stay too long, all begins with the first rounding again, everywhere, and with
//     cells 64 times as large (lazard2025 coarsens its grid, too), until they hold what is between the surfaces.
//
// So there is an end after few rounds: at most 6 starts, each with so many rounds as the crossings can be halved,
// and some between two halvings. After the last start there is an error. No proof says that a start comes to rest;
// devillers2018 has an algorithm with one, of high degree, which parts each face along the shadows of all edges.
// Cells that grow until they hold all would bring an end, too, but then nothing is left of the model.
//
// A vertex that moves takes the triangles around it along; a point of a triangle moves no farther than its corners
// do, so no point of the drawing moves farther than the largest moves of all rounds together.
#pragma once

#include "csg/result/flat_drawing.h"
#include "kernel/base/progress.h"

namespace cnrg {

/// The first cells, in units in the last place of the largest coordinate; how much larger those of each next
/// start are; and how many starts there are.
inline constexpr double kSnapFirstCell = 64, kSnapGrowth = 64;
inline constexpr int kSnapStarts = 6;
/// A start is given up after so many rounds in turn that did not halve the fewest crossings, of few crossings
/// after some more: these are a matter of luck. And at once when there are more than twice the fewest and so few:
/// from there on they multiply.
inline constexpr std::size_t kSnapFewCrossings = 32;
inline constexpr int kSnapPatience = 3, kSnapFewPatience = 8;

/// The drawing must not be empty. Throws InputError when it does not become stable, and for coordinates beyond the
/// range of doubles; Stopped, as the watch asks. Each vertex of the complex is three doubles then.
MovedDrawing snap(const PointTable& points, const NumberedDrawing& drawing, const Watch& watch = {});

}  // namespace cnrg
