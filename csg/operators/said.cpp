// Rules for the attributes of a cell that two operands have.
#include "csg/operators/said.h"

namespace cnrg {

SaidPointer merged(const SaidPointer& left, const SaidPointer& right, Dominance dominance) {
  if (right == nullptr || left == right) return left;
  if (left == nullptr) return right;
  if (left->dimension != right->dimension) return left->dimension < right->dimension ? left : right;
  if (dominance != Dominance::equal) return dominance == Dominance::left ? left : right;
  Said filled = *left;
  fill_in(filled.attributes, right->attributes);
  return filled == *left ? left : std::make_shared<const Said>(std::move(filled));
}

std::vector<Yielded> at_odds(const SaidPointer& left, const SaidPointer& right, int dimension) {
  std::vector<Yielded> yielded;
  if (left == nullptr || right == nullptr || left == right) return yielded;
  if (left->dimension != dimension || right->dimension != dimension) return yielded;
  Attributes filled = left->attributes;
  fill_in(filled, right->attributes, yielded);
  return yielded;
}

}  // namespace cnrg
