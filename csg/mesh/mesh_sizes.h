// How long edges of the mesh of a result are to be: the field of sizes that it asks for.
//
// What asks:
//   * the overall size: nowhere longer;
//   * what the tree says of a leaf (csg/tree/sizes.h): on the faces, wires and points of the result that come from
//     it, and in regions that lie in it (csg/result/sizes.h);
//   * by themselves, each straight piece of an edge or a wire, its length, and each facet, its width, on
//     themselves: a mesh conforms to them, so its edges are no longer there, and where they are short, longer
//     edges beside them would make flat tetrahedra.
// From there lengths grow. The width of a facet is four times its area over its perimeter, which is the side of a
// square and twice the width of a strip; of triangles more by the square root of 3, which is the side of one with
// equal sides. A piece or a facet that is smaller than a thousandth of the model's diagonal asks for that:
// slivers, as they come of rounding and of parts that nearly touch, would cost thousands of tetrahedra each. Where
// such a facet is narrow, 64 times as long as wide, it asks for nothing, nor does a piece that only crosses such
// ones, or leads a wire through so thin a part: flat tetrahedra are there whatever the sizes are, and those
// beside the part do not know how thin it is.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "csg/mesh/size_field.h"
#include "csg/result/rounding.h"

namespace cnrg {

struct SizeOptions {
  double size = 0;      ///< nowhere longer; 0: no bound
  double growth = 0.3;  ///< by how much edges may be longer per unit of distance
  bool always = false;  ///< pieces and facets ask also where nobody has said any size
  bool said = false;    ///< they do not ask at all
  bool wide = false;    ///< those that are narrow do not ask, however small they are
};

struct MeshSizes {
  using Index = FlatComplex::Index;
  SizeField field;
  std::vector<double> regions;  ///< by region of the flattened result: nowhere longer in it; empty: no bounds
  bool empty() const { return field.empty(); }
  /// Infinity where no region has a bound of its own.
  double least_in_regions() const {
    return regions.empty() ? std::numeric_limits<double>::infinity()
                           : *std::min_element(regions.begin(), regions.end());
  }
  /// At a point of a region.
  double at(const SizeField::Vector& p, Index region) const {
    const double size = field.at(p);
    return region < regions.size() ? std::min(size, regions[region]) : size;
  }
};

/// What a piece or a facet asks for at least: a thousandth of the model's diagonal.
double least_asked(const RoundedPoints& points);

/// No field (it is empty) if nobody says a size. Points are those of `flat`, rounded. Throws InputError as
/// SizeField does.
MeshSizes mesh_sizes(const ResultView& view, const FlatComplex& flat, const RoundedPoints& points,
                     const SizeOptions& options);

}  // namespace cnrg
