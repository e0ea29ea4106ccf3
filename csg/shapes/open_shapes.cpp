// Leaves without regions: polygon, disk, polyline, points.
#include "csg/geometry/circle.h"
#include "csg/geometry/planar_polygon.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "csg/weld/fit_polygon.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {

std::unique_ptr<PreparedLeaf> prepare_leaf(const PolygonShape& shape) {
  std::vector<std::vector<RationalPoint>> loops{shape.outer};
  loops.insert(loops.end(), shape.holes.begin(), shape.holes.end());
  std::vector<std::string> notices;
  if (shape.fit) notices = fit_polygon(loops, *shape.fit, "polygon");
  in_value_of("outer", [&] { check_polygon(loops, {.has_fit = true}); });
  LeafBuilder builder(Fill::none);
  std::vector<std::vector<PointId>> ids;
  for (const auto& loop : loops) ids.push_back(builder.points(loop));
  builder.face(ids, 0);
  return builder.finish(std::move(notices));
}

std::unique_ptr<PreparedLeaf> prepare_leaf(const DiskShape& shape) {
  for (const Rational& r : shape.radii) {
    if (r <= 0) throw InputError("disk: a radius is " + to_decimal(r) + ": give positive lengths");
  }
  if (shape.segments < 3)
    throw LeafKeyError("segments", "disk: segments is " + std::to_string(shape.segments) + ": give 3 or more");
  if (is_zero(shape.normal)) throw LeafKeyError("normal", "disk: the normal is [0, 0, 0]: give a direction");
  const RationalPoint second = cross(shape.normal, shape.along);
  if (is_zero(second))
    throw LeafKeyError("along", "disk: `along` runs along the normal: give a direction in the plane of the disk");
  const RationalPoint first = cross(second, shape.normal);
  const Rational first2 = shape.radii[0] * shape.radii[0] / dot(first, first);
  const Rational second2 = shape.radii[1] * shape.radii[1] / dot(second, second);
  LeafBuilder builder(Fill::none);
  std::vector<PointId> loop;
  for (int i = 0; i < shape.segments; ++i) {
    Rational degrees = fraction(std::int64_t{360} * i, shape.segments);
    loop.push_back(builder.point(shape.center + scaled_cosine(degrees, first2) * first +
                                 scaled_cosine(90 - degrees, second2) * second));
  }
  builder.face(loop, 0);
  return builder.finish();
}

std::unique_ptr<PreparedLeaf> prepare_leaf(const PolylineShape& shape) {
  const auto& points = shape.points;
  const std::size_t least = shape.closed ? 3 : 2;
  if (points.size() < least) {
    throw InputError(std::string("polyline: ") + std::to_string(points.size()) +
                     " points are too few: give at least " + std::to_string(least) +
                     (shape.closed ? " for a closed one" : ", or `points` for single ones"));
  }
  LeafBuilder builder(Fill::none);
  const std::vector<PointId> ids = builder.points(points);
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

std::unique_ptr<PreparedLeaf> prepare_leaf(const PointsShape& shape) {
  if (shape.points.empty()) throw InputError("points: the list is empty: give at least one point");
  LeafBuilder builder(Fill::none);
  for (const RationalPoint& p : shape.points) builder.soup().add_isolated(builder.leaf(), builder.point(p));
  return builder.finish();
}

}  // namespace cnrg
