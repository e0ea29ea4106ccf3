// An order of the cells of a simplified complex by coordinates: it depends on the result alone, not on the ids of
// the refinement, so that `f12` is the same face in every file, in `locate` and in `explain`.
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/selection/simplify.h"

namespace cnrg {

/// The points of a simplified complex in lexicographic order. A point inside of a straight chain, or of a straight
/// edge between two facets, that is no vertex and in which no other facets meet is left out: another refinement
/// would not have it.
class CanonicalPoints {
 public:
  /// `axes`: in whose order; nullptr: x, y, z.
  CanonicalPoints(const Complex& complex, const SimplifiedComplex& simplified, const LeafAxes* axes = nullptr);
  /// Those of SimplifiedComplex::points.
  CanonicalPoints(const Complex& complex, std::vector<VertexId> points);
  const std::vector<VertexId>& points() const { return points_; }
  /// The place among `points()`; kNone for one that is left out or not used.
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::uint32_t number(VertexId v) const { return number_[v]; }

 private:
  void number();
  std::vector<VertexId> points_;
  IdVector<VertexId, std::uint32_t> number_;
};

/// All cells of a face lie in one plane.
bool is_flat(const Complex& complex, const SimplifiedComplex::Face& face);
/// From end to end; a closed chain does not repeat the first.
std::vector<VertexId> chain_vertices(const Complex& complex, const SimplifiedComplex::Edge& edge);

/// A planar piece of a simplified face: cells of the complex that meet within the face and are pieces of one facet
/// of a leaf. So it does not tell what has cut it.
struct SimplifiedFacet {
  ShortList<HalfFace, 2> cells;  ///< each by the front of the face
  std::vector<std::vector<HalfEdge>>
      walks;                       ///< around it, the facet to the left; an edge of the face within it twice
  std::vector<VertexId> isolated;  ///< vertices of the result in its interior
};
std::vector<SimplifiedFacet> facets_of(const Complex& complex, const SimplifiedComplex& simplified,
                                       std::uint32_t face);

/// Orders vertices by coordinates; edges by their points; faces by those of their boundaries, then of their
/// facets; regions by their faces, then bounded before unbounded ones. Maps, shells and sides follow. Returns the
/// points of that order.
/// `axes`: of what was moved, as above.
CanonicalPoints put_in_order(const Complex& complex, SimplifiedComplex& simplified,
                             const LeafAxes* axes = nullptr);

}  // namespace cnrg
