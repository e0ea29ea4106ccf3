// Meshes and their files.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "csg/mesh/mesh_of_result.h"

namespace cnrg {

/// The formats of meshes of second order: those of tetrahedra but .mesh and .h5m. Throws InputError for any other
/// extension; the message names `others`, which the caller writes itself, too.
void check_second_order_file_name(const std::string& path, const std::string& others = {});

/// The formats of meshes with quadrilaterals: all of tetrahedra but .h5m. Throws InputError for any other
/// extension; `others` are named, too.
void check_quads_file_name(const std::string& path, const std::string& others = {});

/// The same of wedges: .msh .msh2 .vtu .inp.
void check_interfaces_file_name(const std::string& path, const std::string& others = {});

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
