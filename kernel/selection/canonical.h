// An order of the cells of a simplified complex by coordinates: it depends on the result alone, not on the ids of
// the refinement, so that `f12` is the same face in every file, in `locate` and in `explain`.
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/selection/simplify.h"

namespace cnrg {

/// The points of a simplified complex in lexicographic order. A point inside of a straight chain that is no vertex
/// and touches flat faces only is left out: another refinement would not have it.
class CanonicalPoints {
 public:
  CanonicalPoints(const Complex& complex, const SimplifiedComplex& simplified);
  const std::vector<VertexId>& points() const { return points_; }
  /// The place among `points()`; kNone for one that is left out or not used.
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::uint32_t number(VertexId v) const { return number_[v]; }

 private:
  std::vector<VertexId> points_;
  IdVector<VertexId, std::uint32_t> number_;
};

/// All cells of a face lie in one plane.
bool is_flat(const Complex& complex, const SimplifiedComplex::Face& face);
/// From end to end; a closed chain does not repeat the first.
std::vector<VertexId> chain_vertices(const Complex& complex, const SimplifiedComplex::Edge& edge);

/// The loops of a facet without the slits that simplification removed. A walk passes a slit in both directions;
/// slits nest like parentheses, and each closed part between them is a walk of its own.
std::vector<std::vector<VertexId>> facet_walks(const Complex& complex, const SimplifiedComplex& simplified,
                                               FaceId f);

/// Orders vertices by coordinates; edges by their points; faces by those of their boundaries, then of their
/// facets; regions by their faces, then bounded before unbounded ones. Maps, shells and sides follow. Returns the
/// points of that order.
CanonicalPoints put_in_order(const Complex& complex, SimplifiedComplex& simplified);

}  // namespace cnrg
