// Exact coordinates as doubles, and what that does to the shape.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "csg/result/flat.h"

namespace cnrg {

/// The doubles of a flattened result, by point number.
struct RoundedPoints {
  std::vector<std::array<double, 3>> xyz;
  std::size_t moved = 0;  ///< points whose doubles are not their exact coordinates
};
/// Throws InputError when a coordinate is beyond the range of double.
RoundedPoints round_points(const ResultView& view, const FlatComplex& flat);

/// What a file shows: numbers of points.
struct Drawing {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> segments;  ///< that are on no triangle
  std::vector<std::uint32_t> points;                   ///< that are on no segment and no triangle
};

/// The rounded triangles, segments and points refined exactly; triangle t of the drawing is leaf face t there.
struct Redrawing {
  std::shared_ptr<const Complex> complex;
  std::size_t points = 0, edges = 0, triangles = 0;  ///< that were put in
  /// True if they meet only where they share points: nothing was cut, merged or lost.
  bool is_embedded() const {
    return complex->vertex_count() == points && complex->edge_count() == edges &&
           complex->face_count() == triangles;
  }
};
/// The drawing must not be empty.
Redrawing redraw(const RoundedPoints& points, const Drawing& drawing);

/// The same as `redraw(...).is_embedded()`; true for an empty drawing.
bool is_embedded(const RoundedPoints& points, const Drawing& drawing);

RoundingReport report_rounding(const RoundedPoints& points, const Drawing& drawing);

/// Appends the shortest text that reads back as the same double.
void append(std::string& text, double value);
void append(std::string& text, const std::array<double, 3>& xyz);  ///< separated by spaces

}  // namespace cnrg
