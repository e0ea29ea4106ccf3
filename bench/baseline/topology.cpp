// What concerns whole structures: assembling them from polygons, turning them inside out, checking them.
#include "bench/baseline/topology.h"

#include <numeric>
#include <unordered_map>
#include <utility>

namespace cnrg::bench::mantyla {

std::vector<VertexId> Topology::assemble(const std::vector<std::vector<std::vector<std::uint32_t>>>& faces,
                                         std::size_t corners, std::uint32_t first_surface, std::uint32_t solid) {
  std::vector<VertexId> vertices(corners, kNo<VertexId>);
  std::vector<std::size_t> degrees(corners, 0);
  std::unordered_map<std::uint64_t, HalfEdgeId> by_ends;
  const auto key = [](std::uint64_t a, std::uint64_t b) { return a << 32 | b; };
  std::vector<std::pair<std::uint64_t, HalfEdgeId>> made;  // in order, so that edges are numbered alike each time
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    require(!faces[f].empty(), "a face without loops");
    const FaceId face = faces_.add({{}, first_surface + f, solid});
    for (const auto& polygon : faces[f]) {
      require(polygon.size() >= 3, "a loop of less than three corners");
      const LoopId loop = loops_.add({face, kNo<HalfEdgeId>});
      faces_[face].loops.push_back(loop);
      std::vector<HalfEdgeId> around;
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const std::uint32_t a = polygon[k], b = polygon[(k + 1) % polygon.size()];
        require(a < corners && b < corners, "a corner that is no point");
        require(a != b, "an edge from a point to itself");
        if (vertices[a] == kNo<VertexId>) vertices[a] = vertices_.add({});
        const HalfEdgeId h = half_edges_.add({vertices[a], kNo<EdgeId>, loop, kNo<HalfEdgeId>, kNo<HalfEdgeId>});
        vertices_[vertices[a]].out = h;
        ++degrees[a];
        require(by_ends.emplace(key(a, b), h).second, "an edge with more than two faces, or turned ones");
        made.push_back({key(a, b), h});
        around.push_back(h);
      }
      for (std::size_t k = 0; k < around.size(); ++k) link(around[k], around[(k + 1) % around.size()]);
      loops_[loop].start = around.front();
    }
  }
  for (const auto& [ends, h] : made) {
    const auto other = by_ends.find(ends << 32 | ends >> 32);
    require(other != by_ends.end(), "an edge with one face: the surface is open");
    if (edge(h) != kNo<EdgeId>) continue;
    const EdgeId edge = edges_.add({h, other->second});
    half_edges_[h].edge = half_edges_[other->second].edge = edge;
  }
  for (std::size_t c = 0; c < corners; ++c)
    require(vertices[c] == kNo<VertexId> || star(vertices[c]).size() == degrees[c],
            "a vertex where parts of the surface touch");
  return vertices;
}

void Topology::revert(std::uint32_t solid) {
  for (std::size_t l = 0; l < loops_.size(); ++l) {
    const auto loop = static_cast<LoopId>(l);
    if (!alive(loop) || face(loop).solid != solid) continue;
    const std::vector<HalfEdgeId> all = cycle(loop);
    std::vector<VertexId> ends;
    for (const HalfEdgeId h : all) ends.push_back(target(h));
    for (std::size_t k = 0; k < all.size(); ++k) {
      HalfEdge& h = half_edges_[all[k]];
      std::swap(h.next, h.prev);
      h.vertex = ends[k];
      vertices_[ends[k]].out = all[k];
    }
  }
}

std::vector<std::uint32_t> Topology::shells() const {
  std::vector<std::uint32_t> parent(faces_.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::uint32_t f) {
    while (parent[f] != f) f = parent[f] = parent[parent[f]];
    return f;
  };
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto id = static_cast<EdgeId>(e);
    if (!alive(id)) continue;
    const auto a = root(static_cast<std::uint32_t>(face(edges_[id].first)));
    const auto b = root(static_cast<std::uint32_t>(face(edges_[id].second)));
    parent[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::uint32_t> shells(faces_.size(), 0xffffffffu);
  std::uint32_t count = 0;
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    if (!alive(static_cast<FaceId>(f))) continue;
    const std::uint32_t r = root(f);
    shells[f] = r == f ? count++ : shells[r];
  }
  return shells;
}

EulerCounts Topology::validate() const {
  std::size_t seen = 0, all = 0;
  EulerCounts counts;
  const std::vector<std::uint32_t> shell_of = shells();
  for (const std::uint32_t s : shell_of)
    if (s != 0xffffffffu) counts.shells = std::max<std::size_t>(counts.shells, s + 1);
  std::vector<long> characteristic(counts.shells, 0);
  const auto shell = [&](HalfEdgeId h) -> long& {
    return characteristic[shell_of[static_cast<std::size_t>(face(h))]];
  };

  for (std::size_t k = 0; k < half_edges_.size(); ++k) {
    const auto h = static_cast<HalfEdgeId>(k);
    if (!alive(h)) continue;
    ++all;
    require(alive(next(h)) && prev(next(h)) == h && next(prev(h)) == h, "next and prev disagree");
    require(loop(next(h)) == loop(h) && alive(loop(h)), "a half-edge outside of its loop");
    require(alive(origin(h)), "a half-edge of a killed vertex");
    if (lone(h)) {
      require(next(h) == h && vertex(origin(h)).out == h, "a half-edge without an edge");
      continue;
    }
    require(alive(edge(h)) && mate(mate(h)) == h && mate(h) != h && origin(mate(h)) == target(h),
            "the halves of an edge disagree");
  }
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const auto id = static_cast<FaceId>(f);
    if (!alive(id)) continue;
    ++counts.faces;
    counts.rings += face(id).loops.size() - 1;
    characteristic[shell_of[f]] += 2 - static_cast<long>(face(id).loops.size());
    for (const LoopId l : face(id).loops) {
      require(loops_[l].face == id && loop(loops_[l].start) == l, "a loop of another face");
      seen += cycle(l).size();
    }
  }
  require(seen == all, "half-edges that no loop reaches");
  seen = 0;
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    const auto id = static_cast<VertexId>(v);
    if (!alive(id)) continue;
    ++counts.vertices;
    require(alive(vertex(id).out) && origin(vertex(id).out) == id, "a vertex without its half-edge");
    ++shell(vertex(id).out);
    for (const HalfEdgeId h : star(id)) {
      require(origin(h) == id, "a half-edge of another vertex");
      ++seen;
    }
  }
  require(seen == all, "half-edges that no vertex reaches");
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto id = static_cast<EdgeId>(e);
    if (!alive(id)) continue;
    ++counts.edges;
    require(edge(edges_[id].first) == id && edge(edges_[id].second) == id, "an edge without its halves");
    --shell(edges_[id].first);
  }
  for (const long chi : characteristic) {
    require(chi <= 2 && chi % 2 == 0, "the Euler-Poincare formula gives no whole genus");
    counts.genus += (2 - chi) / 2;
  }
  return counts;
}

}  // namespace cnrg::bench::mantyla
