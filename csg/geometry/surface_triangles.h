// Triangles of a surface that do not depend on how other leaves cut its faces.
#pragma once

#include <array>
#include <vector>

#include "kernel/complex/complex.h"

namespace cnrg {

/// Of faces as large as their planes allow, each counter-clockwise as seen along the axis that is nearest to its
/// normal, in an order of their own. `axes`: of what was moved, as CanonicalPoints takes them.
std::vector<std::array<VertexId, 3>> surface_triangles(const Complex& complex, const std::vector<FaceId>& faces,
                                                       const LeafAxes* axes = nullptr);

}  // namespace cnrg
