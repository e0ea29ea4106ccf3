// The nodes of an evaluated tree and their operands as a directed acyclic graph (DAG) with counts, for Graphviz.
#pragma once

#include <string>

#include "csg/evaluate/evaluate.h"

namespace cnrg {

/// One box per instance: name, operator, active cells by dimension, regions or components, volume; arrows from
/// operands to users, numbered where an operator has more than one. The evaluation must have rows.
std::string dag_dot(const Evaluation& evaluation);

}  // namespace cnrg
