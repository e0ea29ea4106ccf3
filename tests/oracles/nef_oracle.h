// The point-set oracle: CGAL's Nef polyhedra behind a header without CGAL.
//
// It shares no code and no decision with the kernel: leaves come from their own solids, sheets, wires and points
// (tests/scenes/scene.h), set operations are Nef's, all numbers are exact. csg/SEMANTICS.md#identities says what
// must be equal.
#pragma once

#include <memory>
#include <stdexcept>
#include <vector>

#include "tests/oracles/skeleton.h"
#include "tests/scenes/scene.h"

namespace cnrg::properties {

/// Nef itself failed (an assertion of CGAL): nothing is known of the set.
class OracleFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class NefSet {
 public:
  NefSet();  ///< the empty set
  ~NefSet();
  NefSet(const NefSet&);
  NefSet& operator=(const NefSet&);

  /// The closed solid inside a closed 2-manifold of simple planar facets, outward.
  static NefSet solid(const scenes::Solid& facets);
  /// A closed planar polygon; points of it lie inside of an odd number of the loops, and its boundary.
  /// A loop may touch itself in vertices or run along an edge twice (a slit).
  static NefSet polygon(const std::vector<scenes::Polygon>& loops);
  static NefSet segment(const RationalPoint& a, const RationalPoint& b);
  static NefSet point(const RationalPoint& p);
  /// |leaf|.
  static NefSet leaf(const scenes::Leaf& leaf);
  /// The union of many sets.
  static NefSet unite_all(std::vector<NefSet> sets);

  NefSet unite(const NefSet& other) const;
  NefSet intersect(const NefSet& other) const;
  NefSet subtract(const NefSet& other) const;  ///< cl(this - other) of closed sets
  NefSet without(const NefSet& other) const;   ///< this - other, which need not be closed
  NefSet complement() const;                   ///< space - this; the outer volume is marked like others
  NefSet interior() const;
  NefSet closure() const;
  NefSet boundary() const;
  NefSet regularization() const;  ///< cl int
  /// This and the bounded volumes of its complement that hold one of the points; the points lie on no facet.
  NefSet fill(const std::vector<RationalPoint>& inside) const;

  bool contains(const RationalPoint& p) const;
  bool operator==(const NefSet& other) const;  ///< as Nef decides it: the symmetric difference is empty
  bool valid() const;
  Skeleton skeleton() const;
  /// The mark of the unbounded volume.
  bool unbounded() const;
  /// Exact volume of the marked bounded 3-cells.
  Rational volume() const;

 private:
  struct Data;
  template <class Make>
  static NefSet of(const Make& make);
  std::shared_ptr<const Data> data_;
};

}  // namespace cnrg::properties
