// Tetrahedra where TetGen makes none: constrained Delaunay tetrahedra in exact arithmetic, rounded.
//
// They conform to whatever is embedded, and come in a time that is known before; but their shapes are those that
// the points of the model give them, there are no points to make them better.
#pragma once

#include "csg/mesh/plc.h"
#include "kernel/base/progress.h"

namespace cnrg {

/// Tetrahedra of the active regions. `plc`: of triangles alone (PlcFacets::triangles), embedded. Points that are
/// added lie on segments and sides, and are rounded to doubles so that each tetrahedron keeps its turn; throws
/// NearFault (kernel/tetrahedra/constrained.h, which has `cuts`, too) with the place where that cannot be,
/// Stopped.
PlcMesh run_constrained(const Plc& plc, const FlatComplex& flat, const Watch& watch, double cuts);

}  // namespace cnrg
