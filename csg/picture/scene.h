// What stands before the camera: surfaces made of planar facets, lines and dots, each with its look.
//
// A region is shown by its skin: each side of a face that looks into an active region is a surface of that
// region's, seen from outside. So a wall has two skins, one for each region, and regions can be pulled apart. A
// face that parts no regions is a sheet, seen from both sides.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "csg/picture/figure.h"
#include "kernel/exact/rational.h"

namespace cnrg {

struct Scene {
  using Index = std::uint32_t;
  using Loop = std::vector<Index>;  ///< numbers of points

  struct Surface {
    Rgb color{};
    double opacity = 1;
    bool missing = false, sheet = false, ghost = false;
    bool two_sided = false;     ///< seen from its back, too
    std::vector<Index> labels;  ///< texts that may stand on it, the first that finds room there or elsewhere
  };
  /// Facets of a scene meet in common points, edges and facets only.
  struct Facet {
    Index surface = 0;
    std::vector<Loop> loops;  ///< outer first, counter-clockwise as seen from outside
    int light = 0;            ///< how light it is, in steps (draw.cpp)
  };
  struct Line {
    Figure::Line look = Figure::Line::edge;
    Rgb color{};
    bool missing = false;
    std::vector<Index> labels;
  };
  struct Segment {
    Index line = 0;
    std::array<Index, 2> ends{};
  };
  struct Dot {
    Figure::Mark mark = Figure::Mark::vertex;
    Index point = 0;
    Rgb color{};
    bool missing = false;
    bool drawn = true;  ///< otherwise it only has a label
    std::vector<Index> labels;
  };

  std::vector<RationalPoint> points;
  std::vector<Surface> surfaces;
  std::vector<Facet> facets;
  std::vector<Line> lines;
  std::vector<Segment> segments;
  std::vector<Dot> dots;
  std::vector<std::string> labels;
  std::vector<Figure::Key> keys;
};

}  // namespace cnrg
