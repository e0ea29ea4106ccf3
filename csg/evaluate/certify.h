// What is asked of an evaluation: whether what is true of facets is true of the surfaces that they stand for.
//
// Leaves cross in many places that no node asked for has any trace of, such as inside of a union. There it does
// not matter how they cross, so only edges of the values that were kept are looked at.
#pragma once

#include <vector>

#include "csg/evaluate/evaluate.h"

namespace cnrg {

struct Certificate {
  std::size_t edges = 0;   ///< of the kept values: those where a curved patch meets a patch of another leaf
  std::size_t places = 0;  ///< where that is not proven to be transversal (transversality.h)
  std::vector<Diagnostic> notices;  ///< of the first places, at their leaves
};

/// Places are told one by one, at most `listed` of them. `at_vertices`: as of `transversality`.
Certificate certify(const Tree& tree, const Evaluation& evaluation, std::size_t listed = 10,
                    bool at_vertices = true);

}  // namespace cnrg
