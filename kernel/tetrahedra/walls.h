// Triangles as unions of faces, one after the other.
#pragma once

#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "kernel/tetrahedra/tetrahedra.h"

namespace cnrg {

/// Makes a triangle out of faces: tetrahedra that it passes through are taken away, and the two halves of that hole
/// are filled by tetrahedra with corners of the hole alone (gift wrapping, shewchuk2000). Each new one stands on a
/// face that is open, with the corner around whose sphere no other corner is that the face sees.
class Walls {
 public:
  using Index = Tetrahedra::Index;
  using Triangle = std::array<VertexId, 3>;
  Walls(const PointTable& points, Tetrahedra& tetrahedra) : points_(points), tetrahedra_(tetrahedra) {}

  /// `border`: the points on its sides, in their turn, its corners among them. Each step of it must be an edge.
  /// Returns the faces, turned as `triangle`.
  std::vector<Triangle> insert(const Triangle& triangle, std::span<const VertexId> border);

 private:
  using Face = Tetrahedra::Face;
  /// A face of a hole that has no tetrahedron there yet.
  struct OpenFace {
    Triangle corners;  ///< with the hole in front
    Face outside;      ///< as the tetrahedron behind has it, unless that is the end of the box
  };
  using Open = std::map<Triangle, OpenFace>;  ///< by sorted corners

  const PointTable& points_;
  Tetrahedra& tetrahedra_;
  Triangle triangle_{};
  std::unordered_map<VertexId, int> side_;  // of the plane of the triangle

  int side(VertexId v);
  std::vector<Triangle> faces_of(std::span<const VertexId> border);
  bool pierced(Index t);
  void fill(std::span<const Index> hole);
  void wrap(Open& open, const std::vector<VertexId>& corners, Open* floor);
  VertexId apex(const Triangle& base, const Open& open, const std::vector<VertexId>& corners) const;
  bool overlap(const Tetrahedra::Corners& t, const Triangle& face) const;
  bool overlap_in_plane(const std::vector<VertexId>& p, const std::vector<VertexId>& q, VertexId off) const;
  bool overlap_on_line(std::vector<VertexId> p, std::vector<VertexId> q) const;
};

}  // namespace cnrg
