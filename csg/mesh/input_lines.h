// The straight lines that segments of a result make, and where two of them meet in a small angle.
//
// Where two segments meet in less than 60 degrees, points on one lie in the diametral circles of pieces of the
// other: halved in turn, they would split each other for ever. So both are split at the same distances from where
// they meet (ruppert1995, section 5.3, has shells of powers of two). Segments end elsewhere than their partners
// do, so that powers of two are not enough: here each piece is split at the roundest binary number in the middle
// third of its distances. Whatever the pieces are, their ends come to agree.
//
// Segments that go on straight are one line, since what meets the first of them is near the second one, too.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "csg/mesh/facet_mesh.h"

namespace cnrg {

class InputLines {
 public:
  using Index = FacetMesh::Index;
  using Vector = DoubleVector;
  static constexpr Index kNone = FacetMesh::kNone;

  /// Of the segments as the result has them, none of them split.
  explicit InputLines(const FacetMesh& mesh);

  /// Where a segment is to be split.
  Vector split_place(const FacetMesh& mesh, const FacetMesh::Segment& segment) const;
  /// To be told of each point that splits a segment.
  void add_point(Index point, const FacetMesh::Segment& segment) { on_[point] = {line_[segment.input]}; }

  /// Do two points lie on two lines that meet in less than 60 degrees, as seen from where they meet? `level`: only
  /// if they are as far from there.
  bool across_small_angle(const FacetMesh& mesh, Index a, Index b, bool level) const;

 private:
  std::vector<Index> line_;                           // of each segment of the result
  std::vector<std::array<Index, 2>> apexes_;          // of each: points with small angles before and behind it
  std::unordered_map<Index, std::vector<Index>> on_;  // of each point: lines
  std::vector<std::vector<Index>> vertices_;          // of each line: points of the result, ascending

  struct Ray {
    Index segment;
    Vector direction;  // of length 1, from the point
    bool sharp = false;
  };
  using Rays = std::unordered_map<Index, std::vector<Ray>>;  // by point
  void find_lines(const FacetMesh& mesh, const Rays& rays);
  static void find_sharp(const FacetMesh& mesh, Rays& rays);
  void find_apexes(const FacetMesh& mesh, const Rays& rays);
};

}  // namespace cnrg
