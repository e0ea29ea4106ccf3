// Local moves that change tetrahedra and keep what they conform to.
//
// Each move looks what would be there after it, and is made only if all of that is turned right, by exact signs,
// and better than before. So whatever the order of moves, the mesh is valid after each. Points of the input never
// move and never go.
//
// Better is at first what has a better worst shape. That leads out of all that is far from good, but it stops
// where one bad tetrahedron could go if its neighbour became a little worse, and takes three bad ones for one that
// was worse. So in the end better is what costs less (bounds.h), each bad one for itself.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "kernel/tetrahedra/bounds.h"
#include "kernel/tetrahedra/stars.h"

namespace cnrg {

class Moves {
 public:
  using Index = Stars::Index;
  using Point = Stars::Point;

  /// Vertices below `fixed` stay. With `keep_boundary` so do all faces of facets and all segments.
  Moves(Stars& mesh, Index fixed, bool keep_boundary) : mesh_(mesh), fixed_(fixed), keep_(keep_boundary) {}

  /// From now on the costs by these bounds count, not the worst shape.
  void aim_at(const Bounds& bounds) { aim_ = bounds; }

  /// Takes an edge away: the tetrahedra around it are replaced by those over the best triangulation of the ring
  /// (klincsek1980; freitag1997). An edge inside of a facet is replaced by the other diagonal.
  /// True if that is better. `longest`: all new edges are shorter (squared length).
  bool remove_edge(Index a, Index b, double longest = std::numeric_limits<double>::infinity());
  /// Two tetrahedra at a face become three around a new edge, if that is better.
  bool swap_face(Index t, int k);
  /// Pulls `a` into `b`. All shapes must be above `enough` or above the worst that there was, or all cost less.
  /// `longest`: no new edge is longer (squared length).
  bool collapse(Index a, Index b, double enough, double longest);
  /// A new vertex in the middle of an edge; its number, or kNoTetrahedron where something would turn.
  Index split(Index a, Index b);
  /// A new vertex on an edge, moved to where that is better than before; false, and nothing is done, if there is
  /// no such place. Where costs count.
  bool divide(Index a, Index b);
  /// Moves a vertex so that the worst shape around it, to the third power, gets more than `gain` times as good, or
  /// all costs less.
  bool smooth(Index v, double gain);

  /// What the last move but `smooth` put in the place of what it took away.
  std::span<const Stars::Tetrahedron> made() const { return fresh_; }
  /// The worst shape of some tetrahedra.
  double worst(std::span<const Index> tetrahedra) const;
  double squared(Index a, Index b) const;
  bool may_go(Index a, Index b) const;
  /// The tetrahedra at an edge.
  const std::vector<Index>& at_edge(Index a, Index b);

 private:
  Stars& mesh_;
  const Index fixed_;
  const bool keep_;
  std::optional<Bounds> aim_;
  Stars::Ring ring_;
  std::vector<Index> old_, at_edge_;
  std::vector<Stars::Tetrahedron> fresh_;

  bool fill_arc(Index a, Index b, std::size_t from, std::size_t count, bool closing, std::int32_t facet,
                double bar, double longest);
  bool peel(Index t, Index a, Index b, std::int32_t facet);
  bool turned_like(std::int32_t facet, const Point& before, const Point& after, Index p, Index q) const;
  /// What moves make larger: the worst shape, or less costs.
  double value(const Stars::Tetrahedron& t) const { return aim_ ? -aim_->cost(mesh_, t) : t.shape; }
  double both(double a, double b) const { return aim_ ? a + b : std::min(a, b); }
  double nothing() const { return aim_ ? 0 : std::numeric_limits<double>::infinity(); }
  double value(std::span<const Index> tetrahedra) const;
  double value(const std::array<Index, 4>& corners, std::int32_t region, double bar) const;
  bool costs_less() const;
  Point way_to_better(Index v, Index bad) const;
  bool pull(Index v, Index bad, double room, double gain, double& now);
  bool try_place(Index v, const Point& p, double gain, double& now);
  bool project(Index v, Point& p) const;
};

}  // namespace cnrg
