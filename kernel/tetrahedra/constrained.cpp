#include "kernel/tetrahedra/constrained.h"

#include <algorithm>

#include "kernel/base/sorted.h"
#include "kernel/tetrahedra/recovery.h"
#include "kernel/tetrahedra/steiner_points.h"

namespace cnrg {

namespace {

using Ends = std::array<VertexId, 2>;
using Triangle = std::array<VertexId, 3>;

Ends ends(VertexId a, VertexId b) { return {std::min(a, b), std::max(a, b)}; }

/// The sides of a facet that bind, each with the facet on its left.
std::vector<Ends> border_of(const std::vector<Triangle>& facet, const std::vector<Ends>& segments) {
  std::vector<Ends> sides, out;
  for (const Triangle& t : facet) {
    for (std::size_t k = 0; k < 3; ++k) sides.push_back({t[k], t[(k + 1) % 3]});
  }
  std::sort(sides.begin(), sides.end());
  for (const auto& [a, b] : sides) {
    const bool inner = std::binary_search(sides.begin(), sides.end(), Ends{b, a});
    if (!inner || std::binary_search(segments.begin(), segments.end(), ends(a, b))) out.push_back({a, b});
  }
  return out;
}

}  // namespace

ConstrainedTetrahedra constrained_tetrahedra(PointTable& points, const Constraints& constraints,
                                             const Watch& watch, NewPoints how) {
  const auto& [segments, facets] = constraints;
  std::vector<Ends> bound;
  bound.reserve(segments.size());
  for (const auto& [a, b] : segments) bound.push_back(ends(a, b));
  sort_unique(bound);
  std::vector<std::vector<Ends>> borders;
  borders.reserve(facets.size());
  for (const auto& facet : facets) borders.push_back(border_of(facet, bound));
  for (const auto& border : borders) {
    for (const auto& [a, b] : border) bound.push_back(ends(a, b));
  }
  sort_unique(bound);

  Tetrahedra tetrahedra(points, watch);
  Recovery recovery(points, tetrahedra, bound, facets, borders);
  recovery.run(watch);
  ConstrainedTetrahedra out;
  for (ConstrainedTetrahedra::Index i = 0; i < segments.size(); ++i) {
    for (const Ends& piece : recovery.pieces(segments[i][0], segments[i][1])) out.segments.push_back({piece, i});
  }
  for (ConstrainedTetrahedra::Index i = 0; i < facets.size(); ++i) {
    for (const Triangle& corners : recovery.faces(i)) out.triangles.push_back({corners, i});
  }
  SteinerPoints added(points, tetrahedra, out, recovery.pieces(), recovery.all_new(),
                      [&](VertexId v) { return recovery.ways(v); });
  added.reduce(watch);
  if (how == NewPoints::doubles) added.move_to_doubles(watch);
  for (Tetrahedra::Index t = 0; t < tetrahedra.size(); ++t) {
    if (tetrahedra.alive(t)) out.tetrahedra.push_back(tetrahedra.corners(t));
  }
  return out;
}

}  // namespace cnrg
