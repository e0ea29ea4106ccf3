// Meshes of a result and their files, step by step: the caller sees the mesh before it is written.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

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

/// The formats of meshes of second order: those of tetrahedra but .mesh and .h5m. Throws InputError for any other
/// extension; the message names `others`, which the caller writes itself, too.
void check_second_order_file_name(const std::string& path, const std::string& others = {});

/// The formats of meshes with quadrilaterals: all of tetrahedra but .h5m. Throws InputError for any other
/// extension; `others` are named, too.
void check_quads_file_name(const std::string& path, const std::string& others = {});

/// Writes the mesh of a result to `path`; the file appears whole or not at all (csg/text/file.h), also where it is
/// stopped (Stopped).
void write(const std::string& path, const Result& result, const Mesh& mesh, const std::stop_token& stop = {});

/// A file that holds what another one of the same mesh leaves out.
struct FurtherFile {
  std::string path;
  std::string holds;  ///< `120 segments`
};
/// Beside `NAME.xdmf`, which is a grid of elements of one dimension, those of the others: `NAME.faces.xdmf` and so
/// on. None is written unless it is asked for. Empty for other formats.
std::vector<FurtherFile> further_files(const std::string& path, const Mesh& mesh);

}  // namespace cnrg
