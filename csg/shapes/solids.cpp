// Solids with planar faces: box, prism, pyramid, tetrahedron. Faces are oriented outward.
#include <algorithm>

#include "csg/geometry/planar_polygon.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "csg/weld/fit_polygon.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/refine/box_faces.h"

namespace cnrg {
namespace {

/// A face number, from `next` on, for the side above each edge i of a loop (point i to the next); collinear
/// neighbours share one, since their sides lie in one plane.
std::vector<std::uint32_t> side_numbers(const std::vector<RationalPoint>& loop, std::uint32_t& next) {
  const std::size_t n = loop.size();
  const auto straight = [&](std::size_t i) {
    return collinear(loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n]);
  };
  std::vector<std::uint32_t> numbers(n);
  for (std::size_t i = 0; i < n; ++i) numbers[i] = i > 0 && straight(i) ? numbers[i - 1] : next++;
  if (straight(0)) {  // the last run goes on over the start: give it the first number
    const std::uint32_t last = numbers[n - 1];
    std::replace(numbers.begin(), numbers.end(), last, numbers[0]);
    if (last != numbers[0]) --next;
  }
  return numbers;
}

}  // namespace

std::unique_ptr<PreparedLeaf> prepare_leaf(const BoxShape& shape) {
  const char* axis[] = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k) {
    if (shape.min[k] < shape.max[k]) continue;
    throw LeafKeyError("max", std::string("box: min is not less than max in ") + axis[k] + " (" +
                                  to_decimal(shape.min[k]) + " and " + to_decimal(shape.max[k]) +
                                  "): give min < max, or a polygon for a flat box");
  }
  LeafBuilder builder(Fill::winding);
  PointId corner[8];
  for (std::size_t i = 0; i < 8; ++i) {
    corner[i] = builder.point({(i & 1 ? shape.max : shape.min)[0], (i & 2 ? shape.max : shape.min)[1],
                               (i & 4 ? shape.max : shape.min)[2]});
  }
  for (std::uint32_t f = 0; f < 6; ++f) {
    builder.face(
        {corner[kBoxFaces[f][0]], corner[kBoxFaces[f][1]], corner[kBoxFaces[f][2]], corner[kBoxFaces[f][3]]}, f);
  }
  return builder.finish();
}

std::unique_ptr<PreparedLeaf> prepare_leaf(const PrismShape& shape) {
  std::vector<std::vector<RationalPoint>> loops{shape.base};
  loops.insert(loops.end(), shape.holes.begin(), shape.holes.end());
  std::vector<std::string> notices;
  if (shape.fit) notices = fit_polygon(loops, *shape.fit, "the prism's base");
  const RationalPoint normal =
      in_value_of("base", [&] { return check_polygon(loops, {.polygon = "the prism's base", .has_fit = true}); });
  const Rational rise = dot(normal, shape.vector);
  if (rise == 0) {
    throw LeafKeyError("vector", std::string("prism: the vector ") +
                                     (is_zero(shape.vector) ? "is zero" : "lies in the plane of the base") +
                                     ", the prism is flat: give a vector that leaves the plane");
  }
  // The outer loop counter-clockwise, holes clockwise, as seen from where the vector goes.
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const bool along = dot(area_vector(loops[l]), shape.vector) > 0;
    if (along != (l == 0)) std::reverse(loops[l].begin(), loops[l].end());
  }
  LeafBuilder builder(Fill::winding);
  std::vector<std::vector<PointId>> bottom, top;
  for (const auto& loop : loops) {
    bottom.push_back(builder.points(loop));
    std::vector<RationalPoint> moved;
    for (const RationalPoint& p : loop) moved.push_back(p + shape.vector);
    top.push_back(builder.points(moved));
  }
  std::uint32_t next = 2;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const std::vector<std::uint32_t> numbers = side_numbers(loops[l], next);
    const std::size_t n = loops[l].size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      builder.face({bottom[l][i], bottom[l][j], top[l][j], top[l][i]}, numbers[i]);
    }
  }
  builder.face(top, 1);
  for (auto& loop : bottom) std::reverse(loop.begin(), loop.end());
  builder.face(bottom, 0);
  return builder.finish(std::move(notices));
}

std::unique_ptr<PreparedLeaf> prepare_leaf(const PyramidShape& shape) {
  std::vector<std::vector<RationalPoint>> loops{shape.base};
  std::vector<std::string> notices;
  if (shape.fit) notices = fit_polygon(loops, *shape.fit, "the pyramid's base");
  const RationalPoint normal = in_value_of(
      "base", [&] { return check_polygon(loops, {.polygon = "the pyramid's base", .has_fit = true}); });
  std::vector<RationalPoint>& loop = loops[0];
  const Rational rise = dot(normal, shape.apex - loop[0]);
  if (rise == 0) {
    throw LeafKeyError("apex", "pyramid: the apex " + describe(shape.apex) +
                                   " lies in the plane of the base, the pyramid is flat: move it off the plane");
  }
  if (rise < 0) std::reverse(loop.begin(), loop.end());  // counter-clockwise as seen from the apex
  LeafBuilder builder(Fill::winding);
  std::vector<PointId> base = builder.points(loop);
  const PointId apex = builder.point(shape.apex);
  std::uint32_t next = 1;
  const std::vector<std::uint32_t> numbers = side_numbers(loop, next);
  for (std::size_t i = 0; i < base.size(); ++i)
    builder.triangle(base[i], base[(i + 1) % base.size()], apex, numbers[i]);
  std::reverse(base.begin(), base.end());
  builder.face(base, 0);
  return builder.finish(std::move(notices));
}

std::unique_ptr<PreparedLeaf> prepare_leaf(const TetrahedronShape& shape) {
  const auto& p = shape.points;
  const Rational volume = volume6(p[0], p[1], p[2], p[3]);
  if (volume == 0) {
    throw InputError("tetrahedron: the four points lie in one plane, its volume is zero: move one off the plane");
  }
  LeafBuilder builder(Fill::winding);
  PointId q[4];
  for (std::size_t i = 0; i < 4; ++i) q[i] = builder.point(p[i]);
  if (volume < 0) std::swap(q[0], q[1]);
  builder.triangle(q[0], q[2], q[1], 0);
  builder.triangle(q[0], q[1], q[3], 1);
  builder.triangle(q[1], q[2], q[3], 2);
  builder.triangle(q[2], q[0], q[3], 3);
  return builder.finish();
}

}  // namespace cnrg
