// Which tetrahedra a mesher has to split: those that are larger than sizes say, or worse than is asked for.
#pragma once

#include "csg/mesh/mesh_sizes.h"
#include "csg/mesh/region_locator.h"
#include "csg/mesh/tetgen_run.h"

namespace cnrg {

/// Those of active regions with an edge of more than `kLongestEdge` (kernel/tetrahedra/bounds.h) times the size in
/// the middle of the tetrahedron; of all else that fills the box around the model none. What is given
/// must outlive the answer, but for the sizes.
TooLarge larger_than(const MeshSizes& sizes, const RegionLocator& regions, const FlatComplex& flat);

/// Those with a ratio of circumradius to shortest edge or a volume (0: no bound) beyond a bound, and those that
/// `larger` says, if there is one; but none that is flat (kernel/tetrahedra/shapes.h). TetGen bounds all shapes
/// or none, and does not end where walls are very near to each other.
TooLarge worse_where_wide(double radius_edge, double volume, const TooLarge& larger, const RegionLocator& regions,
                          const FlatComplex& flat);

}  // namespace cnrg
