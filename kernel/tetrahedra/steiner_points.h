// Points that constrained tetrahedra have on segments and facets beside those of the input (Steiner points): fewer
// of them, and in doubles.
//
// Most are only there because of what else was in the mesh when they came. One that can be pulled along its
// segment or facet into the next vertex is gone; flips put those tetrahedra away that would be turned by that.
//
// The others cannot all be rounded: one may pass through a face that nearly touches it, and where facets are one
// plane but for the last digits, there is no double on the right side of all of them. Then, too, other tetrahedra
// do: those that would be turned are flipped away.
#pragma once

#include <functional>
#include <set>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "kernel/base/progress.h"
#include "kernel/tetrahedra/constrained.h"
#include "kernel/tetrahedra/flips.h"
#include "kernel/tetrahedra/room.h"

namespace cnrg {

class SteinerPoints {
 public:
  /// The directions in which a new point may move on what it is inside of.
  using Ways = std::function<std::vector<RationalPoint>(VertexId)>;

  /// `made`: the segments and triangles among the tetrahedra, which stay and follow the points. `pieces`: the
  /// edges that bind, those of segments and of the borders of facets. `open`: the points.
  SteinerPoints(PointTable& points, Tetrahedra& tetrahedra, ConstrainedTetrahedra& made,
                std::span<const std::array<VertexId, 2>> pieces, std::vector<VertexId> open, Ways ways);

  /// Pulls away what can go. Throws Stopped.
  void reduce(const Watch& watch);
  /// Moves what is left; segments and facets are bent by what doubles cannot tell. Throws NearFault, Stopped.
  void move_to_doubles(const Watch& watch);

 private:
  using Index = Tetrahedra::Index;

  PointTable& points_;
  Tetrahedra& tetrahedra_;
  ConstrainedTetrahedra& made_;
  std::vector<VertexId> open_;
  Ways ways_;
  Flips flips_;
  Room room_;
  std::vector<Index> star_;
  std::unordered_map<VertexId, VertexId> moved_;   // to which double a vertex of `made`, or into which other one
  std::unordered_map<VertexId, VertexId> origin_;  // of doubles: the vertex of `made` that has moved there
  // The constraints, by vertices of `made`; also those of points that were pulled away.
  std::unordered_set<std::uint64_t> edges_, sides_;  // pieces; these and sides of faces
  std::set<std::array<VertexId, 3>> faces_;

  bool some(bool (SteinerPoints::*way)(VertexId), const Watch& watch);
  bool is_bound(std::span<const VertexId> corners) const;
  bool may_go(VertexId a, VertexId b) const;
  void bind(VertexId a, VertexId b);
  void bind(std::array<VertexId, 3> face);
  VertexId first(VertexId v) const;
  void move(VertexId v, VertexId w);
  bool move_near(VertexId v);
  bool move_far(VertexId v);
  bool move_by_flips(VertexId v);
  template <Flips::Deep deep>
  bool pull(VertexId v);
  std::vector<VertexId> neighbours_on_carrier(VertexId v);
  bool make_room(VertexId v, VertexId w, Flips::Deep deep);
  void follow();
};

}  // namespace cnrg
