// A tree, evaluated with all checks of values.
#pragma once

#include <string>

#include "csg/evaluate/evaluate.h"

namespace cnrg {

struct EvaluatedTree {
  Tree tree;
  Evaluation evaluation;
};

inline EvaluatedTree evaluated_tree(const std::string& text, bool keep_all = false) {
  EvaluatedTree r{parse_tree(text, "t.yaml"), {}};
  EvaluateOptions options;
  options.validate = true;
  options.keep_all = keep_all;
  r.evaluation = evaluate(r.tree, options);
  return r;
}

}  // namespace cnrg
