// What carries the faces and edges of a CAD file: surfaces and curves by name, with their numbers.
//
// Facets say where a face is, not what it is: two sides of one cylinder that are cut differently share no facet.
// Here is what the file itself says, by the names that OpenCASCADE gives it, with the places of parts in
// assemblies applied. Numbers are the doubles that OpenCASCADE holds, taken as exact; what a file gives in degrees
// or in another unit has been converted in doubles before. Directions have the length 1 only as nearly as doubles
// can have it, and are at right angles likewise.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace cnrg {

/// Where a surface or curve lies. For OpenCASCADE z x x is y or, where the part was mirrored, -y.
struct CadAxes {
  std::array<double, 3> origin{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  friend bool operator==(const CadAxes&, const CadAxes&) = default;
};

/// Knots of one parameter: each once, ascending, with how often it counts. Of a periodic spline the last one
/// stands for the first one again, and its points are as many as the others count.
struct CadKnots {
  int degree = 0;
  bool periodic = false;
  std::vector<double> values;
  std::vector<int> counts;
  friend bool operator==(const CadKnots&, const CadKnots&) = default;
};

struct CadCurve {
  enum class Kind : std::uint8_t {
    none,     ///< of an edge that is a point, or has curves in parameters only
    line,     ///< origin + t x
    circle,   ///< origin + radius (cos t x + sin t y)
    ellipse,  ///< origin + radius cos t x + minor_radius sin t y
    spline,   ///< B-spline, or Bézier with the knots 0 and 1
    other,    ///< `name` says what
  };
  Kind kind = Kind::none;
  double first = 0, last = 0;  ///< t of its ends; of a whole curve that may be infinite
  CadAxes axes;
  double radius = 0, minor_radius = 0;
  std::vector<std::array<double, 3>> points;  ///< of a spline
  std::vector<double> weights;                ///< of these; empty: all 1
  CadKnots knots;
  std::string name;  ///< what OpenCASCADE calls it: Geom_Line
  friend bool operator==(const CadCurve&, const CadCurve&) = default;
};

struct CadSurface {
  enum class Kind : std::uint8_t {
    plane,       ///< origin + u x + v y
    cylinder,    ///< origin + radius (cos u x + sin u y) + v z
    cone,        ///< origin + (radius + v sin half_angle) (cos u x + sin u y) + v cos half_angle z
    sphere,      ///< origin + radius (cos v (cos u x + sin u y) + sin v z)
    torus,       ///< origin + (radius + minor_radius cos v) (cos u x + sin u y) + minor_radius sin v z
    spline,      ///< B-spline, or Bézier with the knots 0 and 1
    extrusion,   ///< profile(u) + v z
    revolution,  ///< profile(v) turned by u about z through origin
    other,       ///< `name` says what, such as an offset surface
  };
  Kind kind = Kind::other;
  bool turned = false;  ///< the front of the face is not the side of S_u x S_v
  CadAxes axes;
  double radius = 0, minor_radius = 0, half_angle = 0;
  /// Of a spline: `points[i * rows[1] + j]`, i along u and j along v.
  std::array<std::uint32_t, 2> rows{0, 0};
  std::vector<std::array<double, 3>> points;
  std::vector<double> weights;  ///< of these; empty: all 1
  std::array<CadKnots, 2> knots;
  CadCurve profile;
  std::string name;  ///< what OpenCASCADE calls it: Geom_Plane
  friend bool operator==(const CadSurface&, const CadSurface&) = default;
};

}  // namespace cnrg
