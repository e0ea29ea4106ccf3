// Segments as chains of edges, facets as unions of faces.
//
// New points that make segments Delaunay are in the way of each other where segments run side by side or nearly
// cross, and may be more than anybody can store. Here what is in the way is flipped away, for all segments before
// any gets a point: points of one are in the way of the next. What is left gets points where a segment passes
// through a face, and an edge through a facet. That always ends: each flip makes these places fewer, what is cut
// is cut once, and the cut of two things is a point of one of them only. Most of these points are not needed once
// all is in its place; those that can be pulled along their segment or facet into a vertex next to them are taken
// away at once, so that few of them meet what comes later.
#pragma once

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "kernel/base/progress.h"
#include "kernel/refine/box_tree.h"
#include "kernel/tetrahedra/constrained.h"
#include "kernel/tetrahedra/flips.h"
#include "kernel/tetrahedra/room.h"
#include "kernel/tetrahedra/tetrahedra.h"

namespace cnrg {

// A facet as a union of faces.

/// A facet among tetrahedra of which its border is made of edges: which edges pass through it, and once there are
/// none, which faces it is made of.
class Wall {
 public:
  using Index = Tetrahedra::Index;
  using Triangle = std::array<VertexId, 3>;
  using Ends = std::array<VertexId, 2>;

  /// `facet`: triangles of one plane, turned alike, that overlap nowhere. `border`: its sides, each with the facet
  /// on its left; they must be edges. `inside`: vertices inside of it.
  Wall(const PointTable& points, const Tetrahedra& tetrahedra, std::span<const Triangle> facet,
       std::vector<Ends> border, std::span<const VertexId> inside);

  /// The faces that are in it, turned as the facet.
  std::vector<Triangle> faces() const;
  /// The edges that pass through it, each from below the facet to above, ascending.
  std::vector<Ends> edges_through();
  /// Does an edge pass through it?
  bool is_crossed(VertexId a, VertexId b);

 private:
  const PointTable& points_;
  const Tetrahedra& tetrahedra_;
  std::span<const Triangle> facet_;
  std::vector<Ends> border_;       // sorted
  std::vector<VertexId> corners_;  // of facet and border, and inside; sorted
  std::optional<BoxTree> boxes_;   // of triangles, where they are many
  mutable std::unordered_map<VertexId, int> side_;

  int side(VertexId v) const;
  std::vector<Triangle> within_border(const std::vector<Triangle>& faces) const;
  bool pierced(Index t);
};

class Recovery {
 public:
  using Index = Tetrahedra::Index;
  using Ends = std::array<VertexId, 2>;

  /// `borders`: of each facet the sides that bind, with the facet on the left; `segments` has all of them, the
  /// smaller id first, ascending.
  Recovery(PointTable& points, Tetrahedra& tetrahedra, std::span<const Ends> segments,
           std::span<const std::vector<std::array<VertexId, 3>>> facets,
           std::span<const std::vector<Ends>> borders);

  /// Throws Stopped.
  void run(const Watch& watch);

  /// After `run`: the faces of a facet.
  std::vector<std::array<VertexId, 3>> faces(Index facet) const;

  /// After `run`: the edges of a segment from a to b, and those of all segments.
  std::vector<Ends> pieces(VertexId a, VertexId b) const;
  std::vector<Ends> pieces() const;
  /// After `run`: the new points that are left, and the directions in which each may move on its segment or facet.
  std::vector<VertexId> all_new() const;
  std::vector<RationalPoint> ways(VertexId v) const { return ways(new_.at(v)); }

 private:
  /// What a new point is inside of.
  enum class On { segment, facet };
  struct Carrier {
    On on;
    Index of;
  };
  /// The face of a star that a way from its middle passes through next, or an edge of it.
  struct Obstacle {
    Tetrahedra::Face face;  // with the middle of the star in front
    std::array<VertexId, 3> corners;
    bool edge;  // of the first two
  };
  PointTable& points_;
  Tetrahedra& tetrahedra_;
  std::span<const Ends> segments_;
  std::span<const std::vector<std::array<VertexId, 3>>> facets_;
  std::span<const std::vector<Ends>> borders_;
  std::vector<std::vector<VertexId>> chains_;  // of segments
  std::vector<std::vector<VertexId>> inside_;  // of facets
  std::unordered_map<VertexId, Carrier> new_;
  std::vector<Index> star_, hole_;
  std::vector<VertexId> near_;
  Flips flips_;
  Room room_;

  enum class Cuts { none, some };
  std::vector<Index> short_first() const;
  bool put_in_segment(Index i, Cuts cuts);
  Obstacle ahead(VertexId from, VertexId to);
  bool flip(const Ends& way);
  bool crosses(const Ends& way, std::span<const VertexId> face) const;
  bool is_piece(VertexId a, VertexId b) const;
  void cut_facet(Index i);
  std::vector<VertexId> chain(VertexId a, VertexId b) const;
  Wall wall(Index facet) const;
  std::size_t needed(Index facet) const;
  VertexId put_on_segment(Index i, const Rational& place);
  VertexId put_on_facet(Index i, const RationalPoint& place);
  template <class At>
  VertexId put(const At& at, const Carrier& carrier);
  bool take_away(VertexId v);
  void take_away_all(std::vector<VertexId> from);
  void neighbours_on_carrier(VertexId v, const Carrier& carrier);
  std::vector<RationalPoint> ways(const Carrier& carrier) const;
  std::vector<VertexId>& points_on(const Carrier& carrier);
  std::size_t spread(const Watch& watch);
};

}  // namespace cnrg
