// Local moves that change tetrahedra and keep what they conform to.
//
// Each move looks what would be there after it, and is made only if all of that is turned right, by exact signs,
// and its worst shape passes a bar. So whatever the order of moves, the mesh is valid after each; nothing has to
// be undone. Points of the input never move and never go.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "kernel/tetrahedra/stars.h"

namespace cnrg {

class Moves {
 public:
  using Index = Stars::Index;
  using Point = Stars::Point;

  /// Vertices below `fixed` stay. With `keep_boundary` so do all faces of facets and all segments.
  Moves(Stars& mesh, Index fixed, bool keep_boundary) : mesh_(mesh), fixed_(fixed), keep_(keep_boundary) {}

  /// Takes an edge away: the tetrahedra around it are replaced by those over the best triangulation of the ring
  /// (klincsek1980; freitag1997). An edge inside of a facet is replaced by the other diagonal.
  /// True if that made the worst shape better. `longest`: all new edges are shorter (squared length).
  bool remove_edge(Index a, Index b, double longest = std::numeric_limits<double>::infinity());
  /// Two tetrahedra at a face become three around a new edge, if that makes the worst shape better.
  bool swap_face(Index t, int k);
  /// Pulls `a` into `b`. All shapes must be above `enough` or above the worst that there was.
  /// `longest`: no new edge is longer (squared length).
  bool collapse(Index a, Index b, double enough, double longest);
  /// A new vertex on an edge, after that part of the way from a to b; its number, or kNoTetrahedron where
  /// something would turn.
  Index split(Index a, Index b, double part = 0.5);
  /// Moves a vertex so that the worst shape around it, to the third power, gets more than `gain` times as good.
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
  Stars::Ring ring_;
  std::vector<Index> old_, at_edge_;
  std::vector<Stars::Tetrahedron> fresh_;

  bool fill_arc(Index a, Index b, std::size_t from, std::size_t count, bool closing, std::int32_t facet,
                double bar, double longest);
  bool peel(Index t, Index a, Index b, std::int32_t facet);
  bool keeps_facets(Index a, Index b) const;
  bool turned_like(std::int32_t facet, Index before, Index after, Index p, Index q) const;
  bool try_place(Index v, const Point& p, double gain, double& worst);
  bool project(Index v, Point& p) const;
};

}  // namespace cnrg
