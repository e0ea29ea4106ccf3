// The rules of csg/SEMANTICS.md#simplification at each cell.
//
// Degrees do not tell that a vertex lies inside a face: with no kept edge around it, it may still be the point
// where two faces touch (two cones, tip to tip). The faces around it form *fans*, joined over vanished edges; a
// fan without a kept edge is a disk that has the vertex in its interior. If there is one such disk and nothing
// else, the vertex is inside a face. Likewise two kept edges become one only if each fan runs between the two.
#include "kernel/selection/merging.h"

#include <algorithm>

#include "kernel/base/error.h"
#include "kernel/base/parallel.h"
#include "kernel/base/union_find.h"
#include "kernel/selection/curve.h"

namespace cnrg {

std::pair<FaceId, bool> OrientedSets::find(FaceId x) const {
  bool flip = false;
  for (Link up = links_[x]; up.parent != 0; up = links_[x]) {
    flip ^= up.flip;
    x = FaceId(up.parent - 1);
  }
  return {x, flip};
}

// As `find`; each member on the way is linked to the smallest one, so that the next search is short.
std::pair<FaceId, bool> OrientedSets::shortened(FaceId x) {
  const auto [root, flip] = find(x);
  bool rest = flip;
  while (x != root) {
    const Link up = links_.get(x);
    links_[x] = {root.value() + 1, rest};
    rest ^= up.flip;
    x = FaceId(up.parent - 1);
  }
  return {root, flip};
}

void OrientedSets::settle() {
  std::sort(joined_.begin(), joined_.end());
  for (FaceId f : joined_) shortened(f);
}

void OrientedSets::reset() {
  for (const FaceId f : joined_) links_[f] = {};
  joined_.clear();
}

bool OrientedSets::unite(FaceId a, FaceId b, bool flip) {
  const auto [root_a, flip_a] = shortened(a);
  const auto [root_b, flip_b] = shortened(b);
  const bool turned = flip_a ^ flip_b ^ flip;
  if (root_a == root_b) return !turned;
  const auto [root, other] = std::minmax(root_a, root_b);
  links_[other] = {root.value() + 1, turned};
  joined_.push_back(other);
  return true;
}

Merging::Merging(const Complex& complex, const Selection& selection, const Features& features, SimplifyMode mode,
                 const CellSources* sources)
    : complex_(complex),
      mode_(mode),
      sources_(sources),
      marks_(sources != nullptr && sources->marks_anything() ? sources : nullptr),
      vertex_state_(complex.points.size()),
      edge_state_(complex.edge_count()),
      face_state_(complex.face_count()),
      region_state_(complex.region_count),
      face_fate_(complex.face_count()),
      edge_fate_(complex.edge_count()),
      vertex_fate_(complex.points.size()),
      vertex_host_(complex.points.size()),
      regions_(complex.region_count),
      faces_(complex.face_count()),
      chains_(complex.edge_count()),
      next_(complex.edge_uses.value_count()),
      previous_(complex.edge_uses.value_count()) {
  for (const auto& [v, c] : selection.vertices) vertex_state_[v] = c;
  for (const auto& [e, c] : selection.edges) edge_state_[e] = c;
  for (const auto& [f, c] : selection.faces) face_state_[f] = c;
  for (const auto& [r, c] : selection.regions) region_state_[r] = c;
  static const Features none;
  const Features& kept = mode == SimplifyMode::points ? none : features;
  collect_domain(selection, kept);
  decide_faces();
  decide_edges(kept.edges);
  decide_vertices(kept.vertices);
}

// Lists the domain, without cells on the frame, which are never active. Its cells have the fate `kept`, unless one
// of the decisions below takes it from them.
void Merging::collect_domain(const Selection& selection, const Features& features) {
  const auto add = [&](auto& fates) {
    return [&](auto id) {
      if (!complex_.on_frame(id)) fates.set(id, Fate::kept);
    };
  };
  const auto add_vertex = add(vertex_fate_);
  const auto add_edge = add(edge_fate_);
  const auto add_face = add(face_fate_);
  for (const auto& [f, c] : selection.faces) add_face(f);
  for (const auto& [r, c] : selection.regions) {
    domain_.regions.push_back(r);
    for_each_of(complex_.region_faces[r], [&](HalfFace h) { add_face(h.face()); });
    for (EdgeId e : complex_.region_wires[r]) add_edge(e);
    for (VertexId v : complex_.region_vertices[r]) add_vertex(v);
  }
  domain_.faces = face_fate_.ids();
  for (const auto& [e, c] : selection.edges) add_edge(e);
  for (EdgeId e : features.edges) add_edge(e);
  for_each_of(domain_.faces, [&](FaceId f) {
    for (const HalfEdge h : complex_.half_edges(f)) add_edge(h.edge());
    for (VertexId v : complex_.face_vertices[f]) add_vertex(v);
  });
  domain_.edges = edge_fate_.ids();
  for (const auto& [v, c] : selection.vertices) add_vertex(v);
  for (VertexId v : features.vertices) add_vertex(v);
  for_each_of(domain_.edges, [&](EdgeId e) {
    for (VertexId v : complex_.edge_ends[e]) add_vertex(v);
  });
  domain_.vertices = vertex_fate_.ids();
}

void Merging::put(FaceId f, Component state) {
  face_state_[f] = state;
  face_fate_[f] = state == 0 ? Fate::in_region : Fate::kept;
}

void Merging::put(EdgeId e, Component state, bool feature) {
  edge_state_[e] = state;
  edge_fate_[e] = state == 0 ? Fate::in_region : feature ? Fate::kept : decide(e);
}

void Merging::put(VertexId v, Component state, bool feature) {
  vertex_state_[v] = state;
  vertex_fate_[v] = state == 0 ? Fate::in_region : feature || pinned(v) ? Fate::kept : decide(v);
}

void Merging::decide_faces() {
  for (FaceId f : domain_.faces) {
    const auto& [front, back] = complex_.face_regions[f];
    const Component s = state(f);
    if (s != state(front) || s != state(back) || !mergeable(s) || mark(f) != 0) continue;
    face_fate_[f] = Fate::in_region;
    regions_.unite(front, back);
  }
}

void Merging::merge_inactive_regions() {
  for (FaceId f : IdRange<FaceId>(complex_.face_count())) {
    const auto& [front, back] = complex_.face_regions[f];
    if (fate(f) == Fate::in_region) regions_.unite(front, back);
  }
}

void Merging::decide_edges(const std::vector<EdgeId>& features) {
  for_each_of(domain_.edges, [&](EdgeId e) {
    if (mergeable(state(e))) edge_fate_[e] = decide(e);
  });
  for (EdgeId e : features) edge_fate_[e] = Fate::kept;
  for (EdgeId e : domain_.edges) {
    if (edge_fate_.get(e) != Fate::in_face) continue;
    const auto [f, g] = merged_over(e);
    if (faces_.unite(f.face, g.face, f.half_edge == g.half_edge)) inner_edges_.push_back(e);
    else edge_fate_[e] = Fate::kept;
  }
  faces_.settle();
}

// What the cells around an edge say. Two faces that may merge over it are not compared in orientation yet:
// `decide_edges` keeps an edge that would join a face to itself the wrong way round.
Merging::Fate Merging::decide(EdgeId e) const {
  const Component s = state(e);
  Use pair[2];
  std::size_t n = 0;
  for (Use u = first_use(e); u != end_use(e); ++u) {
    if (!remains(u)) continue;
    if (n == 2) return Fate::kept;
    pair[n++] = u;
  }
  if (n == 1 || mark(e) != 0) return Fate::kept;
  if (n == 0) return s == state(complex_.some_region(e)) ? Fate::in_region : Fate::kept;
  const FaceId f = use(pair[0]).face, g = use(pair[1]).face;
  if (s != state(f) || s != state(g) || mark(f) != mark(g)) return Fate::kept;
  return one_surface(f, g) ? Fate::in_face : Fate::kept;
}

std::pair<FaceUse, FaceUse> Merging::merged_over(EdgeId e) const {
  FaceUse pair[2];
  std::size_t n = 0;
  for (Use u = first_use(e); u != end_use(e); ++u) {
    if (remains(u)) pair[n++] = use(u);
  }
  return {pair[0], pair[1]};
}

void Merging::uses_along(FaceId f, LoopId l, std::vector<Use>& out) const {
  out.clear();
  for (HalfEdge h : complex_.loop[l]) {
    Use u = first_use(h.edge());
    while (u != end_use(h.edge()) && use(u) != FaceUse{f, h}) ++u;
    require(u != end_use(h.edge()), "simplify: a loop passes an edge that does not know its face");
    out.push_back(u);
  }
}

void Merging::link_loops(FaceId f) {
  std::vector<Use> uses;
  for (LoopId l : complex_.face_loops[f]) {
    uses_along(f, l, uses);
    Use before = uses.back();
    for (Use u : uses) {
      next_[Id<UseTag>(before)] = u + 1;
      previous_[Id<UseTag>(u)] = before + 1;
      before = u;
    }
  }
}

Merging::Use Merging::neighbour(Use u, VertexId v) {
  if (next_.get(Id<UseTag>(u)) == 0) link_loops(use(u).face);
  return (complex_.target(use(u).half_edge) == v ? next_ : previous_).get(Id<UseTag>(u)) - 1;
}

// The other remaining use of an edge that vanished in a face.
Merging::Use Merging::twin_use(Use u) const {
  const EdgeId e = use(u).half_edge.edge();
  for (Use w = first_use(e); w != end_use(e); ++w) {
    if (w != u && remains(w)) return w;
  }
  throw InvariantError("simplify: an edge vanished in a face that it bounds");
}

Merging::Use Merging::across(Use u, VertexId v) {
  Use w = neighbour(u, v);
  while (!walkable(use(w).half_edge.edge())) w = neighbour(twin_use(w), v);
  return w;
}

void Merging::isolating_faces(VertexId v, std::vector<FaceId>& out) {
  out.clear();
  for (FaceId f : complex_.vertex_faces[v]) {
    if (fate(f) == Fate::kept) out.push_back(face(f).first);
  }
  // Fans over vanished edges: sets of these edges that no kept edge borders.
  const auto edges = complex_.vertex_edges[v];
  if (std::none_of(edges.begin(), edges.end(), [&](EdgeId e) { return fate(e) == Fate::in_face; })) return;
  UnionFind fans(edges.size());
  std::vector<char> open(edges.size(), 0);
  const auto place = [&](EdgeId e) {
    return static_cast<std::uint32_t>(std::lower_bound(edges.begin(), edges.end(), e) - edges.begin());
  };
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    if (fate(edges[i]) != Fate::in_face) continue;
    for (Use u = first_use(edges[i]); u != end_use(edges[i]); ++u) {
      if (!remains(u)) continue;
      const EdgeId other = use(neighbour(u, v)).half_edge.edge();
      if (walkable(other)) open[i] = 1;
      else fans.unite(i, place(other));
    }
  }
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    if (open[i]) open[fans.find(i)] = 1;
  }
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    if (fate(edges[i]) != Fate::in_face || fans.find(i) != i || open[i]) continue;
    for (Use u = first_use(edges[i]); u != end_use(edges[i]); ++u) {
      if (remains(u)) {
        out.push_back(face(use(u).face).first);
        break;
      }
    }
  }
  std::sort(out.begin(), out.end());
}

// Nearly all vertices are kept for their degree. The others are decided one after the other, as walks around them
// link loops.
void Merging::decide_vertices(const std::vector<VertexId>& features) {
  for_each_of(domain_.vertices, [&](VertexId v) {
    if (mergeable(state(v)) && !pinned(v)) vertex_fate_[v] = Fate::in_region;
  });
  for (VertexId v : features) vertex_fate_[v] = Fate::kept;
  for (VertexId v : domain_.vertices) {
    if (vertex_fate_.get(v) == Fate::kept) continue;
    vertex_fate_[v] = decide(v);
  }
}

// True if its edges alone show that v is kept: some are walkable, but not exactly two of the state of v.
bool Merging::pinned(VertexId v) const {
  std::size_t n = 0;
  for (EdgeId e : complex_.vertex_edges[v]) {
    if (!walkable(e)) continue;
    if (++n > 2 || state(v) != state(e)) return true;
  }
  return n == 1;
}

Merging::Fate Merging::decide(VertexId v) {
  const Component s = state(v);
  if (mark(v) != 0) return Fate::kept;
  EdgeId pair[2];
  std::size_t n = 0;
  for (EdgeId e : complex_.vertex_edges[v]) {
    if (walkable(e)) pair[n++] = e;
  }
  isolating_faces(v, around_);
  if (n == 2) {
    if (!around_.empty() || !continues(v, pair[0], pair[1])) return Fate::kept;
    chains_.unite(pair[0], pair[1]);
    return Fate::in_edge;
  }
  if (around_.empty()) return s == state(complex_.some_region(v)) ? Fate::in_region : Fate::kept;
  if (around_.size() > 1 || s != state(around_[0])) return Fate::kept;
  vertex_host_[v] = around_[0];
  return Fate::in_face;
}

// True if two kept edges become one: all faces run along both, and both are pieces of one line or curve. As v is
// not on the frame, neither are they.
bool Merging::continues(VertexId v, EdgeId a, EdgeId b) {
  if (mark(a) != mark(b)) return false;
  std::size_t at_a = 0, at_b = 0;
  for (Use u = first_use(b); u != end_use(b); ++u) at_b += remains(u);
  for (Use u = first_use(a); u != end_use(a); ++u) {
    if (!remains(u)) continue;
    ++at_a;
    if (use(across(u, v)).half_edge.edge() != b) return false;
  }
  if (at_a != at_b) return false;
  if (mode_ == SimplifyMode::points) return straight(complex_, v, a, b);
  const bool has_no_curves = complex_.surface_count == 0 && complex_.wires.empty();
  return (has_no_curves && straight(complex_, v, a, b)) || one_curve(v, a, b);
}

// True for faces of one plane or of one curved surface. Facets of two curved surfaces may lie in one plane by
// chance: they are no face of it.
bool Merging::one_surface(FaceId f, FaceId g) const {
  const bool coplanar = complex_.face_sheet[f] == complex_.face_sheet[g];
  if (mode_ == SimplifyMode::points || complex_.surface_count == 0) return coplanar;
  if (!share_surface(complex_, f, g)) return false;
  if (sources_ == nullptr) return true;
  std::vector<LeafId> at_f, at_g;
  sources_->leaves_of(f, at_f);
  sources_->leaves_of(g, at_g);
  return share_surface(complex_, f, g, at_f, at_g);
}

bool Merging::between_coplanar_facets(EdgeId e) const {
  const auto [f, g] = merged_over(e);
  if (complex_.face_sheet[f.face] != complex_.face_sheet[g.face]) return false;
  if (complex_.face_cover[f.face] == complex_.face_cover[g.face]) return false;
  if (sources_ == nullptr) return true;
  std::vector<LeafId> at_f, at_g;
  sources_->leaves_of(f.face, at_f);
  sources_->leaves_of(g.face, at_g);
  return !share_facets(complex_, f.face, g.face, at_f, at_g);
}

bool Merging::one_curve(VertexId v, EdgeId a, EdgeId b) const {
  if (sources_ == nullptr) return cnrg::one_curve(complex_, v, {a}, {b});
  struct Side {
    std::vector<LeafId> leaves;
    std::vector<FaceId> bare;
  };
  const auto side = [&](EdgeId e) {
    Side result;
    sources_->leaves_of(e, result.leaves);
    for (Use u = first_use(e); u != end_use(e); ++u) {
      if (remains(u) && is_bare(complex_, use(u).face, result.leaves)) result.bare.push_back(use(u).face);
    }
    return result;
  };
  const Side at_a = side(a), at_b = side(b);
  return cnrg::one_curve(complex_, v, {a, at_a.leaves, at_a.bare, true}, {b, at_b.leaves, at_b.bare, true});
}

}  // namespace cnrg
