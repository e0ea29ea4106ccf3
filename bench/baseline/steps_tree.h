// The steps of the Boolean as a tree file: a node for each, in order, then the result beside the exact one.
#pragma once

#include <string>

#include "bench/baseline/steps.h"

namespace cnrg::bench::mantyla {

struct StepsTitle {
  std::string system, verdict;  ///< in words
  bool solid = false;           ///< the result bounds a solid
  bool differs = false;         ///< by more than nothing, from the exact result
};

/// Text of the tree. Its result is the first picture, so that a page begins there. Operands have a loop per face.
std::string steps_tree(const Model& a, const Model& b, Operation operation, const Steps& steps,
                       const StepsTitle& title);

}  // namespace cnrg::bench::mantyla
