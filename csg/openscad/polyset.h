// Solids as OpenSCAD has them before a Boolean: polygons over corners of doubles.
//
// A Boolean of OpenSCAD (2021.01) puts the corners onto a grid of 1/2^20 first, towards zero, joins those that are
// then at most one step apart, and takes the hull of a solid that is known to be convex. `on_grid` does the same,
// so that a result has the same cells.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "csg/openscad/area.h"
#include "csg/openscad/fineness.h"
#include "kernel/exact/rational.h"

namespace cnrg::openscad {

using Point3 = std::array<double, 3>;
using Matrix = std::array<std::array<double, 4>, 3>;  ///< rows
using Face = std::vector<std::uint32_t>;              ///< counter-clockwise from outside

struct Polyset {
  std::vector<Point3> points;
  std::vector<Face> faces;
  std::optional<bool> convex{};  ///< empty: nobody knows
};

/// Throws InputError for a solid of more corners than is sensible.
void require_few(double corners);

Polyset cube(const Point3& size, bool center);
Polyset sphere(double radius, const Fineness& fineness);
Polyset cylinder(double height, double bottom, double top, bool center, const Fineness& fineness);
/// A circle of OpenSCAD's corners, counter-clockwise.
Loop circle(double radius, int segments);

struct LinearExtrusion {
  double height = 100, twist = 0;
  std::array<double, 2> scale{1, 1};
  bool center = false;
  std::optional<int> slices{};
};
/// The area must be clean.
Polyset extruded(const Area& area, const LinearExtrusion& how, const Fineness& fineness);
/// About z, x being the distance from it, all of one sign; nothing if it is not.
std::optional<Polyset> revolved(const Area& area, double degrees, const Fineness& fineness);

/// Turned inside out where the matrix mirrors, so that faces look outwards.
Polyset transformed(const Polyset& solid, const Matrix& matrix);
double determinant(const Matrix& matrix);

/// As a Boolean takes it. Faces that vanish are left out.
Polyset on_grid(const Polyset& solid);
/// True where OpenSCAD takes a solid for convex: no edge is concave by more than a tenth of a degree, and all
/// faces hang together.
bool is_convex(const Polyset& solid);

/// The convex hull of points; no faces, if all points are in one plane.
Polyset hull(std::vector<Point3> points);
std::vector<RationalPoint> exact_points(const std::vector<Point3>& points);
/// The sums of a point of each.
std::vector<Point3> sums(const std::vector<Point3>& a, const std::vector<Point3>& b);

}  // namespace cnrg::openscad
