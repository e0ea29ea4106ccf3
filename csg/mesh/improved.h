// The tetrahedra of a mesher, improved (kernel/tetrahedra/improve.h).
#pragma once

#include <string>

#include "csg/mesh/plc.h"
#include "kernel/tetrahedra/improve.h"

namespace cnrg {

/// Points that are added at most for shapes alone, to a mesh of so many.
constexpr std::size_t points_for_shapes(std::size_t points) { return 2'000 + 4 * points; }

/// Is there a face, a wire or a point that no region has inside of it or on its boundary? Then the tetrahedra
/// outside of all regions are improved, too, so that it stays.
bool has_outside(const FlatComplex& flat);

/// The same regions, facets and edges in better tetrahedra. `mesh` must be proven to conform. Tetrahedra outside
/// of all regions are left out unless something of the result lies there. `end`: as `improve` returns it.
PlcMesh improved(const Plc& plc, const FlatComplex& flat, const PlcMesh& mesh, ImproveOptions options,
                 const Watch& watch, Improved* end = nullptr);

/// What an end before it was done has left undone, for a notice.
std::string unfinished_text(const ImproveOptions& asked, Improved end);

}  // namespace cnrg
