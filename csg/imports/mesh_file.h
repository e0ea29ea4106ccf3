// Mesh files, read.
#pragma once

#include <string>

#include "csg/leaves/mesh_data.h"

namespace cnrg {

/// Reads a mesh by the extension of `path` (.off .obj .stl .ply .vtp .vtu .vtk .msh .glb .3mf .ts .pl .wl, in any
/// case). Coordinates are the doubles that the text rounds to; with `decimal` exactly the decimals of a text file.
/// Throws LeafFileError
/// (`path:line: error: ...`, for binary data `path: byte N: error: ...`) for a fault in the file, InputError if
/// the extension is unknown; else as `read_file` (csg/text/input_file.h).
MeshData read_mesh(const std::string& path, bool decimal, const std::string& inside = {});

/// What reads .vtp, with its version; in a build without it that it is lacking, and what to install.
std::string vtp_library();

/// `read_mesh` knows the extension.
bool is_mesh_file(const std::string& path);

// One reader each. `text` is the file's content, `path` is for messages.
MeshData read_off(const std::string& path, const std::string& text, bool decimal);
MeshData read_obj(const std::string& path, const std::string& text, bool decimal);
MeshData read_stl(const std::string& path, const std::string& text, bool decimal);
MeshData read_ply(const std::string& path, const std::string& text, bool decimal);
MeshData read_vtp(const std::string& path, const std::string& text, bool decimal);
MeshData read_vtk(const std::string& path, const std::string& text, bool decimal);
MeshData read_msh(const std::string& path, const std::string& text, bool decimal);
MeshData read_glb(const std::string& path, const std::string& text, bool decimal);
MeshData read_3mf(const std::string& path, const std::string& text, bool decimal);
MeshData read_gocad(const std::string& path, const std::string& text, bool decimal);

}  // namespace cnrg
