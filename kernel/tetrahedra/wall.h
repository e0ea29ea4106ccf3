// A facet as a union of faces.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "kernel/refine/box_tree.h"
#include "kernel/tetrahedra/tetrahedra.h"

namespace cnrg {

/// Makes a facet out of faces: tetrahedra that it passes through are taken away, and the two halves of each hole
/// are filled by tetrahedra with corners of the hole alone (gift wrapping, shewchuk2000). Each new one stands on a
/// face that is open, with the corner around whose sphere no other corner is that the face sees.
class Wall {
 public:
  using Index = Tetrahedra::Index;
  using Triangle = std::array<VertexId, 3>;
  using Ends = std::array<VertexId, 2>;

  /// `facet`: triangles of one plane, turned alike, that overlap nowhere. `border`: its sides, each with the facet
  /// on its left; they must be edges.
  Wall(const PointTable& points, Tetrahedra& tetrahedra, std::span<const Triangle> facet,
       std::vector<Ends> border);

  /// The faces, turned as the facet; `count` are known to be needed.
  std::vector<Triangle> faces(std::size_t count);

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
  std::span<const Triangle> facet_;
  std::vector<Ends> border_;       // sorted
  std::vector<VertexId> corners_;  // of facet and border, sorted
  std::optional<BoxTree> boxes_;   // of triangles, where they are many
  std::unordered_map<VertexId, int> side_;

  int side(VertexId v);
  std::vector<Triangle> find();
  std::vector<Triangle> inside(const std::vector<Triangle>& faces) const;
  void clear_the_way();
  bool pierced(Index t);
  void fill(std::span<const Index> hole);
  void wrap(Open& open, const std::vector<VertexId>& corners, Open* floor);
  VertexId apex(const Triangle& base, const Open& open, const std::vector<VertexId>& corners) const;
  bool overlap(const Tetrahedra::Corners& t, const Triangle& face) const;
  bool overlap_in_plane(const std::vector<VertexId>& p, const std::vector<VertexId>& q, VertexId off) const;
  bool overlap_on_line(std::vector<VertexId> p, std::vector<VertexId> q) const;
};

}  // namespace cnrg
