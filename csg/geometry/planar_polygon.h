// Planar polygons with holes: is what people type a face? Decided exactly, and said in words that name the point.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

/// How messages name the parts of a polygon. Loop 0 is the outer one; points and edges count from 1, edge i
/// running from point i to the next.
struct PolygonNames {
  std::string polygon = "the polygon";
  std::function<std::string(std::size_t loop, std::size_t point)> point{};  ///< default `point 3 of hole 1`
  bool has_fit = false;                                                     ///< messages propose the key `fit`
};

/// Checks that the loops (the outer one first) make a face: at least three points each, none equal to the next,
/// all on one plane, every loop simple, holes inside of the outer loop, disjoint and not inside each other.
/// Returns a normal of the plane, of any length, on the side that sees the outer loop counter-clockwise.
/// Throws InputError that names the point or the two edges at fault, and what to do. All decisions are exact;
/// pairs of edges are found by a sweep, so the cost is near n log n for well-formed polygons.
RationalPoint check_polygon(const std::vector<std::vector<RationalPoint>>& loops, const PolygonNames& names = {});

/// Twice the area vector of a closed loop (Newell), exact.
RationalPoint area_vector(const std::vector<RationalPoint>& loop);

/// Of different points.
bool are_in_a_plane(std::span<const RationalPoint> points);

/// A normal of the plane through the mean of the points that has the least sum of squared distances, of all planes
/// that are near the one along `start`: distances are measured along `start`, which is off by the square of the
/// angle between both. A rotation of the points rotates it, their order is all the same. `start` where the points
/// lie on a line along it.
RationalPoint least_squares_normal(std::span<const RationalPoint> points, const RationalPoint& start);

}  // namespace cnrg
