// A result as a piecewise linear complex in doubles (si2015): what TetGen meshes.
#pragma once

#include "csg/mesh/rounded_result.h"

namespace cnrg {

struct Plc {
  using Index = std::uint32_t;
  /// A planar piece of a face: a triangle, or all of a facet whose boundary walks meet themselves nowhere.
  struct Facet {
    std::vector<std::vector<Index>> polygons;  ///< the outer one, then holes, then single points inside
    std::vector<std::array<double, 3>> holes;  ///< a point in each hole, in the plane but for rounding
    Index face = 0;
    Index piece = 0;  ///< the planar piece that it is a part of: of its face, or of a facet of that
  };
  struct Segment {
    std::array<Index, 2> ends;
    Index edge = 0;
    bool wire = false;
  };
  struct Seed {
    std::array<double, 3> point;
    Index region = 0;
  };
  std::vector<std::array<double, 3>> points;  ///< numbered as those of the flattened result
  std::vector<Facet> facets;
  std::vector<Segment> segments;     ///< all straight pieces of edges
  std::vector<Seed> regions, holes;  ///< active regions; bounded inactive ones
  double max_volume = 0;             ///< of a tetrahedron in a region; 0: no bound
};

/// What a mesher makes of it. The points of the complex keep their numbers; points of the mesher follow.
struct PlcMesh {
  using Index = Plc::Index;
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<Index, 4>> tetrahedra;
  std::vector<std::int32_t> attribute;  ///< of each tetrahedron: place in `Plc::regions` + 1; others: in no region
  std::vector<std::array<Index, 3>> triangles;
  std::vector<std::int32_t> facet;  ///< of each triangle: place in `Plc::facets`; more: of none
  std::vector<std::array<Index, 2>> segments;
  std::vector<std::int32_t> edge;  ///< of each segment: the edge, or -1 where there is none
};

/// Which facets of faces are given to the mesher as a whole; all others are given as their triangles.
enum class PlcFacets {
  triangles,  ///< none
  planar,     ///< facets that are planar in doubles, exactly
  all,        ///< all facets; rounding moves their points out of a plane by the last digits
};

/// The complex, without points of seeds.
Plc plc_of(const ResultView& view, const FlatComplex& flat, const RoundedResult& rounded, PlcFacets facets);
/// Its regions and cavities, without points of seeds.
void add_regions(Plc& plc, const FlatComplex& flat);
/// A point in each region and cavity. Throws InputError for one too thin to hold one that we find.
void set_seeds(Plc& plc, const RoundedResult& rounded);

}  // namespace cnrg
