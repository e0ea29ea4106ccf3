// Betti numbers of any union of open cells: open, closed, neither, of mixed dimension, unbounded.
//
// b0, b1, b2 count connected pieces, independent loops and enclosed cavities of the point set |S| (its singular
// homology; higher ones vanish in space). They are read off incidence, without elimination; see homology.cpp.
//
// Z/2 and Q agree. |S| is homotopy equivalent to a compact polyhedron K in the 3-sphere (what remains when small
// open neighbourhoods of the missing cells are cut away), and by Alexander duality the reduced H_i(K) is
// isomorphic to the reduced cohomology H^(2-i) of the complement, for i = 1 and 2 to H^1 and H^0. These have no
// torsion for any space (universal coefficients), nor has H_0. So the ranks do not depend on the field
// (hatcher2002 3.44, 3.45). Both are returned all the same: people ask for one or the other.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "kernel/selection/neighbourhood.h"
#include "kernel/selection/selection.h"

namespace cnrg {

/// The rings of a face: loops but one, and vertices isolated in it.
inline std::int64_t ring_count(const Complex& complex, FaceId f) {
  return static_cast<std::int64_t>(complex.face_loops[f].size() - 1 + complex.face_vertices[f].size());
}

/// Ranks of the homology groups of a point set: b0, b1, b2.
struct BettiNumbers {
  std::array<std::int64_t, 3> z2{}, q{};
  /// b0 - b1 + b2, the Euler characteristic of the homotopy type.
  std::int64_t euler() const { return z2[0] - z2[1] + z2[2]; }
  friend bool operator==(const BettiNumbers&, const BettiNumbers&) = default;
};

/// Counts set after set; not for several threads at once.
class BettiCounter {
 public:
  explicit BettiCounter(Neighbourhoods& neighbourhoods);
  ~BettiCounter();
  /// The Betti numbers of |S|. Cells on the frame are never in a set, so what reaches the frame counts as it would
  /// without one. The cost is that of the closure and the stars of the set's cells. The empty set has zeros.
  BettiNumbers of(const CellSet& set);

 private:
  Neighbourhoods& neighbourhoods_;
  struct Members;
  std::unique_ptr<Members> members_;
};

/// The Betti numbers of one set.
BettiNumbers betti_numbers(const Complex& complex, const CellSet& set);

/// The Betti numbers of the whole point set, then those of each of `components` (ascending), which are all that
/// the selection has.
std::vector<BettiNumbers> betti_numbers(const Selection& selection, const std::vector<Component>& components,
                                        BettiCounter& counter);

/// The Euler characteristics of the surfaces just inside of each of some regions (ascending): closed surfaces, one
/// per piece of the region's boundary. A region is a ball with handles and cavities: the sum over its surfaces of
/// 2 - 2 handles. The sphere at infinity of R0 is not among them.
std::vector<std::int64_t> inner_surfaces(const Complex& complex, const std::vector<RegionId>& regions,
                                         Neighbourhoods& neighbourhoods);

}  // namespace cnrg
