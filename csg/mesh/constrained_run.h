// Tetrahedra where TetGen makes none: the kernel's constrained tetrahedra, moved to doubles.
//
// They conform to whatever is embedded; but their shapes are those that the points of the model give them, there
// are no points to make them better.
#pragma once

#include "csg/mesh/plc.h"
#include "kernel/base/progress.h"

namespace cnrg {

/// Tetrahedra of the active regions. `plc`: of triangles alone (PlcFacets::triangles), embedded. Points that are
/// added lie on segments and facets, but for what doubles cannot tell; throws NearFault
/// (kernel/tetrahedra/constrained.h) with the place where there are no such doubles, Stopped.
PlcMesh run_constrained(const Plc& plc, const FlatComplex& flat, const Watch& watch);

}  // namespace cnrg
