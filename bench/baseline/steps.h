// What the stages of the Boolean find, as drawings: points, lines and faces by what they are, for people who learn
// the algorithm. The algorithm knows nothing of it: the drawings are made of the scene between its stages.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bench/baseline/variant.h"

namespace cnrg::bench::mantyla {

/// What is drawn alike. Faces have one loop each.
struct Drawing {
  std::string name;  ///< such as `in B`
  Model model;
};

/// A picture of what a stage found.
struct Step {
  std::string name;  ///< such as `null edges`
  std::vector<Drawing> drawings;
  bool with_edges = true;  ///< the edges of the operands are part of it
};

struct StepCounts {
  std::size_t contacts = 0;    ///< vertices at vertices or in faces of the other solid, after reduction
  std::size_t crossings = 0;   ///< of these, where one neighbourhood crosses the other
  std::size_t null_pairs = 0;  ///< pairs of null edges
  std::size_t loops = 0;       ///< closed curves of joined null edges
};

struct Steps {
  std::array<Drawing, 2> edges;  ///< of the operands, as reduction leaves them: parted at contacts
  std::vector<Step> steps;       ///< in order; the last one may be of the stage that failed
  StepCounts counts;
  std::optional<Failure> failure;
  Model result;  ///< as the system gives it back; of no meaning where it failed
};

/// Runs a variant on two operands.
Steps steps_of(const Model& a, const Model& b, Operation operation, const Variant& variant);

}  // namespace cnrg::bench::mantyla
