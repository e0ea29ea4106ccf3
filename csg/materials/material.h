// What a region is made of: a name, and beside it what only some materials have, a function of position (grade.h)
// and a dominance.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "csg/geometry/transform.h"

namespace cnrg {

struct PlacedGrade;

/// What a region is made of. Two are equal when names and functions of position are; a dominance says who wins,
/// not what is there.
class RegionMaterial {
 public:
  RegionMaterial() = default;
  RegionMaterial(std::string name, std::shared_ptr<const PlacedGrade> grade = nullptr)
      : name_(std::move(name)), grade_(std::move(grade)) {}
  RegionMaterial(const char* name) : name_(name) {}
  bool empty() const { return name_.empty(); }  ///< none is given
  const std::string& name() const { return name_; }
  const PlacedGrade* grade() const { return grade_.get(); }  ///< nullptr: one material all over

  /// Decides where the numbers of two operands are equal (csg/operators/material_levels.h); 0 unless it is set.
  const Rational& dominance() const;
  bool has_dominance() const { return dominance_ != nullptr; }  ///< it is not 0
  void set_dominance(const Rational& dominance);

  friend bool operator==(const RegionMaterial& a, const RegionMaterial& b);

 private:
  std::string name_;
  std::shared_ptr<const PlacedGrade> grade_;
  std::shared_ptr<const Rational> dominance_;  // nullptr: 0
};

}  // namespace cnrg
