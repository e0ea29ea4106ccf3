// How problems are made, theme by theme. `make_problem` has checked the id.
#pragma once

#include <vector>

#include "bench/cases/family.h"

namespace cnrg::bench {

struct FamilyMaker {
  std::string name;
  std::vector<std::string> operations;  ///< as `ProblemId::operation`
  long smallest = 1, largest = 1;       ///< sizes that can be made
  bool has_distance = false;
  Problem (*make)(const ProblemId& id);
};

std::vector<FamilyMaker> generic_families();
std::vector<FamilyMaker> contact_families();
std::vector<FamilyMaker> turned_families();
std::vector<FamilyMaker> fold_families();
std::vector<FamilyMaker> mixed_families();
std::vector<FamilyMaker> ground_families();

/// All three of `Operation`.
inline const std::vector<std::string> kOperations{"union", "difference", "intersection"};
/// The operation of an id that is not `fold`.
Operation operation_of(const ProblemId& id);
/// The operands one after the other, by the operation of the id.
Problem problem_of(const ProblemId& id, std::vector<Model> operands);

}  // namespace cnrg::bench
