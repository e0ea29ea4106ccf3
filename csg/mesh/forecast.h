// How many tetrahedra a mesh will have, told from the sizes that are asked for before any is made.
//
// Tetrahedra whose edges have the length h fill space with c / h^3 of them per unit of volume; so their number is
// the integral of that over the active regions. The integrand changes by orders of magnitude within a model, and
// regions may be thin: a grid misses what is small, points at random come too late. So a box around the model is
// halved along all axes where the doubt about its share is largest, and then points are strewn by share, the same
// in every run.
#pragma once

#include "csg/mesh/mesh_sizes.h"
#include "csg/mesh/region_locator.h"

namespace cnrg {

/// Who makes tetrahedra to sizes: TetGen, or the improver out of constrained ones (kernel/tetrahedra/improve.h).
enum class Maker : std::uint8_t { tetgen, own };

/// Of the mesh of a result, together, within 30 % where it is meshed by sizes and has hundreds; other bounds are
/// not seen. Takes some milliseconds, and up to a second for meshes of millions. `sizes` are not empty.
double expected_tetrahedra(const FlatComplex& flat, const RoundedPoints& points, const MeshSizes& sizes,
                           const RegionLocator& regions, Maker maker);

/// More than that are refused.
inline constexpr double kMostTetrahedra = 2e8;

/// Throws InputError, with what helps, if so many tetrahedra are more than kMostTetrahedra.
void require_possible(double expected);

/// `about 1,230,000`, with three digits that count; `more than 1,000,000,000,000,000`.
std::string count_text(double count);

}  // namespace cnrg
