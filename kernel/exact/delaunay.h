// A triangulation of points in the plane of which nothing is known but that they are distinct.
//
// Triangles are those whose circles are empty (Delaunay), as round as the points allow. The signs behind that are
// exact: with plain doubles points that nearly lie on a line or a circle make triangles that overlap. Points of a
// grid lie on common circles everywhere; what is done there depends on the coordinates alone, not on the order of
// the points, so that a file that is sorted otherwise gives the same surface.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cnrg {

struct Delaunay {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise, the smallest number first, sorted
  std::vector<std::uint32_t> border;  ///< of the convex hull, counter-clockwise, with all points that lie on it
};

/// `points` are finite and distinct. Both lists are empty if all points lie on a line.
Delaunay delaunay(std::span<const std::array<double, 2>> points);

}  // namespace cnrg
