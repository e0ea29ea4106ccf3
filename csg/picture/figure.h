// A picture before it has a size: what is seen, in the plane of the picture and in the order in which it is
// painted.
//
// Everything hard is done when a figure exists: what hides what was decided exactly (visibility.h), so nothing in
// it lies behind anything else but what is meant to shine through. Who paints it needs doubles only, and knows no
// cells; one figure becomes pixels, SVG or PDF alike.
//
// Units are those of the model (the picture is a parallel projection), x to the right, y up.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "csg/result/palette.h"

namespace cnrg {

using Point2 = std::array<double, 2>;
inline constexpr Rgb kInk{0.12, 0.13, 0.16};

struct Figure {
  /// An area of one color. Areas do not overlap, and there are no gaps between them.
  struct Area {
    std::vector<std::vector<Point2>> loops;  ///< outer and holes: inside where an odd number of them is around
    Rgb color{};
    double opacity = 1;
    bool missing = false;  ///< not of the set (the open boundary of a region): hatched
    bool sheet = false;    ///< without thickness: a weave, lighter lines than the hatch
  };
  enum class Line : std::uint8_t {
    mesh,     ///< between two triangles of a mesh: the finest
    edge,     ///< an edge of the model, or the outline of something curved
    outline,  ///< between the model and the ground of the picture
    border,   ///< of a sheet: thick
    wire,     ///< thicker still
    ghost,    ///< of what was removed
  };
  struct Stroke {
    std::vector<Point2> points;
    bool closed = false;
    Line line = Line::edge;
    Rgb color{};
    bool missing = false;  ///< an edge that is not of the set: dashed
    bool hidden = false;   ///< behind something that is seen through: faint
  };
  enum class Mark : std::uint8_t {
    vertex,    ///< where edges end: a dot
    isolated,  ///< a point on no edge: a ring about a dot
  };
  struct Dot {
    Point2 at{};
    Mark mark = Mark::vertex;
    Rgb color{};
    bool missing = false;  ///< not of the set: hollow
    bool hidden = false;
  };
  /// A text at a place; left out where it would lie on another one that comes before it.
  struct Label {
    std::string text;
    /// Where it may stand, the best place first: of an area points inside of it, with the radius of a disk that
    /// lies in it (0: of a line or a vertex; the text stands beside the place).
    struct Place {
      Point2 at{};
      double room = 0;
    };
    std::vector<Place> places;
  };
  std::vector<Area> areas;
  std::vector<Stroke> strokes;  ///< over all areas
  std::vector<Dot> dots;        ///< over all strokes
  std::vector<Label> labels;    ///< over everything
  /// The colors with a meaning that are in sight: of materials, regions, groups; in the order of files.
  struct Key {
    Rgb color{};
    std::string text;
  };
  std::vector<Key> keys;
  Point2 low{}, high{};  ///< the box around everything
};

}  // namespace cnrg
