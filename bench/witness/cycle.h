// Solids as closed surfaces of triangles in exact fractions, and how often a surface goes around a point.
//
// A witness of verdicts: this room knows nothing of the kernel and of its results, and rests on GMP alone; the
// program of its tests links nothing else.
//
// Faces are chains: a loop is a fan of triangles of its first corner, each with its sign, so that holes and
// corners that turn inwards need no triangulation. A point is asked by the vertical line above it.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace cnrg::bench::witness {

using Number = mpq_class;
using Point = std::array<Number, 3>;

struct Cycle {
  std::vector<Point> points;
  /// Counter-clockwise as seen from outside, where the solid is on the inner side.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  void add_loop(const std::vector<std::uint32_t>& loop);
};

/// Each piece of an edge is used as often in one direction as in the other, wherever corners are.
bool is_closed(const Cycle& cycle);

/// Sum over the triangles, rounded.
double area(const Cycle& cycle);
/// The largest absolute value of a coordinate, rounded.
double extent(const Cycle& cycle);

/// Answers for one cycle, which must stay where it is.
class Locator {
 public:
  explicit Locator(const Cycle& cycle);
  /// Nothing where the line meets an edge or the point is on a face: another point will do.
  std::optional<int> winding(const Point& p) const;
  /// Whether a face may be as near as `distance`, which is told too often rather than too seldom.
  bool may_be_near(const Point& p, const Number& distance) const;

 private:
  int side(std::uint32_t a, std::uint32_t b, const Point& p, const std::array<double, 2>& rounded) const;

  const Cycle& cycle_;
  std::vector<std::array<double, 3>> rounded_;
  double largest_ = 0;
};

}  // namespace cnrg::bench::witness
