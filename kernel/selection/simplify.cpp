// Merging decides, this file writes down: regions, faces with their walks, chains of edges, vertices, shells, and
// the map from cells of the complex.
//
// Walks: a remaining face along a kept edge is one step; the next one is found by turning around the head of the
// step inside the merged face (Merging::across). Each step belongs to one walk, a slit has two.
#include "kernel/selection/simplify.h"

#include <algorithm>

#include "kernel/base/union_find.h"
#include "kernel/selection/merging.h"

namespace cnrg {
namespace {

using Fate = Merging::Fate;
using Use = Merging::Use;
constexpr std::uint32_t kNowhere = SimplifiedComplex::kNowhere;

class Assembly {
 public:
  Assembly(const Complex& complex, Merging& merging) : complex_(complex), merging_(merging) {}

  SimplifiedComplex run() {
    merging_.merge_inactive_regions();
    list_faces();
    list_regions();
    list_vertices();
    list_edges();
    walk_loops();
    list_shells();
    place_the_rest();
    return std::move(out_);
  }

 private:
  using Place = SimplifiedComplex::Place;

  void list_faces() {
    out_.face_place.assign(complex_.face_count(), Place{3, kNowhere});
    for (FaceId f : IdRange<FaceId>(complex_.face_count())) {
      if (merging_.fate(f) != Fate::kept) continue;
      const auto [root, flip] = merging_.face(f);
      if (root == f) {
        out_.face_place[f.index()] = {2, static_cast<std::uint32_t>(out_.faces.size())};
        out_.faces.emplace_back();
        out_.faces.back().component = merging_.state(f);
      }
      const Place place = out_.face_place[root.index()];
      out_.face_place[f.index()] = place;
      out_.faces[place.index].cells.push_back(HalfFace(f, flip ? 1 : 0));
    }
  }

  // Regions that are active, or next to a cell that is kept.
  void list_regions() {
    std::vector<char> listed(complex_.region_count, 0);
    const auto list = [&](RegionId r) { listed[merging_.region(r).index()] = 1; };
    for (const SimplifiedComplex::Face& face : out_.faces) {
      for (HalfFace h : face.cells) {
        list(complex_.region(h));
        list(complex_.region(h.opposite()));
      }
    }
    for (EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      if (merging_.fate(e) == Fate::kept) list(complex_.some_region(e));
    }
    for (VertexId v : complex_.vertices) {
      if (merging_.fate(v) == Fate::kept) list(complex_.some_region(v));
    }
    out_.region_place.assign(complex_.region_count, Place{3, kNowhere});
    for (RegionId r : IdRange<RegionId>(complex_.region_count)) {
      const RegionId root = merging_.region(r);
      if (complex_.outside_frame(r) || !(listed[root.index()] || merging_.state(root) != 0)) continue;
      Place& place = out_.region_place[root.index()];
      if (place.index == kNowhere) {
        place.index = static_cast<std::uint32_t>(out_.regions.size());
        out_.regions.emplace_back();
        out_.regions.back().component = merging_.state(root);
      }
      out_.region_place[r.index()] = place;
      SimplifiedComplex::Region& region = out_.regions[place.index];
      region.cells.push_back(r);
      region.bounded = region.bounded && !complex_.unbounded(r);
    }
    for (SimplifiedComplex::Face& face : out_.faces) {
      const HalfFace h = face.cells.front();
      face.regions = {place_of(complex_.region(h)), place_of(complex_.region(h.opposite()))};
    }
  }
  std::uint32_t place_of(RegionId r) const { return out_.region_place[r.index()].index; }

  void list_vertices() {
    out_.vertex_place.assign(complex_.points.size(), Place{3, kNowhere});
    std::vector<FaceId> faces;
    for (VertexId v : complex_.vertices) {
      if (merging_.fate(v) != Fate::kept) continue;
      out_.vertex_place[v.index()] = {0, static_cast<std::uint32_t>(out_.vertices.size())};
      out_.vertices.push_back({v, merging_.state(v)});
      merging_.isolating_faces(v, faces);
      faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
      for (FaceId f : faces) out_.faces[out_.face_place[f.index()].index].isolated.push_back(v);
    }
  }

  EdgeId continuation(EdgeId e, VertexId v) const {
    for (EdgeId other : complex_.vertex_edges[v]) {
      if (other != e && merging_.walkable(other)) return other;
    }
    return EdgeId::none();
  }

  // Follows the curve from h until a vertex that is kept, or back to h.
  std::vector<HalfEdge> follow(HalfEdge h) const {
    std::vector<HalfEdge> chain{h};
    for (;;) {
      const VertexId v = complex_.target(chain.back());
      if (merging_.fate(v) != Fate::in_edge) return chain;
      const EdgeId e = continuation(chain.back().edge(), v);
      if (e == h.edge()) return chain;
      chain.push_back(HalfEdge(e, complex_.edge_ends[e][0] == v ? 0 : 1));
    }
  }

  void list_edges() {
    out_.edge_place.assign(complex_.edge_count(), Place{3, kNowhere});
    for (EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      if (merging_.fate(e) != Fate::kept || out_.edge_place[e.index()].index != kNowhere) continue;
      SimplifiedComplex::Edge edge;
      edge.component = merging_.state(e);
      edge.chain = follow(HalfEdge(e, 0));
      const VertexId tail = complex_.origin(edge.chain.front());
      if (merging_.fate(tail) == Fate::in_edge) {
        if (complex_.target(edge.chain.back()) == tail) {
          edge.closed = true;
        } else {
          std::vector<HalfEdge> back = follow(HalfEdge(e, 1));
          std::vector<HalfEdge> chain;
          for (std::size_t i = back.size(); i-- > 1;) chain.push_back(back[i].twin());
          chain.insert(chain.end(), edge.chain.begin(), edge.chain.end());
          edge.chain = std::move(chain);
        }
      }
      const Place place{1, static_cast<std::uint32_t>(out_.edges.size())};
      for (HalfEdge h : edge.chain) out_.edge_place[h.edge().index()] = place;
      for (HalfEdge h : edge.chain) {
        const VertexId v = complex_.target(h);
        if (merging_.fate(v) == Fate::in_edge) out_.vertex_place[v.index()] = place;
      }
      out_.edges.push_back(std::move(edge));
    }
  }

  void walk_loops() {
    std::vector<char> walked(complex_.edge_uses.value_count(), 0);
    for (EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      if (!merging_.walkable(e)) continue;
      for (Use u = merging_.first_use(e); u != merging_.end_use(e); ++u) {
        if (walked[u] || !merging_.remains(u)) continue;
        auto& loops = out_.faces[out_.face_place[merging_.use(u).face.index()].index].loops;
        loops.emplace_back();
        for (Use w = u; !walked[w];) {
          walked[w] = 1;
          const auto& [f, h] = merging_.use(w);
          const HalfEdge step = merging_.face(f).second ? h.twin() : h;
          loops.back().push_back(step);
          w = merging_.across(w, complex_.target(step));
        }
      }
    }
    for (SimplifiedComplex::Face& face : out_.faces) put_outer_loop_first(face.loops);
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

  // Sides of faces that see each other over a kept edge belong to one shell: around the edge, the side that looks
  // counter-clockwise from one use and the side that looks clockwise from the next one.
  void list_shells() {
    UnionFind sides(out_.faces.size() * 2);
    const auto side = [&](Use u, bool counter_clockwise) {
      const auto& [f, h] = merging_.use(u);
      const unsigned s = counter_clockwise ? h.direction() : 1 - h.direction();
      const unsigned flip = merging_.face(f).second ? 1 : 0;
      return out_.face_place[f.index()].index * 2 + (s ^ flip);
    };
    std::vector<Use> uses;
    for (EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      if (merging_.fate(e) != Fate::kept) continue;
      uses.clear();
      for (Use u = merging_.first_use(e); u != merging_.end_use(e); ++u) {
        if (merging_.remains(u)) uses.push_back(u);
      }
      for (std::size_t i = 0; i < uses.size(); ++i) {
        sides.unite(side(uses[i], true), side(uses[(i + 1) % uses.size()], false));
      }
    }
    std::vector<std::uint32_t> shell(sides.size(), kNowhere);
    for (std::uint32_t code = 0; code < sides.size(); ++code) {
      const std::uint32_t region = out_.faces[code / 2].regions[code & 1];
      if (region == kNowhere) continue;
      auto& shells = out_.regions[region].shells;
      std::uint32_t& number = shell[sides.find(code)];
      if (number == kNowhere) {
        number = static_cast<std::uint32_t>(shells.size());
        shells.emplace_back();
      }
      shells[number].push_back(code);
    }
  }

  void place_the_rest() {
    for (FaceId f : IdRange<FaceId>(complex_.face_count())) {
      if (merging_.fate(f) != Fate::in_region) continue;
      out_.face_place[f.index()] = out_.region_place[complex_.face_regions[f][0].index()];
    }
    for (EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      Place& place = out_.edge_place[e.index()];
      if (merging_.fate(e) == Fate::in_region) {
        place = out_.region_place[complex_.some_region(e).index()];
      } else if (merging_.fate(e) == Fate::in_face) {
        for (const FaceUse& use : complex_.edge_uses[e]) {
          if (merging_.fate(use.face) == Fate::kept) place = out_.face_place[use.face.index()];
        }
      }
    }
    for (VertexId v : complex_.vertices) {
      Place& place = out_.vertex_place[v.index()];
      if (merging_.fate(v) == Fate::in_region) {
        place = out_.region_place[complex_.some_region(v).index()];
      } else if (merging_.fate(v) == Fate::in_face) {
        place = out_.face_place[merging_.host(v).index()];
      }
    }
  }

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
                           SimplifyMode mode) {
  Merging merging(complex, selection, features, mode);
  return Assembly(complex, merging).run();
}

std::string cell_name(int dimension, std::uint32_t index) {
  return index == kNowhere ? "-" : std::string(1, "vefr"[dimension]) + std::to_string(index);
}

Component component_of(const SimplifiedComplex& simplified, const SimplifiedComplex::Place& place) {
  if (place.index == kNowhere) return 0;
  switch (place.dimension) {
    case 0:
      return simplified.vertices[place.index].component;
    case 1:
      return simplified.edges[place.index].component;
    case 2:
      return simplified.faces[place.index].component;
    default:
      return simplified.regions[place.index].component;
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
                                             const Features& features, SimplifyMode mode) {
  Merging merging(complex, selection, features, mode);
  std::array<std::size_t, 4> out{};
  // A chain is counted at the smallest of its edges, as joined at the vertices inside of it.
  SparseSets<EdgeId> chains(complex.edge_count());
  for (VertexId v : merging.domain().vertices) {
    if (merging.state(v) == 0) continue;
    out[0] += merging.fate(v) == Fate::kept;
    if (merging.fate(v) != Fate::in_edge) continue;
    EdgeId before;
    for (EdgeId e : complex.vertex_edges[v]) {
      if (!merging.walkable(e)) continue;
      if (before.valid()) chains.unite(before, e);
      before = e;
    }
  }
  for (EdgeId e : merging.domain().edges) {
    out[1] += merging.fate(e) == Fate::kept && merging.state(e) != 0 && chains.find(e) == e;
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
