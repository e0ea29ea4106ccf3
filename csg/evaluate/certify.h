// What `--certify` asks of an evaluation: that what is true of facets is true of the surfaces that they stand for.
#pragma once

#include <vector>

#include "csg/evaluate/evaluate.h"

namespace cnrg {

struct Certificate {
  std::size_t edges = 0;            ///< those where a curved patch meets a patch of another leaf
  std::size_t places = 0;           ///< where that is not proven to be transversal (transversality.h)
  std::vector<Diagnostic> notices;  ///< of the first places, at their leaves
};

/// Places are told one by one, at most `listed` of them.
Certificate certify(const Tree& tree, const Evaluation& evaluation, std::size_t listed = 10);

}  // namespace cnrg
