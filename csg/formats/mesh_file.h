// Tetrahedra of a result and their files, step by step: who calls these sees the mesh before it is written.
#pragma once

#include <string>

#include "csg/mesh/tetrahedra.h"
#include "csg/result/result.h"

namespace cnrg {

/// As tetrahedra.h has it, with the fractions of graded materials.
TetrahedralMesh tetrahedra(const Result& result, const TetrahedraOptions& options);

/// Writes the mesh of a result to `path`; the file appears whole or not at all (csg/text/file.h).
void write(const std::string& path, const Result& result, const Mesh& mesh);

}  // namespace cnrg
