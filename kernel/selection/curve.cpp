// What lies along an edge is listed as patches and wire curves; edges of one curve have equal lists. Whether a
// patch is curved at the vertex shows in its facets around both edges: they lie in more than one sheet.
#include "kernel/selection/curve.h"

#include <algorithm>
#include <tuple>

#include "kernel/base/sorted.h"
#include "kernel/exact/predicates.h"

namespace cnrg {
namespace {

// What lies at an edge: (is a wire curve, leaf, number of the patch or curve).
using Surface = std::tuple<bool, LeafId, std::uint32_t>;

VertexId other_end(const Complex& complex, EdgeId e, VertexId v) {
  const auto& ends = complex.edge_ends[e];
  return ends[0] == v ? ends[1] : ends[0];
}

bool counts(LeavesThere leaves, LeafId leaf) {
  return !leaves || std::binary_search(leaves->begin(), leaves->end(), leaf);
}

void collect(const Complex& complex, EdgeId e, LeavesThere leaves, std::vector<Surface>& surfaces,
             std::vector<std::pair<Surface, SheetId>>& facets) {
  for (const FaceUse& use : complex.edge_uses[e]) {
    for (const Cover& c : complex.cover(use.face)) {
      const Soup::Face& source = complex.sources[c.source];
      if (!counts(leaves, source.leaf)) continue;
      surfaces.emplace_back(false, source.leaf, source.patch);
      facets.emplace_back(surfaces.back(), complex.face_sheet[use.face]);
    }
  }
  for (SegmentId s : complex.edge_segments[e]) {
    for (WireId w : complex.segment_wires[s]) {
      const Soup::Wire& wire = complex.wires[w];
      if (counts(leaves, wire.leaf)) surfaces.emplace_back(true, wire.leaf, wire.leaf_edge);
    }
  }
  sort_unique(surfaces);
}

bool turns_less_than_right_angle(const Complex& complex, VertexId v, EdgeId a, EdgeId b) {
  const RationalPoint p = complex.points.rational(other_end(complex, a, v));
  const RationalPoint q = complex.points.rational(v);
  const RationalPoint r = complex.points.rational(other_end(complex, b, v));
  Rational dot = 0;
  for (int k = 0; k < 3; ++k) dot += Rational(q[k] - p[k]) * Rational(r[k] - q[k]);
  return sgn(dot) > 0;
}

}  // namespace

bool straight(const Complex& complex, VertexId v, EdgeId a, EdgeId b) {
  return collinear(complex.points, other_end(complex, a, v), v, other_end(complex, b, v));
}

bool one_curve(const Complex& complex, VertexId v, EdgeId a, EdgeId b, LeavesThere at_a, LeavesThere at_b) {
  for (const LeafId leaf : complex.curve_ends[v]) {
    if (counts(at_a, leaf) && counts(at_b, leaf)) return false;
  }
  std::vector<Surface> along_a, along_b;
  std::vector<std::pair<Surface, SheetId>> facets;
  collect(complex, a, at_a, along_a, facets);
  collect(complex, b, at_b, along_b, facets);
  if (along_a != along_b || along_a.empty()) return false;
  if (std::get<0>(along_a.back())) return true;
  sort_unique(facets);
  const auto bent = std::adjacent_find(facets.begin(), facets.end(),
                                       [](const auto& x, const auto& y) { return x.first == y.first; });
  if (bent == facets.end()) return false;
  return along_a.size() > 1 || turns_less_than_right_angle(complex, v, a, b);
}

bool share_patch(const Complex& complex, FaceId f, FaceId g, LeavesThere at_f, LeavesThere at_g) {
  for (const Cover& c : complex.cover(f)) {
    const Soup::Face& source = complex.sources[c.source];
    for (const Cover& d : complex.cover(g)) {
      const Soup::Face& other = complex.sources[d.source];
      if (source.leaf != other.leaf || source.patch != other.patch) continue;
      if (counts(at_f, source.leaf) && counts(at_g, source.leaf)) return true;
    }
  }
  return false;
}

}  // namespace cnrg
