// Meshes of a result, before they are written: the caller sees them first.
#pragma once

#include "csg/mesh/surface_triangles.h"
#include "csg/mesh/tetrahedra.h"
#include "csg/result/result.h"

namespace cnrg {

/// As tetrahedra.h has it, with the fractions of graded materials; then curved and split, as asked for. InputError
/// for a curved mesh of a result that knows no parameters, such as a snapped one.
TetrahedralMesh tetrahedra(const Result& result, const TetrahedraOptions& options);
/// The same of a result that rounding would break: this one is snapped, and `report` says what that did. A curved
/// mesh is of the exact result.
TetrahedralMesh snapped_tetrahedra(Result& result, const TetrahedraOptions& options, SnapReport& report);

/// As surface_triangles.h has it.
SurfaceTriangles surface_triangles(const Result& result, const SurfaceOptions& options);
/// The same of a result that rounding would break: this one is snapped, and `report` says what that did.
SurfaceTriangles snapped_surface_triangles(Result& result, const SurfaceOptions& options, SnapReport& report);

}  // namespace cnrg
