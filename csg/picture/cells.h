// The cells of a node in a picture: all cells, or the part behind a cutting plane.
#pragma once

#include <array>
#include <vector>

#include "csg/picture/draw.h"
#include "csg/result/flat.h"

namespace cnrg {

struct PictureCells {
  using Index = FlatComplex::Index;
  static constexpr Index kNone = FlatComplex::kNone;

  struct Face {
    Index face = kNone;              ///< in the node; none: made by a cut through a region
    std::array<Index, 2> regions{};  ///< active ones of the node, on front and back
    std::vector<std::vector<FlatComplex::Loop>>
        facets;  ///< loops of each, counter-clockwise as seen from the front
  };
  struct Edge {
    Index edge = kNone;          ///< in the node; none: where a face was cut
    std::vector<Index> regions;  ///< of one that is none: those about it, as of faces; ascending
    std::vector<std::array<Index, 2>> segments;
  };
  struct Vertex {
    Index vertex = kNone;  ///< in the node
    Index point = 0;
  };
  std::vector<RationalPoint> points;
  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<Vertex> vertices;
};

/// All cells of a flattened value; regions that are not active become none.
PictureCells picture_cells(const Complex& complex, const FlatComplex& flat);

/// What lies on the other side of the plane than `towards` points to (on that of the normal, if along the plane),
/// and in the plane the regions that it cuts as faces. Exact: the kernel refines cells and plane together. The
/// regions of the node must be bounded.
PictureCells cut(const PictureCells& cells, const DrawOptions::Cut& plane, const RationalPoint& towards,
                 int threads);

}  // namespace cnrg
