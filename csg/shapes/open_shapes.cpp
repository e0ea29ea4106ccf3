// Leaves without regions: polygon, polyline, points.
#include "csg/geometry/planar_polygon.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {

std::unique_ptr<PreparedLeaf> prepare_polygon(const PolygonShape& shape) {
  std::vector<std::vector<RationalPoint>> loops{shape.outer};
  loops.insert(loops.end(), shape.holes.begin(), shape.holes.end());
  check_polygon(loops);
  LeafBuilder builder(Fill::none);
  std::vector<std::vector<PointId>> ids;
  for (const auto& loop : loops) {
    ids.emplace_back();
    for (const RationalPoint& p : loop) ids.back().push_back(builder.point(p));
  }
  builder.face(ids, 0);
  return builder.finish();
}

std::unique_ptr<PreparedLeaf> prepare_polyline(const PolylineShape& shape) {
  const auto& points = shape.points;
  const std::size_t least = shape.closed ? 3 : 2;
  if (points.size() < least) {
    throw InputError(std::string("polyline: ") + std::to_string(points.size()) +
                     " points are too few: give at least " + std::to_string(least) +
                     (shape.closed ? " for a closed one" : ", or `points` for single ones"));
  }
  LeafBuilder builder(Fill::none);
  std::vector<PointId> ids;
  for (const RationalPoint& p : points) ids.push_back(builder.point(p));
  const std::size_t count = shape.closed ? points.size() : points.size() - 1;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = (i + 1) % points.size();
    if (points[i] == points[j]) {
      throw InputError("polyline: points " + std::to_string(i + 1) + " and " + std::to_string(j + 1) +
                       " are both " + describe(points[i]) + ": leave one out" +
                       (shape.closed && j == 0 ? ", a closed polyline returns to its first point by itself" : ""));
    }
    builder.soup().add_wire(builder.leaf(), ids[i], ids[j], static_cast<std::uint32_t>(i));
  }
  return builder.finish();
}

std::unique_ptr<PreparedLeaf> prepare_points(const PointsShape& shape) {
  if (shape.points.empty()) throw InputError("points: the list is empty: give at least one point");
  LeafBuilder builder(Fill::none);
  for (const RationalPoint& p : shape.points) builder.soup().add_isolated(builder.leaf(), builder.point(p));
  return builder.finish();
}

}  // namespace cnrg
