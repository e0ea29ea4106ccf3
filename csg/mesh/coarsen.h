// Facets of curved faces, as large as they may be: fewer, within a distance of those that were given.
//
// Facets come of the fineness of leaves and of where these are cut. A mesh that conforms to them is as fine, even
// where nobody asks for that: at a pole, along a cut that passes by a corner. Here sides that are shorter than
// wanted collapse, the shortest first, one end onto the other (hoppe1993). Points inside of curved faces go to a
// neighbour; points of edges that curved faces bound go along these; all else stays. A collapse is made if
//   * no cell vanishes: what both ends neighbour are corners of triangles that have both;
//   * no triangle turns over, and in curved faces none becomes thin, or longer than wanted, as long ones stay;
//   * in curved faces each new triangle is within the distance of the facets that were given: it is cut until each
//     piece has its corners so near to one of them, and so all of it, since what is that near is convex.
// The drawing of what has moved is refined exactly, and is a result again (csg/result/relabel.h). Where that has
// cells that the given one has not, parts have crossed: all begins anew, thrice with half the distance, then with
// points around that stay.
#pragma once

#include "csg/mesh/mesh_sizes.h"
#include "csg/result/result.h"
#include "kernel/base/progress.h"

namespace cnrg {

struct CoarsenReport {
  std::size_t before = 0, after = 0;  ///< triangles of curved faces
  bool crossed = false;               ///< so often that all stays as it is
  /// One line without its end: `curved faces: 7,120 triangles before, 1,204 now, within 0.01 of them`.
  std::string text(double within) const;
};

/// `within`: a distance above 0 (units). Sides shorter than `sizes` wants collapse, of those that people have
/// said. What the result knew of true surfaces is gone where anything collapsed. Throws InputError for a result
/// that has no bounds, and beyond the range of doubles; Stopped, as the watch asks.
Result coarsen(const Result& result, double within, SizeOptions sizes, CoarsenReport& report,
               const Watch& watch = {});

}  // namespace cnrg
