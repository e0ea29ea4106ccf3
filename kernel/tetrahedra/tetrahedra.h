// Tetrahedra that fill a box, each with its four neighbours.
//
// The box is a part of the mesh: eight corners of its own, far enough outside of all points, so that there is no
// border to treat in another way. Points are put in one by one; after each the tetrahedra are Delaunay: no point
// is inside of the sphere around one of them. Points that lie on one sphere are parted by perturbation
// (kernel/exact/in_sphere.h), so the order in which points come does not matter, and no tetrahedron is flat.
//
// What changes the mesh later takes some tetrahedra away and fills the hole: by a point that sees all its walls
// and is joined with them, which puts a point on a face or an edge, and takes one away; or by other tetrahedra of
// the same points.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernel/base/progress.h"
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
  /// that are added to it. Throws Stopped.
  explicit Tetrahedra(PointTable& points, const Watch& watch = {});

  std::size_t size() const { return corners_.size(); }
  /// Numbers of tetrahedra that are no more are used again; until then they are not alive.
  bool alive(Index t) const { return corners_[t][0].valid(); }
  const Corners& corners(Index t) const { return corners_[t]; }
  Index neighbour(Index t, int k) const { return neighbours_[t][static_cast<std::size_t>(k)]; }
  std::array<VertexId, 3> face(Face f) const;
  /// The place of a vertex among the corners of a tetrahedron, 4 if it is none of them.
  int place(Index t, VertexId v) const {
    return static_cast<int>(std::find(corners_[t].begin(), corners_[t].end(), v) - corners_[t].begin());
  }

  /// The tetrahedra at a vertex, or at an edge.
  void around(VertexId v, std::vector<Index>& out) const;
  void around(VertexId a, VertexId b, std::vector<Index>& out) const;

  /// Is a point of the table in front of all walls of a hole, but those that it is a corner of? A hole is some
  /// tetrahedra whose walls are a sphere.
  bool sees(VertexId v, std::span<const Index> hole) const;
  /// Fills the hole by tetrahedra of that point and each of these walls.
  void fill(VertexId v, std::span<const Index> hole);
  /// Takes tetrahedra away and puts others, positive ones of the same vertices, into the hole.
  void replace(std::span<const Index> hole, std::span<const Corners> fresh);
  /// Puts another point of the table in the place of a vertex, of which it must see the star.
  void rename(VertexId vertex, VertexId by);

 private:
  PointTable& points_;
  VertexId first_corner_;
  std::vector<Corners> corners_;
  std::vector<std::array<Index, 4>> neighbours_;
  std::vector<Index> free_;
  std::vector<Index> at_;                    // by vertex: a tetrahedron that has it, or kNone
  mutable std::vector<std::uint32_t> seen_;  // by tetrahedron: the last round that met it
  mutable std::uint32_t round_ = 0;
  mutable std::array<std::vector<Index>, 2> ways_;

  void make_box();
  void insert(VertexId v, VertexId near);
  Index locate(VertexId v, Index start) const;
  Face opposite(Face f) const;
  void mark(std::span<const Index> hole) const;
  Index add(const Corners& corners);
  void remove(std::span<const Index> hole);
  void join(Face f, Face g);
  template <class Key>
  void join_pairs(std::vector<std::pair<Key, Face>>& faces);
  bool meet(Index t) const;
};

}  // namespace cnrg
