// The algebra of CGAL's Nef polyhedra on sets of any kind, open or unbounded, corrected where CGAL 5.5.1 errs.
//
// CGAL takes the first volume for the unbounded one and reads its mark off a vertex. Both can be wrong after an
// operation; here the mark follows from those of the operands.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_S2/SM_const_decorator.h>
#include <CGAL/Nef_S2/SM_point_locator.h>
#include <CGAL/Nef_polyhedron_3.h>

#include <stdexcept>

namespace cnrg::bench::nef {

using Set = CGAL::Nef_polyhedron_3<CGAL::Exact_predicates_exact_constructions_kernel>;

/// The structure that CGAL made is none.
class BrokenSet : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Makes nothing; `delegate` with it makes facets and volumes anew.
class Nothing : public CGAL::Modifier_base<Set::SNC_structure> {
 public:
  void operator()(Set::SNC_structure&) override {}
};

/// True if the first volume is the one around the lexicographically smallest vertex, on its side of smaller x.
inline bool first_volume_is_unbounded(const Set& set) {
  using Map = Set::SNC_structure::Sphere_map;
  if (set.number_of_vertices() == 0) return true;
  auto smallest = set.vertices_begin();
  for (auto v = set.vertices_begin(); v != set.vertices_end(); ++v)
    if (CGAL::lexicographically_xyz_smaller(v->point(), smallest->point())) smallest = v;
  const Map* map = &*smallest;
  CGAL::SM_point_locator<CGAL::SM_const_decorator<Map>> locator(const_cast<Map*>(map));
  Set::SFace_const_handle face;
  if (!CGAL::assign(face, locator.locate(Map::Sphere_point(-1, 0, 0)))) throw BrokenSet("no volume outside");
  return face->volume() == set.volumes_begin();
}

/// When simplification merges the unbounded volume with others, CGAL 5.5.1 may keep one of them in its place;
/// facets and volumes are then made anew.
inline Set settled(Set set) {
  if (first_volume_is_unbounded(set)) return set;
  Nothing nothing;
  set.delegate(nothing, true, false);
  if (!first_volume_is_unbounded(set)) throw BrokenSet("the unbounded volume is not the first");
  return set;
}

inline bool unbounded_mark(const Set& set) { return set.volumes_begin()->mark(); }

/// A result of a binary operation, whose unbounded volume has this mark. CGAL reads the mark off a vertex, and
/// there may be none.
inline Set with_unbounded(Set result, bool mark) {
  Set set = settled(std::move(result));
  if (unbounded_mark(set) == mark) return set;
  if (set.number_of_vertices() > 0) throw BrokenSet("the mark of the unbounded volume is wrong");
  return Set(mark ? Set::COMPLETE : Set::EMPTY);
}

inline Set united(const Set& a, const Set& b) {
  return with_unbounded(a + b, unbounded_mark(a) || unbounded_mark(b));
}

inline Set common(const Set& a, const Set& b) {
  return with_unbounded(a * b, unbounded_mark(a) && unbounded_mark(b));
}

/// As an intersection: where an edge meets a facet, the difference of CGAL 5.5.1 takes the marks of edge and
/// facet in this order, whichever is of `a` (create_edge_facet_overlay): that is wrong for open sets.
inline Set without(const Set& a, const Set& b) { return common(a, b.complement()); }

/// cl(a - b) of closed sets, where all marks are equal.
inline Set closed_difference(const Set& a, const Set& b) {
  return settled(with_unbounded(a - b, unbounded_mark(a) && !unbounded_mark(b)).closure());
}

/// As CGAL decides it, but for what its symmetric difference gets wrong: with space it is empty to CGAL 5.5.1, and
/// so is one without a vertex that reaches everywhere, such as that of a set and its complement.
inline bool are_equal(const Set& a, const Set& b) {
  if (a.is_space() || b.is_space()) return a.is_space() == b.is_space();
  return unbounded_mark(a) == unbounded_mark(b) && a == b;
}

}  // namespace cnrg::bench::nef
