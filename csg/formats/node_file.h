// Files of the nodes of an evaluated tree.
#pragma once

#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/writer.h"
#include "csg/mesh/tetrahedra.h"
#include "csg/result/snap.h"

namespace cnrg {

/// The formats of `write` below: those of writer.h, and
///   .dot          the DAG with its counts (the evaluation must have rows)
///   .regions.dot  which regions of the node touch
/// Throws InputError if no writer knows the extension: to be asked before long work.
void check_file_name(const std::string& path);
/// True for a `.dot` of the DAG.
bool shows_dag(const std::string& path);

/// True for the formats that hold exact numbers or none, which `--snap` does not change: .json and both kinds of
/// .dot.
bool is_exact(const std::string& path);

/// The kept node on doubles; `raw` as the evaluation was. TreeError at the node for what can not be snapped.
SnappedResult snap(const Tree& tree, const Evaluation& evaluation, NodeId node, bool raw = false);

/// How a node is shown in a file.
struct FileOptions {
  bool parameters = false;                 ///< ResultView::parameters, for the exact result only
  const SnappedResult* snapped = nullptr;  ///< shown in its place where the format is not exact
};

/// Writes a kept node of an evaluation of `tree` as `write` (writer.h) does: with the node's name, the tree's
/// materials and the names of the leaves below it. TreeError at the node for what the format can not show.
RoundingReport write(const std::string& path, const Tree& tree, const Evaluation& evaluation, NodeId node,
                     const FileOptions& options = {});

/// The formats of tetrahedra: .msh .mesh .vtu. Throws InputError for any other extension.
void check_mesh_file_name(const std::string& path);
/// The tetrahedra of a kept node, of its snapped form if there is one. TreeError at the node for what can not be
/// meshed.
TetrahedralMesh tetrahedra(const Tree& tree, const Evaluation& evaluation, NodeId node,
                           const TetrahedraOptions& options = {}, const SnappedResult* snapped = nullptr);
/// Writes the mesh of a kept node to `path`, beside and renamed.
void write(const std::string& path, const Tree& tree, const Evaluation& evaluation, NodeId node, const Mesh& mesh);

}  // namespace cnrg
