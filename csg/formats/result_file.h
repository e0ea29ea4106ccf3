// Files of results, written and read. The extension of the name chooses the format; a file appears whole
// or not at all (csg/text/file.h).
#pragma once

#include <string>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "csg/result/result.h"

namespace cnrg {

/// Throws InputError if nothing below writes files of that extension: to be asked before long work. The message
/// names those that are known, and `others`, which the caller writes itself (` .svg .png`).
void check_file_name(const std::string& path, const std::string& others = {});
/// True for a `.dot` of the DAG.
bool shows_dag(const std::string& path);
/// True for the formats that hold no doubles, so that they do not need snapping: .json and both kinds of .dot.
bool is_exact(const std::string& path);

/// How a result is shown in a file.
struct FileOptions {
  /// .json and .vtu say the parameters of faces on curved patches; not of a snapped result.
  bool parameters = false;
};

/// Writes a result: .json .vtu .msh .mesh .smesh .poly .obj .off .stl .ply .3mf .glb .step .stp .brep, and
///   .regions.dot  which of its regions touch
/// Throws InputError for an unknown extension or a result that the format cannot represent (the message says
/// why and what to use instead), FileError if the file cannot be written; the old file is then untouched.
RoundingReport write(const std::string& path, const Result& result, const FileOptions& options = {});
/// Writes the DAG of an evaluation with its counts, as .dot. The evaluation must have rows.
void write(const std::string& path, const Evaluation& evaluation);

/// The result that a .json holds, exactly, on a complex of its own. Cells come from one leaf, the file.
Result read_result(const std::string& path);

/// The formats of tetrahedra: .msh .mesh .vtu. Throws InputError for any other extension.
void check_mesh_file_name(const std::string& path);

/// What tetrahedra were made.
struct TetrahedraReport {
  RoundingReport rounding;
  std::vector<RegionTetrahedra> regions;
  std::size_t points = 0, triangles = 0, segments = 0;  ///< of the mesh; triangles on faces, segments on edges
};

/// Fills the regions of a closed and bounded result with tetrahedra (csg/mesh/tetrahedra.h says what of them is
/// proven) and writes these to all the files. Throws InputError for a result that cannot be meshed.
TetrahedraReport write_tetrahedra(const std::vector<std::string>& paths, const Result& result,
                                  const TetrahedraOptions& options = {});

}  // namespace cnrg
