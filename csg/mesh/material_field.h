// Graded materials, sampled for formats that hold numbers.
#pragma once

#include <span>

#include "csg/materials/sampler.h"
#include "csg/mesh/mesh.h"
#include "csg/result/cell_tags.h"

namespace cnrg {

/// The fractions of materials in a result that has a graded one.
class MaterialField {
 public:
  explicit MaterialField(const ResultView& view);
  /// No material changes with position.
  bool empty() const { return names_.empty(); }
  /// The materials that mixtures of the result are of, in the order of the view's.
  const std::vector<std::string>& names() const { return names_; }
  /// Their fractions in a component at a point, rounded to the nearest doubles; all 0 where there is no material.
  std::vector<double> at(Component component, const RationalPoint& p) const;
  /// The same at the centroid of points.
  std::vector<double> at(Component component, std::span<const std::array<double, 3>> corners) const;

 private:
  std::vector<std::string> names_;
  std::vector<RegionAttributes> components_;
  std::vector<MaterialSampler> samplers_;  ///< of component i at i - 1
};

/// Fills `mesh.fields`: fractions at the corners of the tetrahedra.
void sample_materials(const ResultView& view, Mesh& mesh);

/// Fills `mesh.properties` from the tags of its entities.
void add_properties(const ResultView& view, Mesh& mesh);

}  // namespace cnrg
