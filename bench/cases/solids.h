// Solids with exact coordinates, and exact motions of them: what families of problems are made of.
//
// Faces have one loop, which is convex and lies in its plane exactly. Coordinates are short fractions.
#pragma once

#include <array>
#include <vector>

#include "bench/cases/model.h"
#include "bench/cases/random.h"

namespace cnrg::bench {

/// p -> matrix p + move.
struct AffineMap {
  std::array<RationalPoint, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  RationalPoint move{0, 0, 0};
  RationalPoint operator()(const RationalPoint& p) const;
};

/// The rotation about the origin by a quaternion (w, x, y, z), which is not zero and need not have length 1: about
/// the axis (x, y, z) by 2 atan(|(x, y, z)| / w). Orthogonal exactly.
AffineMap rotation(const std::array<Rational, 4>& quaternion);
/// A quaternion of small integers, so that coordinates stay short.
AffineMap random_rotation(Random& random);
AffineMap translation(const RationalPoint& move);
/// (x + a z, y + b z, z): the plane z = 0 stays where it is.
AffineMap shear(const Rational& a, const Rational& b);
/// The model under a map that is not singular; a mirror image keeps its outside outside.
Model mapped(Model model, const AffineMap& map);

/// 10^-k.
Rational power_of_tenth(int k);

/// The axis-parallel box between two corners, `min` below `max`.
Model box_between(const RationalPoint& min, const RationalPoint& max);
/// Four points, no matter in what order, but not in a plane.
Model tetrahedron(const std::array<RationalPoint, 4>& corners);

using Polygon = std::vector<std::array<Rational, 2>>;
/// A strictly convex polygon with its corners near the circle of radius 1, counter-clockwise, the first at (1, 0);
/// coordinates are multiples of a power of 1/2, small as the corners are many. At least three corners.
Polygon random_polygon(std::size_t corners, Random& random);
Polygon scaled(const Polygon& polygon, const Rational& factor, const std::array<Rational, 2>& move = {0, 0});

/// Between two convex polygons at two heights, low < high; their sides are parallel one by one.
Model frustum(const Polygon& bottom, const Rational& low, const Polygon& top, const Rational& high);
/// Over a convex polygon; the apex is not at its height.
Model pyramid(const Polygon& base, const Rational& height, const RationalPoint& apex);
/// A star of `arms` arms, not convex, with vertical sides, tents over top and bottom: 6 * arms faces.
Model star_prism(std::size_t arms, Random& random);
/// A ring of genus 1 of `segments` pieces, its section a polygon of `corners` (3 or 4): their product in faces.
Model ring(std::size_t segments, std::size_t corners, Random& random);
/// The convex hull of points near the sphere of radius 1, about `faces` triangles.
Model random_hull(std::size_t faces, Random& random);
/// `bumpy_sphere` with coordinates rounded to multiples of 2^-16.
Model rough_sphere(std::size_t faces, unsigned seed);

/// One polygon, which is planar: a surface.
Model sheet_of(const std::vector<RationalPoint>& corners);
/// Segments from each point to the next one.
Model wire_of(const std::vector<RationalPoint>& points);

}  // namespace cnrg::bench
