// Meshes of a result, before they are written: the caller sees them first.
#pragma once

#include "csg/mesh/curved_mesh.h"
#include "csg/mesh/surface_triangles.h"
#include "csg/mesh/tetrahedra.h"
#include "csg/result/result.h"

namespace cnrg {

/// As tetrahedra.h has it, with the fractions of graded materials.
TetrahedralMesh tetrahedra(const Result& result, const TetrahedraOptions& options);
/// The same of a result that rounding would break: this one is snapped, and `report` says what that did.
TetrahedralMesh snapped_tetrahedra(Result& result, const TetrahedraOptions& options, SnapReport& report);

/// As surface_triangles.h has it.
SurfaceTriangles surface_triangles(const Result& result, const SurfaceOptions& options);
/// The same of a result that rounding would break: this one is snapped, and `report` says what that did.
SurfaceTriangles snapped_surface_triangles(Result& result, const SurfaceOptions& options, SnapReport& report);

/// Brings tetrahedra to the true surfaces, with elements of second order (csg/mesh/curved_mesh.h). InputError for
/// a result that knows no parameters, such as a snapped one.
CurvedReport curve(const Result& result, TetrahedralMesh& made, const Watch& watch = {});

}  // namespace cnrg
