// How long edges of a mesh are to be at each place: what a mesher asks of every edge that it makes.
//
// Lengths are wanted at some places only, and between them a mesh has to change gradually: where the length jumps
// from h to 10 h, tetrahedra are flat. So the field is the largest one that is nowhere above what is wanted and
// has a bounded slope: each source bids its length and a share of the distance to it, and the least bid counts. A
// minimum of functions with slope `growth` has slope `growth`, whatever the sources are; a grid or a background
// mesh with numbers at its corners, which is the obvious way, has to be smoothed for that, and is as coarse as its
// cells.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <vector>

namespace cnrg {

/// The squared distance of a point to a point, a segment or a triangle, whose corners repeat or lie on one line;
/// of a segment the last two are equal.
double squared_distance(const std::array<double, 3>& p, const std::array<std::array<double, 3>, 3>& corners);

class SizeField {
 public:
  using Vector = std::array<double, 3>;
  /// A point, a segment or a triangle, whose corners repeat, and the length that is wanted on it.
  struct Source {
    std::array<Vector, 3> corners;
    double size;
  };

  SizeField() = default;  ///< no bound: at() is infinity everywhere
  /// `growth`: how much longer edges may be per unit of distance (0.3, say); `overall`: they are nowhere longer;
  /// infinity: no bound. Throws InputError for lengths and a growth that are not above 0, and for corners, sizes
  /// and a growth that are not finite.
  SizeField(std::vector<Source> sources, double growth, double overall);

  /// min(overall, over all sources size + growth * distance). A few microseconds; any number of threads may ask.
  double at(const Vector& p) const;
  double overall() const { return overall_; }
  double growth() const { return growth_; }
  std::size_t sources() const;
  /// True if at() is infinity everywhere.
  bool empty() const { return tree_ == nullptr && overall_ == std::numeric_limits<double>::infinity(); }

 private:
  class Tree;
  std::shared_ptr<const Tree> tree_{};  // copies share it; nullptr: no sources
  double growth_ = 0.3, overall_ = std::numeric_limits<double>::infinity();
};

}  // namespace cnrg
