// Merging decides, this file writes down: regions, faces with their walks, chains of edges, vertices, shells, and
// the map from cells of the complex.
//
// First each cell of the result is numbered, by its smallest cell; then all are filled in by themselves, on all
// threads.
//
// Walks: a remaining face along a kept edge is one step; the next one is found by turning around the head of the
// step inside the merged face (Merging::across). Each step belongs to one walk, a slit has two. Walks begin at
// their smallest use, and are in the order of these. Nearly all faces are one face of the complex with one loop of
// kept edges: that is the walk.
#include "kernel/selection/simplify.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <numeric>

#include "kernel/base/parallel.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/predicates.h"
#include "kernel/selection/merging.h"

namespace cnrg {
namespace {

using Fate = Merging::Fate;
using Use = Merging::Use;
constexpr std::uint32_t kNowhere = SimplifiedComplex::kNowhere;

// Disjoint sets that several threads join at the same time. A parent is smaller than its children, so no cycle can
// come about, and the smallest member of a set is its root.
class SharedSets {
 public:
  explicit SharedSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t find(std::uint32_t x) {
    for (;;) {
      const std::uint32_t up = at(x).load(std::memory_order_relaxed);
      if (up == x) return x;
      const std::uint32_t above = at(up).load(std::memory_order_relaxed);
      if (above == up) return up;
      at(x).store(above, std::memory_order_relaxed);
      x = above;
    }
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    for (;;) {
      a = find(a), b = find(b);
      if (a == b) return;
      if (a < b) std::swap(a, b);
      std::uint32_t root = a;
      if (at(a).compare_exchange_strong(root, b, std::memory_order_relaxed)) return;
    }
  }

 private:
  std::atomic_ref<std::uint32_t> at(std::uint32_t x) { return std::atomic_ref(parent_[x]); }
  std::vector<std::uint32_t> parent_;
};

class Assembly {
 public:
  Assembly(const Complex& complex, Merging& merging) : complex_(complex), merging_(merging) {}

  SimplifiedComplex run() {
    tbb::parallel_invoke([&] { number_faces(); }, [&] { number_edges(); },
                         [&] {
                           number_vertices();
                           merging_.merge_inactive_regions();
                         });
    list_regions();
    fill_faces();
    for_each_of(out_.edges, [&](SimplifiedComplex::Edge& edge) { fill_edge(edge); });
    isolate_vertices();
    tbb::parallel_invoke([&] { list_shells(); }, [&] { place_the_rest(); }, [&] { list_facet_edges(); });
    return std::move(out_);
  }

 private:
  using Place = SimplifiedComplex::Place;
  using Face = SimplifiedComplex::Face;
  using Edge = SimplifiedComplex::Edge;

  static std::uint32_t size_of(const auto& list) { return static_cast<std::uint32_t>(list.size()); }

  void number_faces() {
    out_.face_place.assign(complex_.face_count(), Place{3, kNowhere});
    std::uint32_t count = 0;
    for (FaceId f : merging_.domain().faces) {
      if (merging_.fate(f) == Fate::kept && merging_.face(f).first == f) out_.face_place[f.index()] = {2, count++};
    }
    out_.faces.resize(count);
    for (FaceId f : merging_.domain().faces) {
      if (merging_.fate(f) != Fate::kept) continue;
      const auto [root, flip] = merging_.face(f);
      const Place place = out_.face_place[f.index()] = out_.face_place[root.index()];
      out_.faces[place.index].cells.push_back(HalfFace(f, flip ? 1 : 0));
    }
  }

  void number_edges() {
    out_.edge_place.assign(complex_.edge_count(), Place{3, kNowhere});
    std::uint32_t count = 0;
    for (EdgeId e : merging_.domain().edges) {
      if (merging_.fate(e) != Fate::kept) continue;
      const EdgeId first = merging_.chain(e);
      Place& place = out_.edge_place[e.index()];
      place = first == e ? Place{1, count++} : out_.edge_place[first.index()];
    }
    out_.edges.resize(count);
    for (EdgeId e : merging_.domain().edges) {
      const Place place = out_.edge_place[e.index()];
      if (place.dimension == 1 && out_.edges[place.index].chain.empty()) {
        out_.edges[place.index].chain.push_back(HalfEdge(e, 0));
      }
    }
  }

  void number_vertices() {
    out_.vertex_place.assign(complex_.points.size(), Place{3, kNowhere});
    for (VertexId v : merging_.domain().vertices) {
      if (merging_.fate(v) != Fate::kept) continue;
      out_.vertex_place[v.index()] = {0, size_of(out_.vertices)};
      out_.vertices.push_back({v, merging_.state(v)});
    }
  }

  // Regions that are active, or next to a cell that is kept.
  void list_regions() {
    Marks<RegionId> near(complex_.region_count);
    for_each_of(merging_.domain().faces, [&](FaceId f) {
      if (merging_.fate(f) != Fate::kept) return;
      for (RegionId r : complex_.face_regions[f]) near.set(r, 1);
    });
    for_each_of(merging_.domain().edges, [&](EdgeId e) {
      if (merging_.fate(e) == Fate::kept) near.set(complex_.some_region(e), 1);
    });
    for_each_of(out_.vertices,
                [&](const SimplifiedComplex::Vertex& vertex) { near.set(complex_.some_region(vertex.cell), 1); });
    for (RegionId r : near.ids()) near[merging_.region(r)] = 1;
    out_.region_place.assign(complex_.region_count, Place{3, kNowhere});
    for (RegionId r : IdRange<RegionId>(complex_.region_count)) {
      const RegionId root = merging_.region(r);
      if (complex_.outside_frame(r) || !(near.get(root) || merging_.state(root) != 0)) continue;
      Place& place = out_.region_place[root.index()];
      if (place.index == kNowhere) {
        place.index = size_of(out_.regions);
        out_.regions.emplace_back();
        out_.regions.back().component = merging_.state(root);
      }
      out_.region_place[r.index()] = place;
      SimplifiedComplex::Region& region = out_.regions[place.index];
      region.cells.push_back(r);
      region.bounded = region.bounded && !complex_.unbounded(r);
    }
  }
  std::uint32_t place_of(RegionId r) const { return out_.region_place[r.index()].index; }

  void fill_faces() {
    for_each_of(out_.faces, [&](Face& face) {
      const HalfFace h = face.cells.front();
      face.component = merging_.state(h.face());
      face.regions = {place_of(complex_.region(h)), place_of(complex_.region(h.opposite()))};
      if (!take_loop(face)) walk_loops(face);
    });
  }

  // The one loop of a face that merged with no other, from its smallest edge. False if there is more to walk, or
  // the smallest edge is in a slit, so that its two uses have to be told apart.
  bool take_loop(Face& face) const {
    if (face.cells.size() > 1) return false;
    const auto loops = complex_.face_loops[face.cells.front().face()];
    if (loops.size() > 1) return false;
    const auto loop = complex_.loop[loops.front()];
    const auto walkable = [&](HalfEdge h) { return merging_.walkable(h.edge()); };
    if (!std::all_of(loop.begin(), loop.end(), walkable)) return false;
    const auto first = std::min_element(loop.begin(), loop.end());
    if (std::find(loop.begin(), loop.end(), first->twin()) != loop.end()) return false;  // which use is smaller?
    face.loops.push_back({first, loop.end()}, {loop.begin(), first});
    return true;
  }

  void walk_loops(Face& face) {
    std::vector<Use> uses, along;  // those of walkable edges
    for (HalfFace cell : face.cells) {
      for (LoopId l : complex_.face_loops[cell.face()]) {
        merging_.uses_along(cell.face(), l, along);
        for (Use u : along) {
          if (merging_.walkable(merging_.use(u).half_edge.edge())) uses.push_back(u);
        }
      }
    }
    std::sort(uses.begin(), uses.end());
    std::vector<char> walked(uses.size(), 0);
    const auto walked_at = [&](Use u) -> char& {
      return walked[static_cast<std::size_t>(std::lower_bound(uses.begin(), uses.end(), u) - uses.begin())];
    };
    std::vector<std::vector<HalfEdge>> loops;
    for (std::size_t i = 0; i < uses.size(); ++i) {
      if (walked[i]) continue;
      loops.emplace_back();
      for (Use u = uses[i]; !walked_at(u);) {
        walked_at(u) = 1;
        const auto& [f, h] = merging_.use(u);
        const HalfEdge step = merging_.face(f).second ? h.twin() : h;
        loops.back().push_back(step);
        u = merging_.across(u, complex_.target(step));
      }
    }
    put_outer_loop_first(loops);
    for (const auto& loop : loops) face.loops.push_back(loop);
  }

  // The outer loop of a planar face is the one with the lexicographically smallest vertex.
  void put_outer_loop_first(std::vector<std::vector<HalfEdge>>& loops) const {
    if (loops.size() < 2) return;
    std::size_t outer = 0;
    VertexId smallest = complex_.origin(loops[0][0]);
    for (std::size_t i = 0; i < loops.size(); ++i) {
      for (HalfEdge h : loops[i]) {
        const VertexId v = complex_.origin(h);
        if (v != smallest && compare_lex(complex_.points, v, smallest) < 0) {
          smallest = v;
          outer = i;
        }
      }
    }
    std::rotate(loops.begin(), loops.begin() + outer, loops.begin() + outer + 1);
  }

  EdgeId continuation(EdgeId e, VertexId v) const {
    for (EdgeId other : complex_.vertex_edges[v]) {
      if (other != e && merging_.walkable(other)) return other;
    }
    return EdgeId::none();
  }

  // Follows the curve from h until a vertex that is kept, or back to h.
  ShortList<HalfEdge, 2> follow(HalfEdge h) const {
    ShortList<HalfEdge, 2> chain{h};
    for (;;) {
      const VertexId v = complex_.target(chain.back());
      if (merging_.fate(v) != Fate::in_edge) return chain;
      const EdgeId e = continuation(chain.back().edge(), v);
      if (e == h.edge()) return chain;
      chain.push_back(HalfEdge(e, complex_.edge_ends[e][0] == v ? 0 : 1));
    }
  }

  // From the smallest edge, in its direction; it is in the chain already.
  void fill_edge(Edge& edge) {
    const HalfEdge first = edge.chain.front();
    const Place place = out_.edge_place[first.edge().index()];
    edge.component = merging_.state(first.edge());
    edge.chain = follow(first);
    const VertexId tail = complex_.origin(first);
    if (merging_.fate(tail) == Fate::in_edge) {
      if (complex_.target(edge.chain.back()) == tail) {
        edge.closed = true;
      } else {
        const ShortList<HalfEdge, 2> back = follow(first.twin());
        ShortList<HalfEdge, 2> chain;
        for (std::size_t i = back.size(); i-- > 1;) chain.push_back(back[i].twin());
        chain.append(edge.chain.begin(), edge.chain.end());
        edge.chain = std::move(chain);
      }
    }
    for (HalfEdge h : edge.chain) {
      const VertexId v = complex_.target(h);
      if (merging_.fate(v) == Fate::in_edge) out_.vertex_place[v.index()] = place;
    }
  }

  // A vertex isolated in a face of the result was isolated in a face of the complex, or edges around it vanished.
  void isolate_vertices() {
    std::vector<VertexId> vertices;
    for (EdgeId e : merging_.inner_edges()) {
      vertices.insert(vertices.end(), complex_.edge_ends[e].begin(), complex_.edge_ends[e].end());
    }
    const std::vector<VertexId>& isolated = complex_.face_vertices.values();
    vertices.insert(vertices.end(), isolated.begin(), isolated.end());
    sort_unique(vertices);
    std::vector<FaceId> faces;
    for (VertexId v : vertices) {
      if (merging_.fate(v) != Fate::kept) continue;
      merging_.isolating_faces(v, faces);
      faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
      for (FaceId f : faces) out_.faces[out_.face_place[f.index()].index].isolated.push_back(v);
    }
  }

  // Sides of faces that see each other over a kept edge belong to one shell: around the edge, the side that looks
  // counter-clockwise from one use and the side that looks clockwise from the next one.
  void list_shells() {
    SharedSets sides(out_.faces.size() * 2);
    const auto counter_clockwise = [&](Use u) {  // the other one is `^ 1`
      const auto& [f, h] = merging_.use(u);
      const unsigned flip = merging_.face(f).second ? 1 : 0;
      return out_.face_place[f.index()].index * 2 + (h.direction() ^ flip);
    };
    for_each_of(merging_.domain().edges, [&](EdgeId e) {
      if (merging_.fate(e) != Fate::kept) return;
      std::uint32_t first = kNowhere, before = kNowhere;
      for (Use u = merging_.first_use(e); u != merging_.end_use(e); ++u) {
        if (!merging_.remains(u)) continue;
        const std::uint32_t side = counter_clockwise(u);
        if (first == kNowhere) first = side;
        else sides.unite(before, side ^ 1);
        before = side;
      }
      if (first != kNowhere) sides.unite(before, first ^ 1);
    });
    std::vector<std::uint32_t> shell(out_.faces.size() * 2, kNowhere);
    for (std::uint32_t code = 0; code < shell.size(); ++code) {
      const std::uint32_t region = out_.faces[code / 2].regions[code & 1];
      if (region == kNowhere) continue;
      auto& shells = out_.regions[region].shells;
      std::uint32_t& number = shell[sides.find(code)];
      if (number == kNowhere) {
        number = size_of(shells);
        shells.emplace_back();
      }
      shells[number].push_back(code);
    }
  }

  void list_facet_edges() {
    if (complex_.surface_count == 0) return;  // no face has facets
    for (const EdgeId e : merging_.inner_edges()) {
      if (merging_.between_coplanar_facets(e)) out_.facet_edges.push_back(e);
    }
  }

  void place_the_rest() {
    for_each_index(complex_.face_count(), [&](std::size_t i) {
      const FaceId f(i);
      if (merging_.fate(f) == Fate::in_region) out_.face_place[i] = region_place(complex_.some_region(f));
    });
    for_each_index(complex_.edge_count(), [&](std::size_t i) {
      const EdgeId e(i);
      if (merging_.fate(e) == Fate::in_region) out_.edge_place[i] = region_place(complex_.some_region(e));
    });
    for (EdgeId e : merging_.inner_edges()) {
      for (const FaceUse& use : complex_.edge_uses[e]) {
        if (merging_.fate(use.face) == Fate::kept) out_.edge_place[e.index()] = out_.face_place[use.face.index()];
      }
    }
    for_each_of(complex_.vertices, [&](VertexId v) {
      Place& place = out_.vertex_place[v.index()];
      if (merging_.fate(v) == Fate::in_region) {
        place = region_place(complex_.some_region(v));
      } else if (merging_.fate(v) == Fate::in_face) {
        place = out_.face_place[merging_.host(v).index()];
      }
    });
  }
  Place region_place(RegionId r) const { return out_.region_place[r.index()]; }

  const Complex& complex_;
  Merging& merging_;
  SimplifiedComplex out_;
};

}  // namespace

SimplifiedComplex::Place SimplifiedComplex::place(const Complex& complex, const Location& at) const {
  switch (at.dimension) {
    case 0: return vertex_place[at.vertex.index()];
    case 1: return edge_place[at.edge.index()];
    case 2: return face_place[at.face.index()];
    default: break;
  }
  if (complex.outside_frame(at.region)) return {3, kNowhere};
  return region_place[at.region.index()];
}

SimplifiedComplex simplify(const Complex& complex, const Selection& selection, const Features& features,
                           SimplifyMode mode, const CellSources* sources) {
  Merging merging(complex, selection, features, mode, sources);
  return Assembly(complex, merging).run();
}

std::string cell_name(int dimension, std::uint32_t index) {
  return index == kNowhere ? "-" : std::string(1, "vefr"[dimension]) + std::to_string(index);
}

Component component_of(const SimplifiedComplex& simplified, const SimplifiedComplex::Place& place) {
  if (place.index == kNowhere) return 0;
  switch (place.dimension) {
    case 0: return simplified.vertices[place.index].component;
    case 1: return simplified.edges[place.index].component;
    case 2: return simplified.faces[place.index].component;
    default: return simplified.regions[place.index].component;
  }
}

std::array<std::size_t, 4> active_counts(const SimplifiedComplex& simplified) {
  const auto count = [](const auto& cells) {
    return static_cast<std::size_t>(
        std::count_if(cells.begin(), cells.end(), [](const auto& cell) { return cell.component != 0; }));
  };
  return {count(simplified.vertices), count(simplified.edges), count(simplified.faces), count(simplified.regions)};
}

std::array<std::size_t, 4> simplified_counts(const Complex& complex, const Selection& selection,
                                             const Features& features, SimplifyMode mode,
                                             const CellSources* sources) {
  Merging merging(complex, selection, features, mode, sources);
  std::array<std::size_t, 4> out{};
  for (VertexId v : merging.domain().vertices) {
    out[0] += merging.fate(v) == Fate::kept && merging.state(v) != 0;
  }
  for (EdgeId e : merging.domain().edges) {
    out[1] += merging.fate(e) == Fate::kept && merging.state(e) != 0 && merging.chain(e) == e;
  }
  for (FaceId f : merging.domain().faces) {
    out[2] += merging.fate(f) == Fate::kept && merging.state(f) != 0 && merging.face(f).first == f;
  }
  for (RegionId r : merging.domain().regions) {
    out[3] += merging.state(r) != 0 && !complex.outside_frame(r) && merging.region(r) == r;
  }
  return out;
}

}  // namespace cnrg
