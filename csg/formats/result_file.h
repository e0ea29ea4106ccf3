// Files of results, written and read. The extension of the name chooses the format; a file appears whole
// or not at all (csg/text/file.h).
#pragma once

#include <optional>
#include <stop_token>
#include <string>

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

/// Throws InputError unless `path` is a .msh, where FileOptions::one_group changes something.
void check_one_group_file_name(const std::string& path);

/// The same result on doubles, kept from file to file: made when a file first needs it.
struct SnappedResultOnce {
  std::optional<Result> result;
  SnapReport report;
};

/// How a result is shown in a file.
struct FileOptions {
  /// .json and .vtu say the parameters of faces on curved patches; such a .vtu is not snapped.
  bool parameters = false;
  /// Where rounding to doubles would break the result (csg/result/rounding.h), a file of doubles gets the snapped
  /// one (csg/result/result.h). False: it is written as it is rounded, and the report says so; .poly and .smesh
  /// refuse it.
  bool snap = true;
  bool binary = false;                   ///< of .stl and .ply
  bool one_group = false;                ///< of .msh: each element is in its first group alone
  SnappedResultOnce* snapped = nullptr;  ///< of this result, for the files after this one; nullptr: not kept
  std::stop_token stop{};                ///< may end the writing (Stopped): then the old file is untouched
};

/// What became of the digits of a result in a file.
struct FileReport : RoundingReport {
  SnapReport snapped;  ///< `rounds` is 0 unless the result was snapped
};

/// Writes a result: .json .vtu .msh .msh2 .mesh .smesh .poly .inp .bdf .h5m .med .obj .off .stl .ply .3mf .glb
/// .step .stp
///   .brep, and
///   .regions.dot  which of its regions touch
/// Throws InputError for an unknown extension or a result that the format cannot represent (the message says
/// why and what to use instead), FileError if the file cannot be written; the old file is then untouched.
FileReport write(const std::string& path, const Result& result, const FileOptions& options = {});
/// Writes the DAG of an evaluation with its counts, as .dot. The evaluation must have rows.
void write(const std::string& path, const Evaluation& evaluation);

/// The result that a .json holds, exactly, on a complex of its own. Cells come from one leaf, the file.
Result read_result(const std::string& path);
/// The same of the text of a .json; `names.result` is the name in messages.
Result result_of_text(const std::string& json, ResultNames names);

/// The formats of tetrahedra: .msh .msh2 .mesh .vtu .inp .bdf .h5m .f3grid .med .xdmf. Throws InputError for any
/// other extension; the message names `others`, which the caller writes itself (` .html`), too.
void check_mesh_file_name(const std::string& path, const std::string& others = {});

}  // namespace cnrg
