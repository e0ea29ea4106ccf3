// Quadrilaterals instead of triangles: pairs of triangles in one facet are merged across the side that they share
// (remacle2012). Points, and sides that others see, stay; so what conformed does, and areas are the same.
//
// Which pairs: most triangles are to be in one, and the quadrilaterals are to be near to rectangles. That is a
// matching of largest weight in the graph of triangles that are neighbours. To take the best pair again and again
// leaves triangles alone between pairs, about one in ten. A matching that is proven to be the best needs the
// blossoms of Edmonds, and time that grows with more than the square of the number of triangles (Boost's with the
// third power). Here pairs taken so are improved along alternating paths: drop a pair, take the next one, and so
// on for a few steps, if the sum is greater then (pettie2004). That is linear in the number of triangles, and
// misses the greatest number of pairs by less than one in a hundred.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "csg/mesh/facet_mesh.h"
#include "kernel/base/progress.h"

namespace cnrg {

/// Two triangles that may be one quadrilateral.
struct TrianglePair {
  std::uint32_t first, second;
  double quality;  ///< of the quadrilateral, 0 to 1
};

/// 1 of a rectangle; what its angle farthest from 90 degrees misses of that, in parts of 90 degrees, is taken
/// away.
double quad_quality(const std::array<DoubleVector, 4>& corners);
/// No quadrilateral is below: its angles are from 30 to 150 degrees.
constexpr double kLeastQuadQuality = 1.0 / 3;

struct MergedQuad {
  std::array<FacetMesh::Index, 4> points;     ///< counter-clockwise, as its triangles
  std::array<FacetMesh::Index, 2> triangles;  ///< of the mesh
};

/// Pairs that share no triangle, by place, ascending: many of them and good ones, of `pairs` among `count`
/// triangles. No path of `kPathPairs` pairs or fewer makes the sum of 1 + quality greater. Throws Stopped.
std::vector<std::uint32_t> match(std::size_t count, const std::vector<TrianglePair>& pairs,
                                 const Watch& watch = {});
constexpr int kPathPairs = 8;

/// Quadrilaterals in place of as many triangles as can be. Each is strictly convex, by exact signs as the facet is
/// seen along its axis, and not below kLeastQuadQuality. Facets that keep their triangles keep them. Throws
/// Stopped.
std::vector<MergedQuad> merge_triangles(const FacetMesh& mesh, const Watch& watch = {});

}  // namespace cnrg
