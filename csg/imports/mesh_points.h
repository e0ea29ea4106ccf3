// The points of a mesh, equal ones merged, with exact tests that stay in doubles where they can.
#pragma once

#include <cstdint>
#include <vector>

#include "csg/imports/mesh_file.h"

namespace cnrg {

class MeshPoints {
 public:
  /// Takes the points of `mesh`; of equal ones the first is kept. Numbers are given in the order of the file.
  explicit MeshPoints(const MeshData& mesh);
  std::size_t size() const { return xyz_.size() / 3; }
  /// The number of the point that point `index` of the file became.
  std::uint32_t number(std::uint32_t index) const { return number_[index]; }
  const double* xyz(std::uint32_t p) const { return xyz_.data() + 3 * p; }
  /// The exact value of a point whose coordinates are not all doubles, or nullptr.
  const RationalPoint* exact(std::uint32_t p) const;
  RationalPoint value(std::uint32_t p) const;
  bool coplanar(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const;
  bool collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

 private:
  std::vector<double> xyz_;
  std::vector<std::pair<std::uint32_t, RationalPoint>> exact_;
  std::vector<std::uint32_t> number_;
};

}  // namespace cnrg
