// What lies along an edge is listed as surfaces and wire curves; edges of one curve have equal lists, but for what
// comes along from leaves that do not count. Whether a surface is curved at the vertex shows in its facets around
// both edges: they lie in more than one sheet.
#include "kernel/selection/curve.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "kernel/base/sorted.h"
#include "kernel/exact/predicates.h"

namespace cnrg {
namespace {

enum class Kind : std::uint8_t { plane, curved };
using Surface = std::pair<Kind, std::uint32_t>;       // the number of the sheet, or of the surface
using PartOfLeaf = std::pair<LeafId, std::uint32_t>;  // a patch, or the curve of a wire

VertexId other_end(const Complex& complex, EdgeId e, VertexId v) {
  const auto& ends = complex.edge_ends[e];
  return ends[0] == v ? ends[1] : ends[0];
}

bool counts(LeavesThere leaves, LeafId leaf) {
  return !leaves || std::binary_search(leaves->begin(), leaves->end(), leaf);
}

Surface surface_of(const Soup::Face& source, SheetId sheet) {
  if (source.surface != 0) return {Kind::curved, source.surface};
  return {Kind::plane, sheet.value()};
}
Surface surface_of(const Complex& complex, FaceId f, const Cover& cover) {
  return surface_of(complex.sources[cover.source], complex.face_sheet[f]);
}

// What lies along an edge; lists are ascending.
struct Surroundings {
  std::vector<LeafId> leaves;
  std::vector<Surface> surfaces;
  std::vector<PartOfLeaf> wires;
  std::vector<PartOfLeaf> bent;                     // of these, such as have more than one segment
  std::vector<PartOfLeaf> sides;                    // patches with curved sides that end there
  std::vector<std::pair<Surface, SheetId>> facets;  // in any order
  bool is_cut = false;  // what counts goes on over the edge, on one surface or beside none: another leaf cut there
};

Surroundings collect(const Complex& complex, const PieceOfCurve& at) {
  struct Facet {
    const Soup::Face& source;
    SheetId sheet;
    std::size_t place;  // around the edge
    PartOfLeaf patch() const { return {source.leaf, source.patch}; }
    Surface surface() const { return surface_of(source, sheet); }
  };
  std::vector<Facet> all;
  Surroundings out;
  const auto see = [&](const Facet& facet, bool counted) {
    all.push_back(facet);
    if (!counted) return;
    out.leaves.push_back(facet.source.leaf);
    out.surfaces.push_back(facet.surface());
    out.facets.emplace_back(facet.surface(), facet.sheet);
    if (facet.source.curved_sides) out.sides.push_back(facet.patch());
  };
  std::size_t place = 0;
  for (const FaceUse& use : complex.edge_uses[at.edge]) {
    const bool bare = std::find(at.bare.begin(), at.bare.end(), use.face) != at.bare.end();
    for (const Cover& c : complex.cover(use.face)) {
      const Soup::Face& source = complex.sources[c.source];
      see({source, complex.face_sheet[use.face], place}, bare || counts(at.leaves, source.leaf));
    }
    ++place;
  }
  for (const std::uint32_t removed : complex.edge_removed_facets[at.edge]) {
    const RemovedFacet& facet = complex.removed_facets[removed];
    see({facet.source, facet.sheet, place++}, counts(at.leaves, facet.source.leaf));
  }
  for (SegmentId s : complex.edge_segments[at.edge]) {
    for (WireId w : complex.segment_wires[s]) {
      const Soup::Wire& wire = complex.wires[w];
      if (!counts(at.leaves, wire.leaf)) continue;
      out.leaves.push_back(wire.leaf);
      out.wires.emplace_back(wire.leaf, wire.leaf_edge);
      const auto goes_on = [&](std::size_t i) {
        return i < complex.wires.size() && complex.wires[WireId(i)].leaf == wire.leaf &&
               complex.wires[WireId(i)].leaf_edge == wire.leaf_edge;
      };
      if (goes_on(w.index() + 1) || goes_on(w.index() - 1)) out.bent.push_back(out.wires.back());
    }
  }
  sort_unique(out.leaves), sort_unique(out.surfaces), sort_unique(out.wires), sort_unique(out.sides);
  sort_unique(out.bent);
  const auto places = [&](const auto& is_of) {  // all that lie there, whoever counts
    std::vector<std::size_t> of;
    for (const Facet& facet : all) {
      if (is_of(facet)) of.push_back(facet.place);
    }
    sort_unique(of);
    return of.size();
  };
  std::erase_if(out.sides, [&](const PartOfLeaf& patch) {
    return places([&](const Facet& facet) { return facet.patch() == patch; }) > 1;
  });
  out.is_cut = out.wires.empty() && out.sides.empty() &&
               (out.surfaces.empty() || (out.surfaces.size() == 1 && places([&](const Facet& facet) {
                                                                       return facet.surface() == out.surfaces[0];
                                                                     }) > 1));
  return out;
}

// One of these surfaces has facets of more than one sheet there.
bool bends(const Surroundings& a, const Surroundings& b, const std::vector<Surface>& surfaces) {
  std::vector<std::pair<Surface, SheetId>> facets;
  for (const auto* of : {&a.facets, &b.facets}) {
    std::copy_if(of->begin(), of->end(), std::back_inserter(facets), [&](const auto& facet) {
      return std::binary_search(surfaces.begin(), surfaces.end(), facet.first);
    });
  }
  sort_unique(facets);
  return std::adjacent_find(facets.begin(), facets.end(),
                            [](const auto& x, const auto& y) { return x.first == y.first; }) != facets.end();
}

// A leaf along both says that its curves end in the vertex.
bool ends(const Complex& complex, VertexId v, const Surroundings& a, const Surroundings& b) {
  const std::vector<LeafId> along = in_common(a.leaves, b.leaves);
  const auto of = complex.curve_ends[v];
  return std::any_of(of.begin(), of.end(),
                     [&](LeafId leaf) { return std::binary_search(along.begin(), along.end(), leaf); });
}

}  // namespace

bool share_segment(const Complex& complex, EdgeId a, EdgeId b) {
  return std::ranges::find_first_of(complex.edge_segments[a], complex.edge_segments[b]) !=
         complex.edge_segments[a].end();
}

bool straight(const Complex& complex, VertexId v, EdgeId a, EdgeId b) {
  return collinear(complex.points, other_end(complex, a, v), v, other_end(complex, b, v));
}

bool one_curve(const Complex& complex, VertexId v, const PieceOfCurve& a, const PieceOfCurve& b) {
  const Surroundings at_a = collect(complex, a), at_b = collect(complex, b);
  if (straight(complex, v, a.edge, b.edge)) {
    const auto flat = [](const Surface& surface) { return surface.first == Kind::plane; };
    const auto in_both = in_common(at_a.wires, at_b.wires);
    const bool exact = std::ranges::count_if(in_common(at_a.surfaces, at_b.surfaces), flat) > 1 ||
                       !std::ranges::includes(at_a.bent, in_both);
    return exact || (at_a.bent == at_b.bent &&
                     std::ranges::equal(std::ranges::find_if_not(at_a.surfaces, flat), at_a.surfaces.end(),
                                        std::ranges::find_if_not(at_b.surfaces, flat), at_b.surfaces.end()));
  }
  const bool cut = a.cut && at_a.is_cut;
  if (cut != (b.cut && at_b.is_cut) || ends(complex, v, at_a, at_b)) return false;
  const bool alike = at_a.surfaces == at_b.surfaces && at_a.wires == at_b.wires &&
                     (!at_a.wires.empty() || (!at_a.sides.empty() && at_a.sides == at_b.sides) ||
                      bends(at_a, at_b, at_a.surfaces));
  if (!cut) return alike;
  const Surroundings all_a = collect(complex, {a.edge}), all_b = collect(complex, {b.edge});
  if (ends(complex, v, all_a, all_b)) return false;
  const std::vector<Surface> on = in_common(all_a.surfaces, all_b.surfaces);
  if (on.size() > 1 && bends(all_a, all_b, on)) return true;
  if (!in_common(all_a.sides, all_b.sides).empty()) return true;
  if (all_a.surfaces == all_b.surfaces && !in_common(all_a.wires, all_b.wires).empty()) return true;
  return alike && (on == all_a.surfaces || on == all_b.surfaces);  // no two leaves have cut at an angle
}

bool is_bare(const Complex& complex, FaceId f, LeavesThere leaves) {
  const auto cover = complex.cover(f);
  return std::none_of(cover.begin(), cover.end(),
                      [&](const Cover& c) { return counts(leaves, complex.sources[c.source].leaf); });
}

bool share_surface(const Complex& complex, FaceId f, FaceId g, LeavesThere at_f, LeavesThere at_g) {
  const bool all_at_f = is_bare(complex, f, at_f), all_at_g = is_bare(complex, g, at_g);
  Surface before{Kind::curved, 0};  // no face lies on it
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
