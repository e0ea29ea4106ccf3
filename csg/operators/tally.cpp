// What the cells around the change add to the counts is taken off, the cells are decided again, and what they add
// then is put on. The counts are the numbers of
//   vertices  that are kept
//   edges     that are kept, less one for each vertex inside of a chain, plus one for each closed chain
//   faces     less one for each link over an edge inside of a face that joins two pieces
//   regions   3-cells, less one for each link over a face that is no entity that joins two pieces
#include "csg/operators/tally.h"

#include <algorithm>
#include <cstdint>

#include "kernel/base/sorted.h"
#include "kernel/selection/measure.h"

namespace cnrg {
namespace {

// The cells that were listed, and all in their closure.
class Closure {
 public:
  explicit Closure(const Complex& complex) : complex_(complex), listed_(complex) {}

  template <class IdT>
  void add(IdT cell) {
    if constexpr (!std::is_same_v<IdT, RegionId>) {
      if (std::exchange(list_for(listed_, cell)[cell], 1) != 0) return;
    }
    list_for(cells_, cell).push_back(cell);
    if constexpr (!std::is_same_v<IdT, VertexId>) for_each_bounding(complex_, cell, [&](auto of) { add(of); });
  }
  const CellSet& cells() const { return cells_; }

 private:
  const Complex& complex_;
  OfEntities<Marks> listed_;
  CellSet cells_;
};

// Links that come and go in one step are no change.
template <class Link>
void settle(std::vector<Link>& links) {
  std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) { return a.key() < b.key(); });
  std::vector<Link> out;
  for (const Link& link : links) {
    if (!out.empty() && out.back().key() == link.key()) out.back().times += link.times;
    else out.push_back(link);
  }
  links = std::move(out);
}

// By how much the number of pieces changes. What comes is linked first: a piece seldom falls apart then.
template <class Link, class IdT>
int change(const std::vector<Link>& changes, ChangingLinks<IdT>& links) {
  int pieces = 0;
  for (const Link& link : changes) {
    for (int i = 0; i < link.times; ++i) pieces += links.add(link.a, link.b, link.flip);
  }
  for (const Link& link : changes) {
    for (int i = 0; i > link.times; --i) pieces += links.remove(link.a, link.b);
  }
  return pieces;
}

}  // namespace

Tally::Tally(const Complex& complex, const OfEntities<EntityMarks>& marks, const LeafUnions& sets,
             const HeldRegions& regions, std::span<const Group* const> held)
    : complex_(complex),
      marks_(marks),
      regions_(regions),
      sources_(marks, sets),
      merging_(complex, {}, {}, SimplifyMode::features, &sources_),
      inside_(complex.region_count) {
  load(held);
}

void Tally::load(std::span<const Group* const> held) {
  OrientedSets pieces(complex_.face_count());
  for (const Group* part : held) {
    decide({part->vertices, part->edges, part->faces, {}});
    for (const EdgeId e : part->edges) {
      if (merging_.fate(e) != Fate::in_face) continue;
      const auto [f, g] = merging_.merged_over(e);
      const bool flip = f.half_edge == g.half_edge;
      known_ = known_ && pieces.unite(f.face, g.face, flip);
      face_links_.start(f.face, g.face, flip);
    }
    for (const auto& [cell, region] : part->cells) {
      inside_[cell] = 1;
      known_ = known_ && !complex_.unbounded(cell);
    }
    std::vector<Link<RegionId>> links;
    for (const auto& [cell, region] : part->cells) {
      for (const HalfFace h : complex_.region_faces[cell]) {
        const FaceId f = h.face();
        if (h.side() == 0) link_regions(std::span(&f, 1), 1, links);
      }
    }
    for (const Link<RegionId>& link : links) region_links_.start(link.a, link.b, false);
  }
}

void Tally::update(const CellSet& changed, TotalsChange& out) {
  if (!known()) return;
  std::vector<RegionId> gone, come;
  for (const RegionId r : changed.regions) {
    const bool now = regions_.in_held(r);
    if (now == (inside_[r] != 0)) continue;
    (now ? come : gone).push_back(r);
    known_ = known_ && !complex_.unbounded(r);
  }
  sort_unique(gone), sort_unique(come);
  if (!known()) return;

  Closure around(complex_);
  const auto add = [&](const auto& list) {
    for (const auto cell : list) around.add(cell);
  };
  for_each_entity(add, changed);
  add(gone), add(come);
  const CellSet& cells = around.cells();

  std::vector<Link<FaceId>> faces;
  std::vector<Link<RegionId>> regions;
  count(cells, -1, out);
  link_faces(cells.edges, -1, faces);
  link_regions(cells.faces, -1, regions);
  decide(cells);
  for (const RegionId r : gone) inside_[r] = 0;
  for (const RegionId r : come) inside_[r] = 1;
  count(cells, 1, out);
  link_faces(cells.edges, 1, faces);
  link_regions(cells.faces, 1, regions);

  settle(faces), settle(regions);
  out.simplified[2] += change(faces, face_links_);
  const std::int64_t pieces = static_cast<std::int64_t>(come.size()) - static_cast<std::int64_t>(gone.size()) +
                              change(regions, region_links_);
  out.simplified[3] += pieces;
  out.regions += pieces;
  if (!come.empty()) out.volume += *volume(complex_, come);
  if (!gone.empty()) out.volume -= *volume(complex_, gone);
}

void Tally::decide(const CellSet& cells) {
  const auto held = [&](auto cell) { return list_for(marks_, cell).has(cell, kHeld) ? 1 : 0; };
  for (const FaceId f : cells.faces) merging_.put(f, held(f));
  for (const EdgeId e : cells.edges) merging_.put(e, held(e), marks_.edges.has(e, kHeldFeature));
  for (const VertexId v : cells.vertices) merging_.put(v, held(v), marks_.vertices.has(v, kHeldFeature));
}

void Tally::count(const CellSet& cells, int sign, TotalsChange& out) {
  const auto there = [&](auto cell) {
    return merging_.state(cell) != 0 || inside_[complex_.some_region(cell)] != 0;
  };
  for (const VertexId v : cells.vertices) {
    if (there(v)) out.raw[0] += sign;
    if (merging_.state(v) == 0) continue;
    if (merging_.fate(v) == Fate::kept) out.simplified[0] += sign;
    if (merging_.fate(v) == Fate::in_edge) out.simplified[1] -= sign;
  }
  for (const EdgeId e : cells.edges) {
    if (there(e)) out.raw[1] += sign;
    if (merging_.state(e) != 0 && is_open(e)) out.simplified[1] += sign;
  }
  count_closed_chains(cells.vertices, sign, out);
  for (const FaceId f : cells.faces) {
    if (there(f)) out.raw[2] += sign;
    if (merging_.state(f) != 0) out.simplified[2] += sign;
  }
  for (const RegionId r : cells.regions) {
    if (inside_[r] != 0) out.raw[3] += sign;
  }
}

// From each vertex along its chain, one way, until that ends, comes back, or was seen before.
void Tally::count_closed_chains(std::span<const VertexId> vertices, int sign, TotalsChange& out) const {
  Marks<EdgeId> seen(complex_.edge_count());
  for (const VertexId start : vertices) {
    if (merging_.state(start) == 0 || merging_.fate(start) != Fate::in_edge) continue;
    const auto edges = complex_.vertex_edges[start];
    const EdgeId first = *std::find_if(edges.begin(), edges.end(), [&](EdgeId e) { return is_open(e); });
    if (seen.get(first) != 0) continue;
    VertexId v = start;
    EdgeId e = first;
    while (merging_.fate(v) == Fate::in_edge) {
      if (std::exchange(seen[e], 1) != 0) {
        if (e == first && v == start) out.simplified[1] += sign;
        break;
      }
      const auto& [tail, head] = complex_.edge_ends[e];
      v = tail == v ? head : tail;
      for (const EdgeId other : complex_.vertex_edges[v]) {
        if (other != e && is_open(other)) {
          e = other;
          break;
        }
      }
    }
  }
}

void Tally::link_faces(std::span<const EdgeId> edges, int sign, std::vector<Link<FaceId>>& links) const {
  for (const EdgeId e : edges) {
    if (merging_.state(e) == 0 || merging_.fate(e) != Fate::in_face) continue;
    const auto [f, g] = merging_.merged_over(e);
    const auto [first, second] = std::minmax(f.face, g.face);
    links.push_back({first, second, f.half_edge == g.half_edge, sign});
  }
}

void Tally::link_regions(std::span<const FaceId> faces, int sign, std::vector<Link<RegionId>>& links) const {
  for (const FaceId f : faces) {
    const auto& [front, back] = complex_.face_regions[f];
    if (merging_.state(f) != 0 || front == back || inside_[front] == 0 || inside_[back] == 0) continue;
    links.push_back({std::min(front, back), std::max(front, back), false, sign});
  }
}

}  // namespace cnrg
