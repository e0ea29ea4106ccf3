// Files of the nodes of an evaluated tree.
#pragma once

#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/output/writer.h"

namespace cnrg {

/// Writes a kept node of an evaluation of `tree` as `write` (writer.h) does: with the node's name, the tree's
/// materials and the names of the leaves below it. TreeError at the node for what the format can not show.
RoundingReport write(const std::string& path, const Tree& tree, const Evaluation& evaluation, NodeId node);

}  // namespace cnrg
