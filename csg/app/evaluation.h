// One way to evaluate for all commands: with a progress bar, and with what is to be said about the tree.
#pragma once

#include "csg/evaluate/evaluate.h"

namespace cnrg::app {

/// Evaluates behind a progress bar and prints the diagnostics; `quiet`: no bar, warnings only.
Evaluation evaluate_in_view(const Tree& tree, EvaluateOptions options, bool quiet);

/// Diagnostics on standard error; `quiet`: warnings only.
void print(const std::vector<Diagnostic>& diagnostics, bool quiet);

}  // namespace cnrg::app
