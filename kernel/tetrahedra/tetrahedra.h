// Tetrahedra that fill a box, each with its four neighbours.
//
// The box is a part of the mesh: eight corners of its own, far enough outside of all points, so that there is no
// border to treat in another way. Points are put in one by one; after each the tetrahedra are Delaunay: no point
// is inside of the sphere around one of them. Points that lie on one sphere are parted by perturbation
// (kernel/exact/in_sphere.h), so the order in which points come does not matter, and no tetrahedron is flat.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/exact/points.h"

namespace cnrg {

class Tetrahedra {
 public:
  using Index = std::uint32_t;
  static constexpr Index kNone = 0xffffffffu;
  /// det(b - a, c - a, d - a) > 0.
  using Corners = std::array<VertexId, 4>;
  /// The corners of the face opposite to corner k, by their places: a point on the side of corner k is in front.
  static constexpr std::array<std::array<int, 3>, 4> kFace{{{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};
  /// A face of a tetrahedron: the one opposite to its corner k.
  struct Face {
    Index tetrahedron = kNone;
    int k = 0;
  };

  /// The Delaunay tetrahedra of all points of the table, which must be distinct, and of eight corners of a box
  /// that are added to it.
  explicit Tetrahedra(PointTable& points);

  std::size_t size() const { return corners_.size(); }
  /// Numbers of tetrahedra that are no more are used again; until then they are not alive.
  bool alive(Index t) const { return corners_[t][0].valid(); }
  const Corners& corners(Index t) const { return corners_[t]; }
  Index neighbour(Index t, int k) const { return neighbours_[t][static_cast<std::size_t>(k)]; }
  std::array<VertexId, 3> face(Face f) const;
  /// The same face as its other tetrahedron has it; its `tetrahedron` is kNone on the box.
  Face opposite(Face f) const;
  bool on_box(VertexId v) const { return v >= first_corner_ && v.index() < first_corner_.index() + 8; }

  /// The tetrahedra at a vertex.
  void around(VertexId v, std::vector<Index>& out) const;
  bool has_edge(VertexId a, VertexId b) const;

  /// Puts a point of the table in. All tetrahedra must be Delaunay. `near` is a vertex that is in already, the
  /// nearer the better. Appends the edges that are no more, the smaller id first.
  void insert(VertexId v, VertexId near, std::vector<std::array<VertexId, 2>>& lost);

  /// Takes tetrahedra away. The hole must be filled by `add` at once.
  void remove(std::span<const Index> tetrahedra);
  Index add(const Corners& corners);
  /// Makes two faces with the same corners neighbours; `g` may be on the box.
  void join(Face f, Face g);

 private:
  PointTable& points_;
  VertexId first_corner_;
  std::vector<Corners> corners_;
  std::vector<std::array<Index, 4>> neighbours_;
  std::vector<Index> free_;
  std::vector<Index> at_;                    // by vertex: a tetrahedron that has it, or kNone
  mutable std::vector<std::uint32_t> seen_;  // by tetrahedron: the last round that met it
  mutable std::uint32_t round_ = 0;

  void make_box();
  Index locate(VertexId v, Index start) const;
  bool meet(Index t) const;
};

}  // namespace cnrg
