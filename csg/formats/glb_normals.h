// Normals at the corners of triangles, for programs that shade.
//
// The obvious way takes the mean of the triangles around a point. It rounds off edges, and on a curved face it
// depends on how that was cut. Here a corner of a curved face has the normal of the true surface, S_u x S_v at its
// own parameters; a corner of any other face that of its facet. So an edge between two faces stays sharp, and a
// cylinder is round with few facets.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "csg/curves/surface_placed.h"
#include "csg/result/flat.h"
#include "kernel/base/vectors.h"

namespace cnrg {

class CornerNormals {
 public:
  using Index = FlatComplex::Index;
  /// Keeps references. `points`: those of the flattened result as doubles, up to a common factor and offset that
  /// keep them near 1. Without parameters in the view no surface is known.
  CornerNormals(const ResultView& view, const FlatComplex& flat, const std::vector<DoubleVector>& points)
      : view_(view), flat_(flat), points_(points) {}

  /// At the corners of each triangle of a face, to its front, of length 1.
  std::vector<std::array<DoubleVector, 3>> of(Index face);

 private:
  const ResultView& view_;
  const FlatComplex& flat_;
  const std::vector<DoubleVector>& points_;
  std::map<FlatComplex::Patch, PlacedSurface> surfaces_;

  /// A place on a patch.
  struct Site {
    FlatComplex::Patch patch;
    Parameters at;
  };
  /// Of a face of one surface but of several patches: places of the corners of its cells.
  using Corners = std::map<RationalPoint, std::vector<Site>>;

  DoubleVector facet_normal(const FlatComplex::Face& face, std::size_t begin, std::size_t end) const;
  const PlacedSurface* surface(const FlatComplex::Patch& patch);
  std::vector<Site> sites(const FlatComplex::Face& face, std::size_t facet, const Corners& corners,
                          const RationalPoint& p) const;
  DoubleVector nearest_normal(const std::vector<Site>& sites, const DoubleVector& flat);
};

}  // namespace cnrg
