// The straight lines that segments of a result make, and where two of them meet in a small angle.
//
// Where two segments meet in less than 60 degrees, points on one lie in the diametral circles of pieces of the
// other: halved in turn, they would split each other for ever. So both are split at the same distances from where
// they meet (ruppert1995 has shells of powers of two). Segments end elsewhere than their partners
// do, so that powers of two are not enough: here each piece is split at the roundest binary number in the middle
// third of its distances. Whatever the pieces are, their ends come to agree.
//
// Where lines meet in a thin angle that would be too much: it takes as many points as the angle is small, and they
// make nothing better. There points of one line may lie near the other as they come.
//
// Segments that go on straight are one line, since what meets the first of them is near the second one, too.
#pragma once

#include <array>
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

  /// Does its line have a small angle?
  bool has_apex(const FacetMesh::Segment& segment) const {
    return apexes_[segment.input] != std::array{kNone, kNone};
  }
  /// Where a segment is to be split.
  Vector split_place(const FacetMesh& mesh, const FacetMesh::Segment& segment) const;
  /// To be told of each point that splits a segment.
  void add_point(Index point, const FacetMesh::Segment& segment) { on_[point] = {line_[segment.input]}; }

  /// Do two points lie on two lines that meet in less than 60 degrees, as seen from where they meet?
  bool across_small_angle(const FacetMesh& mesh, Index a, Index b) const;
  /// The same, and either they are as far from there, or the angle is a thin one (kThin).
  bool is_forced(const FacetMesh& mesh, Index a, Index b) const;
  /// Is a point on a line that meets that of a segment in a thin angle, beside it as seen from there?
  bool is_beside(const FacetMesh& mesh, Index point, const FacetMesh::Segment& segment) const;

 private:
  std::vector<Index> line_;                           // of each segment of the result
  std::vector<std::array<Index, 2>> apexes_;          // of each: points with small angles before and behind it
  std::unordered_map<Index, std::vector<Index>> on_;  // of each point: lines
  std::vector<std::vector<Index>> vertices_;          // of each line: points of the result, ascending

  struct Ray {
    Index segment;
    Vector direction;  // of length 1, from the point
    double length;
    bool sharp = false;
  };
  using Rays = std::unordered_map<Index, std::vector<Ray>>;  // by point
  void find_lines(const FacetMesh& mesh, const Rays& rays);
  static void find_sharp(const FacetMesh& mesh, Rays& rays);
  void find_apexes(const FacetMesh& mesh, const Rays& rays);
  template <class Found>
  bool any_apex(Index line, Index other, const Found& found) const;
  template <class Found>
  bool any_apex_between(Index a, Index b, const Found& found) const;
};

}  // namespace cnrg
