// Random exact points: the answer is to have those that the Boolean of the operands has, and no others.
#pragma once

#include "bench/witness/integral.h"

namespace cnrg::bench::witness {

/// ((operand0 step0 operand1) step1 operand2) ... and what somebody says it is.
struct Question {
  std::vector<Cycle> operands;
  std::vector<Operation> steps;
  Cycle answer;
  Number rounding;         ///< length: points as near to a face of an operand are not asked
  std::uint64_t seed = 1;  ///< the same points for the same seed
};

struct Points {
  std::size_t asked = 0;
  std::optional<Point> differs;  ///< the first one
  int winding = 0;               ///< of the answer around it: 0 or 1 if it is right
  bool expected = false;         ///< it is in the Boolean
};

/// A half of `count` in the box of all, and a half at faces of operands and answer, from far to near. Fewer are
/// asked where no way is found around edges and roundings.
Points ask(const Question& question, std::size_t count);

}  // namespace cnrg::bench::witness
