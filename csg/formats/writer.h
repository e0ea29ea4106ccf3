// Files of results: one writer per format, chosen by the extension.
#pragma once

#include <string>

#include "csg/result/result_view.h"

namespace cnrg {

/// Throws InputError if no writer knows the extension of `path`: to be asked before long work.
void check_extension(const std::string& path);

/// Throws InputError if the format of `path` has no binary form that is written on request.
void check_binary(const std::string& path);

/// True for .step .stp .brep.
bool is_cad_file(const std::string& path);
/// True for the formats that want `view` with parameters, for its true surfaces: CAD models and .glb.
bool shows_surfaces(const std::string& path);

/// Writes `view` to `path` in the format of its extension: .json .vtu .msh .msh2 .mesh .smesh .poly .inp .bdf .h5m
/// .med .obj .off .stl .ply .3mf .glb .step .stp .brep. The file appears whole or not at all (csg/text/file.h).
/// Throws InputError for an unknown extension or a result that the format cannot represent (the message says
/// why and what to use instead), FileError if the file cannot be written; the old file is then untouched.
RoundingReport write(const std::string& path, const ResultView& view);

}  // namespace cnrg
