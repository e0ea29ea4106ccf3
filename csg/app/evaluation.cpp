// What all commands share: a tree read at the fineness asked for, an evaluation behind a progress bar, and the
// printing of its diagnostics.
#include "csg/app/evaluation.h"

#include <set>

#include "csg/app/output.h"
#include "csg/app/progress_bar.h"

namespace cnrg::app {

Evaluation evaluate_in_view(const Tree& tree, EvaluateOptions options, bool quiet) {
  ProgressBar bar(quiet);
  options.progress = [&](std::string_view stage, std::size_t done, std::size_t total) {
    bar.show(stage, done, total);
  };
  Evaluation evaluation = evaluate(tree, options);
  bar.clear();
  print(evaluation.diagnostics, quiet);
  return evaluation;
}

void require_distinct(const std::vector<std::string>& files) {
  std::set<std::string> seen;
  for (const std::string& file : files) {
    if (seen.insert(file).second) continue;
    throw InputError("cnrg: error: the file " + file + " is given by two -o; give each its own name");
  }
}

void print(const std::vector<Diagnostic>& diagnostics, bool quiet) {
  for (const Diagnostic& d : diagnostics) {
    if (!quiet || d.level == Diagnostic::Level::warning) tell(d.text());
  }
}

}  // namespace cnrg::app
