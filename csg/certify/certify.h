// What is asked of an evaluation: whether what is true of facets is true of the surfaces that they stand for.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "csg/evaluate/evaluate.h"

namespace cnrg {

/// Where it is not proven: a connected set of pieces (csg/certify/proof.h) of the same patches.
struct UncertainPlace {
  std::vector<std::string> names;  ///< nodes of leaves, each with the name of its patch in brackets, if it has one
  std::vector<NodeId> nodes;
  std::array<double, 3> at{};
  double size = 0;         ///< within this length of `at` nothing was decided
  bool by_facets = false;  ///< finer facets would decide
};

struct Certificate {
  std::size_t asked = 0, apart = 0, crossing = 0, contacts = 0;  ///< pairs of facets: in all, and what was proven of them
  std::vector<UncertainPlace> places;
  std::vector<Diagnostic> notices(const Tree& tree, std::size_t most) const;  ///< of the first places
};

/// Of all leaves below the nodes that were kept.
Certificate certify(const Evaluation& evaluation);

}  // namespace cnrg
