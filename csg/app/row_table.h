// The rows of `cnrg eval`: one line per node and per stage, columns aligned.
#pragma once

#include <optional>
#include <string>

#include "csg/app/stopwatch.h"
#include "csg/evaluate/evaluate.h"

namespace cnrg::app {

/// Seconds that are of no node; with those of the rows they are all that the program took.
struct StageRows {
  double leaves = 0, refinement = 0;  ///< before the nodes
  std::optional<double> crossings;    ///< nothing: no curved surface crosses another one
  std::optional<double> results;      ///< nothing: they were not all written
};

/// The time that is of no node. `whole`: files are written, and that is told, too. `crosses`: a
/// curved surface crosses another one.
StageRows stage_rows(const StageClock& clock, const Evaluation& evaluation, bool crosses, bool whole);

/// The table with its head: stages have no name, so that none is taken for a node. `raw`: unsimplified counts.
/// `trace`: under each node a line per table row that removed something, and a line per region with its volume.
std::string row_table(const Evaluation& evaluation, const StageRows& stages, bool raw, bool trace);

/// The same as JSON.
std::string rows_json(const Evaluation& evaluation, const StageRows& stages, bool raw);

/// The one refinement of all leaves in a few lines: cells, contacts, stages of the predicates, seconds.
std::string refinement_summary(const Evaluation& evaluation);

}  // namespace cnrg::app
