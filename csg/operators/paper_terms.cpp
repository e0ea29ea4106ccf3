#include "csg/operators/paper_terms.h"

namespace cnrg {

std::string condition_words(const TableRow& row) {
  std::string ours = words(row.condition);
  const auto not_free = [&](const std::string& operand) {
    return row.dimension == 1 ? "numFace" + operand + " > 0 or dangOrLoose"
                              : "numEdge" + operand + " > 0 or loose";
  };
  switch (row.condition) {
    case Condition::not_free_a: return ours + ": " + not_free("A");
    case Condition::not_free_b: return ours + ": " + not_free("B");
    case Condition::free_in_neither: return ours + ": " + not_free("") + ", in A and in B";
    case Condition::inside_region_b: return "insideB: " + ours;
    default: return ours;
  }
}

}  // namespace cnrg
