// What lies along an edge is listed as surfaces and wire curves; edges of one curve have equal lists. Whether a
// surface is curved at the vertex shows in its facets around both edges: they lie in more than one sheet.
#include "kernel/selection/curve.h"

#include <algorithm>
#include <tuple>

#include "kernel/base/sorted.h"
#include "kernel/exact/predicates.h"

namespace cnrg {
namespace {

// What lies at an edge, in this order.
enum class Kind : std::uint8_t { plane, curved, wire };
using Surface = std::tuple<Kind, LeafId, std::uint32_t>;  // the number of the sheet, the surface, the leaf's curve

VertexId other_end(const Complex& complex, EdgeId e, VertexId v) {
  const auto& ends = complex.edge_ends[e];
  return ends[0] == v ? ends[1] : ends[0];
}

bool counts(LeavesThere leaves, LeafId leaf) {
  return !leaves || std::binary_search(leaves->begin(), leaves->end(), leaf);
}

Surface surface_of(const Soup::Face& source, SheetId sheet) {
  if (source.surface != 0) return {Kind::curved, LeafId::none(), source.surface};
  return {Kind::plane, LeafId::none(), sheet.value()};
}
Surface surface_of(const Complex& complex, FaceId f, const Cover& cover) {
  return surface_of(complex.sources[cover.source], complex.face_sheet[f]);
}

// What lies along an edge.
struct Surroundings {
  std::vector<LeafId> leaves;                            // in any order
  std::vector<Surface> surfaces;                         // ascending
  std::vector<std::pair<Surface, SheetId>> facets;       // in any order
  std::vector<std::pair<LeafId, std::uint32_t>> sheets;  // patches with curved sides, once for each facet
  std::size_t faces = 0;                                 // with a facet of a leaf that counts

  // The patches that end there.
  std::vector<std::pair<LeafId, std::uint32_t>> sides() const {
    std::vector<std::pair<LeafId, std::uint32_t>> out;
    for (const auto& patch : sheets) {
      if (std::count(sheets.begin(), sheets.end(), patch) == 1) out.push_back(patch);
    }
    sort_unique(out);
    return out;
  }
  // The leaves that count go on over the edge, on one surface or beside none: another one has cut there.
  bool is_cut() const {
    return surfaces.empty() ||
           (surfaces.size() == 1 && std::get<0>(surfaces[0]) != Kind::wire && faces > 1 && sides().empty());
  }
};

Surroundings collect(const Complex& complex, const PieceOfCurve& at) {
  Surroundings out;
  const auto see = [&](const Soup::Face& source, SheetId sheet) {
    out.leaves.push_back(source.leaf);
    out.surfaces.push_back(surface_of(source, sheet));
    out.facets.emplace_back(out.surfaces.back(), sheet);
    if (source.curved_sides) out.sheets.emplace_back(source.leaf, source.patch);
  };
  for (const FaceUse& use : complex.edge_uses[at.edge]) {
    const bool bare = std::find(at.bare.begin(), at.bare.end(), use.face) != at.bare.end();
    const std::size_t before = out.surfaces.size();
    for (const Cover& c : complex.cover(use.face)) {
      const Soup::Face& source = complex.sources[c.source];
      if (bare || counts(at.leaves, source.leaf)) see(source, complex.face_sheet[use.face]);
    }
    out.faces += out.surfaces.size() > before ? 1 : 0;
  }
  for (const std::uint32_t place : complex.edge_removed_facets[at.edge]) {
    const RemovedFacet& facet = complex.removed_facets[place];
    if (counts(at.leaves, facet.source.leaf)) see(facet.source, facet.sheet);
  }
  for (SegmentId s : complex.edge_segments[at.edge]) {
    for (WireId w : complex.segment_wires[s]) {
      const Soup::Wire& wire = complex.wires[w];
      if (!counts(at.leaves, wire.leaf)) continue;
      out.leaves.push_back(wire.leaf);
      out.surfaces.emplace_back(Kind::wire, wire.leaf, wire.leaf_edge);
    }
  }
  sort_unique(out.surfaces);
  return at.leaves && out.is_cut() ? collect(complex, {at.edge}) : out;
}

}  // namespace

bool straight(const Complex& complex, VertexId v, EdgeId a, EdgeId b) {
  return collinear(complex.points, other_end(complex, a, v), v, other_end(complex, b, v));
}

bool one_curve(const Complex& complex, VertexId v, const PieceOfCurve& a, const PieceOfCurve& b) {
  const Surroundings at_a = collect(complex, a), at_b = collect(complex, b);
  const auto along = [](const Surroundings& at, LeafId leaf) {
    return std::find(at.leaves.begin(), at.leaves.end(), leaf) != at.leaves.end();
  };
  for (const LeafId leaf : complex.curve_ends[v]) {
    if (along(at_a, leaf) && along(at_b, leaf)) return false;
  }
  if (at_a.surfaces != at_b.surfaces || at_a.surfaces.empty()) return false;
  if (std::get<0>(at_a.surfaces.back()) == Kind::wire) return true;
  if (const auto sides = at_a.sides(); !sides.empty() && sides == at_b.sides()) return true;
  std::vector<std::pair<Surface, SheetId>> facets = at_a.facets;
  facets.insert(facets.end(), at_b.facets.begin(), at_b.facets.end());
  sort_unique(facets);
  return std::adjacent_find(facets.begin(), facets.end(),
                            [](const auto& x, const auto& y) { return x.first == y.first; }) != facets.end();
}

bool is_bare(const Complex& complex, FaceId f, LeavesThere leaves) {
  const auto cover = complex.cover(f);
  return std::none_of(cover.begin(), cover.end(),
                      [&](const Cover& c) { return counts(leaves, complex.sources[c.source].leaf); });
}

bool share_surface(const Complex& complex, FaceId f, FaceId g, LeavesThere at_f, LeavesThere at_g) {
  const bool all_at_f = is_bare(complex, f, at_f), all_at_g = is_bare(complex, g, at_g);
  Surface before{Kind::wire, LeafId::none(), 0};  // no face lies on it
  for (const Cover& c : complex.cover(f)) {
    if (!all_at_f && !counts(at_f, complex.sources[c.source].leaf)) continue;
    const Surface surface = surface_of(complex, f, c);
    if (surface == before) continue;  // as of all that lies in the plane alone
    before = surface;
    for (const Cover& d : complex.cover(g)) {
      if (!all_at_g && !counts(at_g, complex.sources[d.source].leaf)) continue;
      if (surface == surface_of(complex, g, d)) return true;
    }
  }
  return false;
}

bool share_facets(const Complex& complex, FaceId f, FaceId g, LeavesThere at_f, LeavesThere at_g) {
  const auto facets = [&](FaceId face, LeavesThere leaves) {
    std::vector<SourceId> out;
    const bool all = is_bare(complex, face, leaves);
    for (const Cover& c : complex.cover(face)) {
      if (all || counts(leaves, complex.sources[c.source].leaf)) out.push_back(c.source);
    }
    return out;
  };
  return facets(f, at_f) == facets(g, at_g);
}

}  // namespace cnrg
