// Files of the nodes of an evaluated tree.
#pragma once

#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/output/writer.h"

namespace cnrg {

/// The formats of `write` below: those of writer.h, and
///   .dot          the DAG with its counts (the evaluation must have rows)
///   .regions.dot  which regions of the node touch
/// Throws InputError if no writer knows the extension: to be asked before long work.
void check_file_name(const std::string& path);
/// True for a `.dot` of the DAG.
bool shows_dag(const std::string& path);

/// Writes a kept node of an evaluation of `tree` as `write` (writer.h) does: with the node's name, the tree's
/// materials and the names of the leaves below it. TreeError at the node for what the format can not show.
RoundingReport write(const std::string& path, const Tree& tree, const Evaluation& evaluation, NodeId node);

}  // namespace cnrg
