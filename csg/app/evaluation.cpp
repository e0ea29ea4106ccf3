#include "csg/app/evaluation.h"

#include <iostream>

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

void print(const std::vector<Diagnostic>& diagnostics, bool quiet) {
  for (const Diagnostic& d : diagnostics) {
    if (!quiet || d.level == Diagnostic::Level::warning) std::cerr << d.text() << "\n";
  }
}

}  // namespace cnrg::app
