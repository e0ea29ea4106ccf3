// Points of a grid split so that each has one pair of parameters; see the head of vtu.cpp.
#pragma once

#include <map>
#include <tuple>

#include "csg/formats/vtu_grid.h"
#include "csg/result/flat.h"

namespace cnrg {

class VtuSplit {
 public:
  using Index = FlatComplex::Index;
  /// For a view with parameters. `xyz`: of the flattened result's points, which keep their numbers, without
  /// parameters; split ones come after them.
  VtuSplit(const ResultView& view, const FlatComplex& flat, const std::vector<std::array<double, 3>>& xyz);

  /// Triangle k of a face on split points.
  std::array<Index, 3> triangle(Index face, std::size_t k) const { return triangles_[first_[face] + k]; }
  /// A row of the names; 0 where the face has no parameters.
  std::int32_t patch(Index face) const { return patches_[face]; }
  /// Notes the next cell of the grid.
  void add_cell(std::int32_t patch) { parameters_.patches.push_back(patch); }

  const std::vector<std::array<double, 3>>& points() const { return xyz_; }
  const VtuParameters& parameters() const { return parameters_; }

 private:
  Index split(Index point, std::int32_t patch, const Parameters& at);

  std::vector<std::array<double, 3>> xyz_;
  VtuParameters parameters_;
  std::vector<std::array<Index, 3>> triangles_;  // of all faces
  std::vector<std::size_t> first_;               // of each face among them
  std::vector<std::int32_t> patches_;            // by face
  std::map<std::tuple<Index, std::int32_t, Parameters>, Index> number_;
};

}  // namespace cnrg
