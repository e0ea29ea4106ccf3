// The rows of `cnrg eval`: one line per node, columns aligned.
#pragma once

#include <string>
#include <vector>

#include "csg/evaluate/evaluate.h"

namespace cnrg::app {

/// The table with its head. `raw`: unsimplified counts. `trace`: under each node a line per table row that
/// removed something, and a line per region with its volume.
std::string row_table(const std::vector<NodeRow>& rows, bool raw, bool trace);

/// The one refinement of all leaves in a few lines: cells, contacts, stages of the predicates, seconds.
std::string refinement_summary(const Evaluation& evaluation);

}  // namespace cnrg::app
