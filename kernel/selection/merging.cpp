// The rules of SEMANTICS 6 at each cell.
//
// A vertex inside a face is not told by its degree alone: with no kept edge around it, it may still be the point
// where two faces touch (two cones, tip to tip). The faces around it form *fans*, joined over vanished edges; a
// fan without a kept edge is a disk that has the vertex in its interior. One such disk and nothing else: the
// vertex is inside a face. Likewise two kept edges are one only if every fan runs from one to the other.
#include "kernel/selection/merging.h"

#include <algorithm>

#include "kernel/base/error.h"
#include "kernel/base/union_find.h"
#include "kernel/selection/curve.h"

namespace cnrg {

std::pair<FaceId, bool> OrientedSets::find(FaceId x) {
  FaceId root = x;
  bool flip = false;
  while (links_[root].parent != 0) {
    flip ^= links_[root].flip;
    root = FaceId(links_[root].parent - 1);
  }
  bool rest = flip;
  while (x != root) {
    const Link up = links_[x];
    links_[x] = {root.value() + 1, rest};
    rest ^= up.flip;
    x = FaceId(up.parent - 1);
  }
  return {root, flip};
}

bool OrientedSets::unite(FaceId a, FaceId b, bool flip) {
  const auto [root_a, flip_a] = find(a);
  const auto [root_b, flip_b] = find(b);
  const bool turned = flip_a ^ flip_b ^ flip;
  if (root_a == root_b) return !turned;
  if (root_a < root_b) links_[root_b] = {root_a.value() + 1, turned};
  else links_[root_a] = {root_b.value() + 1, turned};
  return true;
}

Merging::Merging(const Complex& complex, const Selection& selection, const Features& features, SimplifyMode mode)
    : complex_(complex), mode_(mode), vertex_state_(complex.points.size()), edge_state_(complex.edge_count()),
      face_state_(complex.face_count()), region_state_(complex.region_count), face_fate_(complex.face_count()),
      edge_fate_(complex.edge_count()), vertex_fate_(complex.points.size()), vertex_host_(complex.points.size()),
      regions_(complex.region_count), faces_(complex.face_count()), next_(complex.edge_uses.value_count()),
      previous_(complex.edge_uses.value_count()) {
  for (const auto& [v, c] : selection.vertices) vertex_state_[v] = c;
  for (const auto& [e, c] : selection.edges) edge_state_[e] = c;
  for (const auto& [f, c] : selection.faces) face_state_[f] = c;
  for (const auto& [r, c] : selection.regions) region_state_[r] = c;
  static const Features none;
  const Features& kept = mode == SimplifyMode::points ? none : features;
  collect_domain(selection, kept);
  decide_faces();
  link_loops();
  decide_edges(kept.edges);
  decide_vertices(kept.vertices);
}

// The closure, with a mark per cell so that each is listed once. Cells on the frame are never active.
void Merging::collect_domain(const Selection& selection, const Features& features) {
  Marks<VertexId> vertices(complex_.points.size());
  Marks<EdgeId> edges(complex_.edge_count());
  Marks<FaceId> faces(complex_.face_count());
  const auto add_to = [&](auto& list, auto& marks) {
    return [&](auto id) {
      if (marks[id]) return;
      marks[id] = 1;
      if (!complex_.on_frame(id)) list.push_back(id);
    };
  };
  const auto add_vertex = add_to(domain_.vertices, vertices);
  const auto add_edge = add_to(domain_.edges, edges);
  const auto add_face = add_to(domain_.faces, faces);
  for (const auto& [v, c] : selection.vertices) add_vertex(v);
  for (VertexId v : features.vertices) add_vertex(v);
  for (const auto& [e, c] : selection.edges) add_edge(e);
  for (EdgeId e : features.edges) add_edge(e);
  for (const auto& [f, c] : selection.faces) add_face(f);
  for (const auto& [r, c] : selection.regions) {
    domain_.regions.push_back(r);
    for (HalfFace h : complex_.region_faces[r]) add_face(h.face());
    for (EdgeId e : complex_.region_wires[r]) add_edge(e);
    for (VertexId v : complex_.region_vertices[r]) add_vertex(v);
  }
  for (FaceId f : domain_.faces) {
    for (LoopId l : complex_.face_loops[f]) {
      for (HalfEdge h : complex_.loop[l]) add_edge(h.edge());
    }
    for (VertexId v : complex_.face_vertices[f]) add_vertex(v);
  }
  for (EdgeId e : domain_.edges) {
    for (VertexId v : complex_.edge_ends[e]) add_vertex(v);
  }
  std::sort(domain_.vertices.begin(), domain_.vertices.end());
  std::sort(domain_.edges.begin(), domain_.edges.end());
  std::sort(domain_.faces.begin(), domain_.faces.end());
}

void Merging::decide_faces() {
  for (FaceId f : domain_.faces) {
    const auto& [front, back] = complex_.face_regions[f];
    const Component s = state(f);
    if (s != state(front) || s != state(back) || !mergeable(s)) face_fate_[f] = Fate::kept;
    else regions_.unite(front, back);
  }
}

void Merging::merge_inactive_regions() {
  for (FaceId f : IdRange<FaceId>(complex_.face_count())) {
    const auto& [front, back] = complex_.face_regions[f];
    if (fate(f) == Fate::in_region) regions_.unite(front, back);
  }
}

// The order of the uses of each remaining face along its loops.
void Merging::link_loops() {
  for (FaceId f : domain_.faces) {
    if (fate(f) != Fate::kept) continue;
    for (LoopId l : complex_.face_loops[f]) {
      const auto find_use = [&](HalfEdge h) {
        Use u = first_use(h.edge());
        while (u != end_use(h.edge()) && use(u) != FaceUse{f, h}) ++u;
        require(u != end_use(h.edge()), "simplify: a loop passes an edge that does not know its face");
        return u;
      };
      const auto loop = complex_.loop[l];
      const Use first = find_use(loop.front());
      Use last = first;
      for (std::size_t i = 1; i < loop.size(); ++i) {
        const Use u = find_use(loop[i]);
        next_[Id<UseTag>(last)] = u;
        previous_[Id<UseTag>(u)] = last;
        last = u;
      }
      next_[Id<UseTag>(last)] = first;
      previous_[Id<UseTag>(first)] = last;
    }
  }
}

void Merging::decide_edges(const std::vector<EdgeId>& features) {
  auto feature = features.begin();
  for (EdgeId e : domain_.edges) {
    while (feature != features.end() && *feature < e) ++feature;
    const bool free = (feature == features.end() || *feature != e) && mergeable(state(e));
    edge_fate_[e] = free ? decide(e) : Fate::kept;
  }
}

Merging::Fate Merging::decide(EdgeId e) {
  const Component s = state(e);
  Use pair[2];
  std::size_t n = 0;
  for (Use u = first_use(e); u != end_use(e); ++u) {
    if (!remains(u)) continue;
    if (n == 2) return Fate::kept;
    pair[n++] = u;
  }
  if (n == 0) return s == state(complex_.some_region(e)) ? Fate::in_region : Fate::kept;
  if (n == 1) return Fate::kept;
  const auto& [f, hf] = use(pair[0]);
  const auto& [g, hg] = use(pair[1]);
  if (s != state(f) || s != state(g)) return Fate::kept;
  const bool coplanar = complex_.face_sheet[f] == complex_.face_sheet[g];
  if (!coplanar && (mode_ == SimplifyMode::points || !share_patch(complex_, f, g))) return Fate::kept;
  return faces_.unite(f, g, hf == hg) ? Fate::in_face : Fate::kept;
}

Merging::Use Merging::neighbour(Use u, VertexId v) const {
  return complex_.target(use(u).half_edge) == v ? next_[Id<UseTag>(u)] : previous_[Id<UseTag>(u)];
}

// The other remaining use of an edge that vanished in a face.
Merging::Use Merging::twin_use(Use u) const {
  const EdgeId e = use(u).half_edge.edge();
  for (Use w = first_use(e); w != end_use(e); ++w) {
    if (w != u && remains(w)) return w;
  }
  throw InvariantError("simplify: an edge vanished in a face that it bounds");
}

Merging::Use Merging::across(Use u, VertexId v) const {
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

void Merging::decide_vertices(const std::vector<VertexId>& features) {
  auto feature = features.begin();
  for (VertexId v : domain_.vertices) {
    while (feature != features.end() && *feature < v) ++feature;
    const bool free = (feature == features.end() || *feature != v) && mergeable(state(v));
    vertex_fate_[v] = free ? decide(v) : Fate::kept;
  }
}

Merging::Fate Merging::decide(VertexId v) {
  const Component s = state(v);
  EdgeId pair[2];
  std::size_t n = 0;
  for (EdgeId e : complex_.vertex_edges[v]) {
    if (!walkable(e)) continue;
    if (n == 2) return Fate::kept;
    pair[n++] = e;
  }
  if (n == 1) return Fate::kept;
  if (n == 2 && (s != state(pair[0]) || s != state(pair[1]))) return Fate::kept;
  isolating_faces(v, around_);
  if (n == 2) return around_.empty() && continues(v, pair[0], pair[1]) ? Fate::in_edge : Fate::kept;
  if (around_.empty()) return s == state(complex_.some_region(v)) ? Fate::in_region : Fate::kept;
  if (around_.size() > 1 || s != state(around_[0])) return Fate::kept;
  vertex_host_[v] = around_[0];
  return Fate::in_face;
}

// Two kept edges are one: all faces run along both, and both are pieces of one line or curve.
bool Merging::continues(VertexId v, EdgeId a, EdgeId b) {
  if (fate(a) == Fate::hidden || fate(b) == Fate::hidden) return false;
  std::size_t at_a = 0, at_b = 0;
  for (Use u = first_use(b); u != end_use(b); ++u) at_b += remains(u);
  for (Use u = first_use(a); u != end_use(a); ++u) {
    if (!remains(u)) continue;
    ++at_a;
    if (use(across(u, v)).half_edge.edge() != b) return false;
  }
  if (at_a != at_b) return false;
  return straight(complex_, v, a, b) || (mode_ != SimplifyMode::points && one_curve(complex_, v, a, b));
}

}  // namespace cnrg
