// Texts of tree files in which much is near to each other and little of it is in the result.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace cnrg::bench {

/// A plate and vertical prisms of 24 sides through it, on a square lattice. Coordinates are integers, so that the
/// volume is one, and long, as those of most models are: products of them are no doubles.
struct PlateWithHoles {
  int holes = 0;
  /// How many places the lattice has along a side.
  int side() const;
  /// Corners of the k-th prism's section, counter-clockwise.
  std::vector<std::array<int, 2>> section(int k) const;
  /// What is left of the plate, by integers.
  long long volume() const;
  static constexpr int kRadius = 1 << 20, kSpacing = 3 * kRadius, kHeight = 2;
};

/// The plate without all prisms in one difference, or in one difference per prism: ((plate - a) - b) - ... .
std::string plate_difference(int holes);
std::string plate_chain(int holes);

/// Squares of random places and directions in a block of 100 x 100 x 100, with decimals of three digits; the
/// result is the block with the parts of them that are inside as sheets. Its volume is 1,000,000.
std::string fractures_in_block(int count, unsigned seed);

/// Random spheres of 32 segments, each cut to the same unit box: the union of all, and each cut by itself.
std::string cut_spheres(int count, unsigned seed);
std::vector<std::string> cut_spheres_apart(int count, unsigned seed);

/// A unit box, and `doublings` times the union of what is there and its copy moved: 2^doublings boxes that do not
/// touch, of one leaf.
std::string shared_boxes(int doublings);

}  // namespace cnrg::bench
