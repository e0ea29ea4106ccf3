// Most materials have no dominance and no grade: both are pointers, so that attributes are copied for the price of
// a name.
#include "csg/materials/material.h"

#include "csg/materials/grade.h"

namespace cnrg {

const Rational& RegionMaterial::dominance() const {
  static const Rational none = 0;
  return dominance_ ? *dominance_ : none;
}

void RegionMaterial::set_dominance(const Rational& dominance) {
  dominance_ = dominance == 0 ? nullptr : std::make_shared<const Rational>(dominance);
}

bool operator==(const RegionMaterial& a, const RegionMaterial& b) {
  return a.name_ == b.name_ && (a.grade_ == b.grade_ || (a.grade_ && b.grade_ && *a.grade_ == *b.grade_));
}

}  // namespace cnrg
