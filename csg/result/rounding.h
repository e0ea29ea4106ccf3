// Exact coordinates as doubles, and what that does to the shape.
#pragma once

#include <array>
#include <vector>

#include "csg/result/flat.h"
#include "kernel/base/error.h"
#include "kernel/base/progress.h"

namespace cnrg {

/// The doubles nearest to a point, without -0. Throws InputError when a coordinate is beyond their range.
std::array<double, 3> nearest_doubles(const PointTable& points, VertexId v);
/// The distance between a point of the table and one of doubles, or a little more.
double distance_above(const PointTable& points, VertexId v, const std::array<double, 3>& to);

/// The doubles of a flattened result, by point number.
struct RoundedPoints {
  std::vector<std::array<double, 3>> xyz;
  std::size_t moved = 0;  ///< points whose doubles are not their exact coordinates
  /// Of each point: no coordinate is farther than this from the exact one. Empty if none has moved.
  std::vector<double> reach{};
};
/// Throws InputError when a coordinate is beyond the range of double.
RoundedPoints round_points(const ResultView& view, const FlatComplex& flat);

/// A result that doubles cannot hold as it is: snapped (csg/result/snap.h) it can be.
class RoundingFault : public InputError {
 public:
  using InputError::InputError;
};

/// What a file shows: numbers of points. Places, where they are given, are numbers of what lies around, be it
/// regions or components: whatever no triangle parts has one number.
struct Drawing {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> segments{};  ///< that are on no triangle
  std::vector<std::uint32_t> points{};                   ///< that are on no segment and no triangle
  std::vector<std::array<std::uint32_t, 2>> sides{};     ///< places in front of each triangle and behind it
  std::vector<std::uint32_t> around_segments{}, around_points{};  ///< the place that each lies in
};

/// True if so many points and triangles, and wires, were put into the complex and nothing was cut, merged or lost:
/// they meet only where they share points. Triangle t is source t, and wires lie on no triangle.
bool is_as_drawn(const Complex& complex, std::size_t points, std::size_t triangles);

/// The rounded triangles, segments and points refined exactly; triangle t of the drawing is leaf face t there.
struct Redrawing {
  std::shared_ptr<const Complex> complex;
  std::size_t points = 0, triangles = 0;  ///< that were put in
  bool is_embedded() const { return is_as_drawn(*complex, points, triangles); }
};
/// The drawing must not be empty. `stop` here and below: throws Stopped.
Redrawing redraw(const RoundedPoints& points, const Drawing& drawing, const std::stop_token& stop = {});

/// True if the rounded drawing is the exact one in all but digits: it is embedded, and all its places are where
/// they were. A shell, a wire or a point may pass through a wall as a whole, so that nothing crosses afterwards.
bool is_faithful(const RoundedPoints& points, const Drawing& drawing, const std::stop_token& stop = {});

/// Of a drawing that is embedded with its exact points. It is refined only where slight_moves.h tells nothing.
RoundingReport report_rounding(const RoundedPoints& points, const Drawing& drawing,
                               const std::stop_token& stop = {});

}  // namespace cnrg
