// What of a scene is seen, decided exactly.
//
// The usual ways to a picture compare depths in pixels, or sort faces by how far away they are; the first leaves
// broken edges and cannot become SVG, the second fails where three bars lie over each other in a ring. Here all
// that the scene shows is laid flat onto the picture's plane, and that is refined by the kernel as any other
// input: it becomes a map of cells over each of which the same facets lie, in one order, since facets do not
// cross. So a depth needs to be compared at one exact point of each cell only.
//
// A line is seen where on one of its sides no facet is strictly in front of it. Outlines of curved surfaces need
// no rule of their own: they are the edges of the map at which one side shows what the other does not.
#pragma once

#include "csg/picture/scene.h"

namespace cnrg {

/// What is seen of a scene whose points are in the camera's space: x to the right, y up, z to the
/// front. Numbers are those of the scene; places those of its points, as doubles.
struct SeenScene {
  using Index = Scene::Index;
  static constexpr Index kNone = 0xffffffffu;

  /// Where surfaces are seen through each other in one light.
  struct Area {
    std::vector<Index> facets;  ///< one of each, from front to back, down to the first that hides the rest
    std::vector<std::vector<Point2>> loops;  ///< inside where an odd number of them is around
  };
  /// A piece of a line, or of an outline of the surface `surface`.
  struct Stroke {
    Index line = kNone, surface = kNone;
    bool hidden = false;   ///< behind something that is seen through
    bool outline = false;  ///< nothing is behind one of its sides
    std::vector<Point2> points;
    bool closed = false;
  };
  struct Dot {
    Index dot = 0;
    bool hidden = false;
    Point2 at{};
  };
  std::vector<Area> areas;
  std::vector<Stroke> strokes;
  std::vector<Dot> dots;
};

SeenScene see(const Scene& scene, int threads = 0);

}  // namespace cnrg
