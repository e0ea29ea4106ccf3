// Delaunay refinement of all facets of a result together (ruppert1995, shewchuk2002): triangles without small
// angles, as large as a size field lets them be.
//
// In one plane: a segment with a point in its diametral circle is split; a triangle with a small angle or a side
// that is too long gets its circumcentre, or a point nearer to its shortest side where that will do (ungor2004),
// unless the point would lie in the diametral circle of a segment, which is split in its place. Facets meet in
// segments alone, so that this works for all of them at once; angles between facets do not matter.
//
// Where the input has small angles no mesh is without them. Two things keep the work finite there: segments are
// split so that their pieces agree, or need not be (input_lines.h), and a triangle whose shortest side runs from
// one line of a small angle to the same distance on the other is left as it is (shewchuk2002, miller2003).
//
// It ends for every input, with doubles as they are: pieces of segments are not split below the digits of the
// points (shortest_), so they are finitely many; and a point comes into a facet only where no corner is nearer
// than the shortest side of the triangle that it mends, which is longer than that, too, or than a quarter of the
// side that is too long, so there is room for finitely many. Long before that:
//   * no chain of causes has more than kMostRank segments that are split, each for the sake of a triangle, into
//     pieces that are shorter than the triangle's sides; for angles up to 26.4 degrees such chains are short in
//     theory (miller2003);
//   * where parts of the result nearly touch, points are rationed. A strip takes as many as it is longer than
//     wide, and a corner beside a line some for each time that its distance is halved: nothing of that is bounded
//     by the size of the input. So first all gets its points but what is narrow: flatter than 1/64 of a side of
//     facets, as these are on the average. Then what is narrow, the wider before the narrower, so that a ration
//     that ends has mended all that is wider than something; last long gaps (the only ones that grow dear at
//     once), from the widest on, and only those for which what is left suffices, since half a gap is mended
//     nowhere;
//   * where lines are nearer than digits, and in gaps that stay as they are, they are only split as finely as what
//     they nearly touch, so that triangles between them are short and do not lie upon each other by thousands.
#pragma once

#include "csg/mesh/facet_mesh.h"
#include "csg/result/result.h"

namespace cnrg {

/// Why a triangle has an angle below kLeastAngle.
enum class SmallAngle : std::uint8_t {
  none,    ///< it has none
  input,   ///< lines of the result meet in a small angle there
  digits,  ///< no room for points between doubles; or a facet, or what lies beside it, must stay as it is for that
  bound,   ///< `max_points`
};
constexpr double kLeastAngle = 25;  ///< degrees

/// What becomes of what is narrow: it gets some points, or none.
enum class SurfaceNarrow : std::uint8_t { rationed, left };

/// The smallest angle of a triangle, in degrees, and the corner that has it.
std::pair<double, std::size_t> smallest_angle(const std::array<DoubleVector, 3>& corners);

/// Refines until no triangle is below kLeastAngle that need not be, and no side longer than `options.size`; says
/// of each triangle why it is. Where doubles have no room for that, sides are as long as `said` at most: what
/// people asked for, without what features ask for by themselves (mesh_sizes.h), which there are the cause. Throws
/// InputError, with a place, where sizes need more points or time than there may be, and where time is up;
/// Stopped.
std::vector<SmallAngle> refine(FacetMesh& mesh, const SurfaceOptions& options, const SizeAt& said,
                               SurfaceNarrow narrow = SurfaceNarrow::rationed);

}  // namespace cnrg
