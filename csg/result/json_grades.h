// Graded materials as members of a .json (the format is that of csg/formats/result.schema.json).
#pragma once

#include <string>
#include <vector>

#include "csg/materials/grade.h"

namespace cnrg {

/// The graded materials of a result, each once; those that a blend is of come before it.
class GradeNumbers {
 public:
  /// Materials that are not graded are passed over.
  void add(const RegionMaterial& material);
  std::size_t number(const RegionMaterial& material) const;
  const std::vector<RegionMaterial>& all() const { return grades_; }
  /// Appends the entry of one of `all` in the list `grades`.
  void append(std::string& text, const RegionMaterial& material) const;

 private:
  std::vector<RegionMaterial> grades_;
};

}  // namespace cnrg
