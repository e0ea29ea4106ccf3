// Convex hulls of points, and Minkowski sums of such hulls: the hull of all sums of their corners.
#include <algorithm>

#include "csg/geometry/planar_polygon.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/convex_hull.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

constexpr std::size_t kMostSums = 10'000'000;

/// All sums of a point of each, each once.
std::vector<RationalPoint> sums(const std::vector<RationalPoint>& a, const std::vector<RationalPoint>& b) {
  if (a.size() > kMostSums / std::max<std::size_t>(b.size(), 1))
    throw InputError("minkowski: the points have more than 10,000,000 sums: give fewer points");
  std::vector<RationalPoint> out;
  for (const RationalPoint& p : a) {
    for (const RationalPoint& q : b) out.push_back(p + q);
  }
  sort_unique(out);
  return out;
}

}  // namespace

std::unique_ptr<PreparedLeaf> prepare_leaf(const HullShape& shape) {
  std::vector<RationalPoint> points{{0, 0, 0}};
  for (const auto& summand : shape.summands) points = sums(points, summand);
  if (are_in_a_plane(points)) {
    throw InputError(std::string(shape.name()) +
                     ": the points lie in one plane, its volume is zero: give a point off the plane");
  }
  LeafBuilder builder(Fill::winding);
  std::vector<PointId> ids(points.size());
  std::uint32_t number = 0;
  for (const std::vector<std::uint32_t>& facet : convex_hull(points)) {
    std::vector<PointId> loop;
    for (const std::uint32_t corner : facet) {
      if (!ids[corner].valid()) ids[corner] = builder.point(points[corner]);
      loop.push_back(ids[corner]);
    }
    builder.face(loop, number++);
  }
  return builder.finish();
}

}  // namespace cnrg
