// A new vertex where a bad tetrahedron has room for one: in the middle of the sphere around it.
//
// That is as far from the other vertices as a place there can be, so one vertex does for a whole fan of thin
// tetrahedra, of which each would have to be halved by itself. All around whose corners there is a sphere with the
// new vertex inside go (bowyer1981), as far as no facet is between; if one is, the vertex goes on the facet, in
// the middle of the circle around its triangle. Then those stay that would give way to what is
// turned wrong or is no better than the bad one (klingner2007), and if too few are left there is no new vertex. So
// the worst shape gets better with each, whatever angles the input has.
#pragma once

#include <vector>

#include "kernel/tetrahedra/stars.h"

namespace cnrg {

class Insertion {
 public:
  using Index = Stars::Index;
  using Point = Stars::Point;

  /// Vertices below `fixed` stay. With `keep_boundary` none comes on a facet.
  Insertion(Stars& mesh, Index fixed, bool keep_boundary) : mesh_(mesh), fixed_(fixed), keep_(keep_boundary) {}

  /// The new vertex, or kNoTetrahedron. All that it is a corner of has a shape, to the third power, of more than
  /// `gain` times that of the tetrahedron.
  Index insert(Index t, double gain);
  /// A line at the border of a facet that was between, and the corner over it of the facet's triangle there, if
  /// there is no new vertex for that reason; else three equal ones.
  std::array<Index, 3> in_the_way() const { return in_the_way_; }

 private:
  Stars& mesh_;
  const Index fixed_;
  const bool keep_;
  std::array<Index, 3> in_the_way_{0, 0, 0};
  std::vector<Index> hole_, way_;
  std::vector<std::uint32_t> mark_;  // by tetrahedron: `round_` of those of the hole
  std::uint32_t round_ = 0;
  std::vector<Stars::Tetrahedron> fresh_;
  std::vector<std::array<Index, 2>> sides_;  // of the walls, or of triangles of the facet

  struct Place {
    Index tetrahedron;
    Point at;
    std::int32_t facet = Stars::kNone;
  };
  bool find(Index t, Place& place);
  bool find_on_facet(Index t, int k, Place& place);
  void grow(const Place& place);
  bool fit(Index v, const Place& place, Index t, double bar);
  bool keep_sides(const Place& place, Index t, bool& changed);
  bool set_facets(Index v, std::int32_t facet);
  bool in_hole(Index t) const { return mark_[t] == round_; }
  bool take_out(const Place& place, Index t, Index h);
  bool between(std::int32_t facet, const Place& place) const {
    return facet != Stars::kNone && facet != place.facet;
  }
};

}  // namespace cnrg
