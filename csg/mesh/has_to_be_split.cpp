#include "csg/mesh/has_to_be_split.h"

#include "csg/mesh/quality.h"
#include "kernel/base/vectors.h"
#include "kernel/tetrahedra/bounds.h"
#include "kernel/tetrahedra/shapes.h"

namespace cnrg {
namespace {

using Vector = std::array<double, 3>;
using TetrahedronCorners = std::array<Vector, 4>;

Vector center_of(const TetrahedronCorners& corners) {
  Vector middle{};
  for (const Vector& p : corners)
    for (std::size_t k = 0; k < 3; ++k) middle[k] += p[k] / 4;
  return middle;
}

}  // namespace

TooLarge larger_than(const MeshSizes& sizes, const RegionLocator& regions, const FlatComplex& flat) {
  return [sizes, least = sizes.least_in_regions(), &regions, &flat](const TetrahedronCorners& corners) {
    const auto& [a, b, c, d] = corners;
    const Vector middle = center_of(corners);
    const double longest = longest_edge_of(a, b, c, d).length / kLongestEdge;
    if (longest <= sizes.field.at(middle) && longest <= least) return false;
    const auto region = regions.at(middle);
    return flat.active(region) && longest > sizes.at(middle, region);
  };
}

TooLarge worse_where_wide(double radius_edge, double volume, const TooLarge& larger, const RegionLocator& regions,
                          const FlatComplex& flat) {
  return [=, &regions, &flat](const TetrahedronCorners& corners) {
    const auto& [a, b, c, d] = corners;
    if (is_flat(a, b, c, d)) return false;
    if (larger && larger(corners)) return true;
    const bool worse = radius_edge > 0 && radius_edge_of(a, b, c, d) > radius_edge;
    if (!worse && !(volume > 0 && measures_of(corners).volume > volume)) return false;
    return flat.active(regions.at(center_of(corners)));
  };
}

}  // namespace cnrg
