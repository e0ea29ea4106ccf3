// Euler operators. Each comes with its inverse; what a killed edge leaves without edges gets a half-edge of its
// own.
#include <algorithm>
#include <utility>

#include "bench/baseline/topology.h"

namespace cnrg::bench::mantyla {

HalfEdgeId Topology::mate(HalfEdgeId half_edge) const {
  const Edge& edge = edges_[half_edges_[half_edge].edge];
  return edge.first == half_edge ? edge.second : edge.first;
}

std::vector<HalfEdgeId> Topology::star(VertexId vertex) const {
  const HalfEdgeId start = vertices_[vertex].out;
  std::vector<HalfEdgeId> all = {start};
  if (lone(start)) return all;
  for (HalfEdgeId h = around(start); h != start; h = around(h)) {
    require(all.size() < half_edges_.size(), "the half-edges of a vertex form no cycle");
    all.push_back(h);
  }
  return all;
}

std::vector<HalfEdgeId> Topology::cycle(LoopId loop) const {
  const HalfEdgeId start = loops_[loop].start;
  std::vector<HalfEdgeId> all = {start};
  for (HalfEdgeId h = next(start); h != start; h = next(h)) {
    require(all.size() < half_edges_.size(), "the half-edges of a loop form no cycle");
    all.push_back(h);
  }
  return all;
}

void Topology::link(HalfEdgeId before, HalfEdgeId after) {
  half_edges_[before].next = after;
  half_edges_[after].prev = before;
}

HalfEdgeId Topology::insert_before(HalfEdgeId where, VertexId vertex, EdgeId edge) {
  const HalfEdgeId h = half_edges_.add({vertex, edge, loop(where), kNo<HalfEdgeId>, kNo<HalfEdgeId>});
  link(prev(where), h);
  link(h, where);
  return h;
}

void Topology::unlink(HalfEdgeId half_edge) {
  Loop& of = loops_[loop(half_edge)];
  if (of.start == half_edge) of.start = next(half_edge);
  link(prev(half_edge), next(half_edge));
  kill(half_edge);
}

void Topology::make_lone(HalfEdgeId half_edge, VertexId vertex, LoopId loop) {
  half_edges_[half_edge] = {vertex, kNo<EdgeId>, loop, half_edge, half_edge};
  vertices_[vertex].out = half_edge;
  loops_[loop].start = half_edge;
}

void Topology::give(HalfEdgeId start, LoopId loop) {
  HalfEdgeId h = start;
  do {
    half_edges_[h].loop = loop;
    h = next(h);
  } while (h != start);
  loops_[loop].start = start;
}

void Topology::drop_loop(LoopId loop) {
  auto& loops = faces_[loops_[loop].face].loops;
  loops.erase(std::find(loops.begin(), loops.end(), loop));
  loops_[loop] = Loop();
}

FaceId Topology::add_face(LoopId outer, const Face& like) {
  const FaceId face = faces_.add({{outer}, like.surface, like.solid});
  loops_[outer].face = face;
  return face;
}

Topology::Seed Topology::mvfs(std::uint32_t surface, std::uint32_t solid) {
  const VertexId vertex = vertices_.add({});
  const LoopId loop = loops_.add({});
  const FaceId face = add_face(loop, Face{{}, surface, solid});
  const HalfEdgeId half_edge = half_edges_.add({});
  make_lone(half_edge, vertex, loop);
  return {vertex, face, half_edge};
}

void Topology::kvfs(FaceId face) {
  require(alive(face) && faces_[face].loops.size() == 1, "kvfs: a face with rings");
  const LoopId loop = faces_[face].loops.front();
  const HalfEdgeId half_edge = loops_[loop].start;
  require(lone(half_edge), "kvfs: the shell has edges");
  vertices_[origin(half_edge)] = Vertex();
  kill(half_edge);
  loops_[loop] = Loop();
  faces_[face] = Face();
}

EdgeId Topology::mev(HalfEdgeId from, HalfEdgeId to) {
  require(alive(from) && alive(to) && origin(from) == origin(to), "mev: half-edges of different vertices");
  const VertexId old_vertex = origin(from);
  std::vector<HalfEdgeId> moved;
  for (HalfEdgeId h = from; h != to; h = around(h)) {
    require(moved.size() < half_edges_.size(), "mev: the half-edges of a vertex form no cycle");
    moved.push_back(h);
  }
  const VertexId new_vertex = vertices_.add({});
  const EdgeId edge = edges_.add({});
  for (const HalfEdgeId h : moved) half_edges_[h].vertex = new_vertex;
  HalfEdgeId out = from, back;
  if (lone(from)) {
    back = half_edges_.add({new_vertex, edge, loop(from), from, from});
    half_edges_[from].edge = edge;
    link(from, back);
    link(back, from);
  } else {
    out = insert_before(from, old_vertex, edge);
    back = insert_before(to, new_vertex, edge);
  }
  edges_[edge] = {back, out};
  vertices_[old_vertex].out = out;
  vertices_[new_vertex].out = back;
  return edge;
}

void Topology::kev(HalfEdgeId half_edge) {
  require(alive(half_edge) && !lone(half_edge), "kev: no edge");
  const HalfEdgeId other = mate(half_edge);
  const VertexId dead = origin(half_edge), kept = origin(other);
  require(dead != kept, "kev: an edge from a vertex to itself");
  for (const HalfEdgeId h : star(dead)) half_edges_[h].vertex = kept;
  edges_[edge(half_edge)] = Edge();
  vertices_[dead] = Vertex();
  if (next(half_edge) == other && next(other) == half_edge) {
    make_lone(other, kept, loop(other));
    kill(half_edge);
    return;
  }
  vertices_[kept].out = next(half_edge) == other ? next(other) : next(half_edge);
  unlink(half_edge);
  unlink(other);
}

EdgeId Topology::mef(HalfEdgeId from, HalfEdgeId to) {
  require(alive(from) && alive(to) && loop(from) == loop(to), "mef: half-edges of different loops");
  const LoopId old_loop = loop(from);
  const EdgeId edge = edges_.add({});
  const LoopId new_loop = loops_.add({});
  const Face like = face(old_loop);
  add_face(new_loop, like);
  const HalfEdgeId first = half_edges_.add({origin(to), edge, new_loop, kNo<HalfEdgeId>, kNo<HalfEdgeId>});
  HalfEdgeId second = from;
  if (from == to) {
    link(first, first);
    loops_[new_loop].start = first;
    if (lone(from)) half_edges_[from].edge = edge;
    else second = insert_before(from, origin(from), edge);
  } else {
    second = half_edges_.add({origin(from), edge, old_loop, kNo<HalfEdgeId>, kNo<HalfEdgeId>});
    const HalfEdgeId before_from = prev(from), before_to = prev(to);
    link(before_to, first);
    link(first, from);
    link(before_from, second);
    link(second, to);
    give(first, new_loop);
    loops_[old_loop].start = second;
  }
  edges_[edge] = {first, second};
  return edge;
}

void Topology::kef(HalfEdgeId half_edge) {
  require(alive(half_edge) && !lone(half_edge), "kef: no edge");
  const HalfEdgeId other = mate(half_edge);
  const FaceId dead = face(half_edge);
  require(dead != face(other), "kef: the same face on both sides");
  require(faces_[dead].loops.size() == 1, "kef: the face has rings");
  const LoopId dead_loop = loop(half_edge), kept_loop = loop(other);
  const VertexId start = origin(half_edge), end = origin(other);
  edges_[edge(half_edge)] = Edge();
  const bool alone = next(half_edge) == half_edge, other_alone = next(other) == other;
  if (alone && other_alone) {
    make_lone(other, end, kept_loop);
    kill(half_edge);
  } else if (alone) {
    vertices_[end].out = next(other);
    unlink(other);
    kill(half_edge);
  } else {
    const HalfEdgeId rest = next(half_edge);
    vertices_[end].out = rest;
    vertices_[start].out = other_alone ? rest : next(other);
    if (other_alone) {
      link(prev(half_edge), rest);
    } else {
      link(prev(half_edge), next(other));
      link(prev(other), rest);
    }
    kill(half_edge);
    kill(other);
    give(rest, kept_loop);
  }
  loops_[dead_loop] = Loop();
  faces_[dead] = Face();
}

LoopId Topology::kemr(HalfEdgeId half_edge) {
  require(alive(half_edge) && !lone(half_edge), "kemr: no edge");
  const HalfEdgeId other = mate(half_edge);
  require(loop(half_edge) == loop(other), "kemr: different loops on the sides");
  const VertexId start = origin(half_edge), end = origin(other);
  require(start != end, "kemr: an edge from a vertex to itself");
  const LoopId old_loop = loop(half_edge);
  const LoopId ring = loops_.add({loops_[old_loop].face, kNo<HalfEdgeId>});
  faces_[loops_[ring].face].loops.push_back(ring);
  edges_[edge(half_edge)] = Edge();
  const HalfEdgeId far = next(half_edge), far_last = prev(other), near = next(other), near_last = prev(half_edge);
  if (far == other) {
    make_lone(other, end, ring);
  } else {
    link(far_last, far);
    kill(other);
    give(far, ring);
    vertices_[end].out = far;
  }
  if (near == half_edge) {
    make_lone(half_edge, start, old_loop);
  } else {
    link(near_last, near);
    kill(half_edge);
    loops_[old_loop].start = near;
    vertices_[start].out = near;
  }
  return ring;
}

EdgeId Topology::mekr(HalfEdgeId from, HalfEdgeId to) {
  require(alive(from) && alive(to) && loop(from) != loop(to), "mekr: one loop");
  require(face(from) == face(to), "mekr: loops of different faces");
  require(origin(from) != origin(to), "mekr: an edge from a vertex to itself");
  const bool to_stays = is_outer(loop(to));
  const LoopId kept = to_stays ? loop(to) : loop(from), dead = to_stays ? loop(from) : loop(to);
  const EdgeId edge = edges_.add({});
  HalfEdgeId first = from, second = to;
  const HalfEdgeId before_from = prev(from), before_to = prev(to);
  const bool lone_from = lone(from), lone_to = lone(to);
  if (!lone_from) first = half_edges_.add({origin(from), edge, kept, kNo<HalfEdgeId>, kNo<HalfEdgeId>});
  if (!lone_to) second = half_edges_.add({origin(to), edge, kept, kNo<HalfEdgeId>, kNo<HalfEdgeId>});
  half_edges_[first].edge = half_edges_[second].edge = edge;
  if (!lone_from) link(before_from, first);
  link(first, lone_to ? second : to);
  if (!lone_to) link(before_to, second);
  link(second, lone_from ? first : from);
  drop_loop(dead);
  give(first, kept);
  edges_[edge] = {first, second};
  return edge;
}

void Topology::kfmrh(FaceId kept, FaceId killed) {
  require(alive(kept) && alive(killed) && kept != killed, "kfmrh: one face");
  require(faces_[killed].loops.size() == 1, "kfmrh: the face has rings");
  const LoopId loop = faces_[killed].loops.front();
  faces_[killed] = Face();
  faces_[kept].loops.push_back(loop);
  loops_[loop].face = kept;
}

FaceId Topology::mfkrh(LoopId ring) {
  require(alive(ring) && !is_outer(ring), "mfkrh: no ring");
  auto& face = faces_[loops_[ring].face];
  face.loops.erase(std::find(face.loops.begin(), face.loops.end(), ring));
  const Face like = face;
  return add_face(ring, like);
}

void Topology::ringmv(LoopId ring, FaceId to) {
  require(alive(ring) && !is_outer(ring) && alive(to), "ringmv: no ring");
  auto& loops = faces_[loops_[ring].face].loops;
  loops.erase(std::find(loops.begin(), loops.end(), ring));
  faces_[to].loops.push_back(ring);
  loops_[ring].face = to;
}

void Topology::flip(EdgeId edge) { std::swap(edges_[edge].first, edges_[edge].second); }

}  // namespace cnrg::bench::mantyla
