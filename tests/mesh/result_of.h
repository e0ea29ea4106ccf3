// Results of a few nodes, of which the last is `model`.
#pragma once

#include <string>

#include "csg/evaluate/evaluate.h"

namespace cnrg {

inline Result result_of(const std::string& nodes, Refining refining = Refining::chosen) {
  EvaluateOptions options;
  options.refining = refining;
  return evaluate(parse_tree("cnrg: 1\nnodes:\n" + nodes + "result: model\n", "t.yaml"), options).result();
}

inline const std::string kBlock = "  model: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n";

}  // namespace cnrg
