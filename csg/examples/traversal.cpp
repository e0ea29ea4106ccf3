// Walks over a complex from use to use: around an edge, around a vertex, over the skins of regions.
//
// Two sides of a face see each edge of it, so the face makes two uses of the edge (Weiler 1986). From a use there
// are three steps: to its mate on the other side of the face, over the wedge to the next use about the edge, and
// on along the loop. Every walk is made of these.
#include <cnrg.h>

#include <algorithm>
#include <iostream>
#include <set>

using namespace cnrg;

/// The use of an edge by one side of a face; from the front the face is to the left of the half-edge.
struct EdgeUse {
  FaceId face;
  unsigned side = 0;
  HalfEdge edge;
  friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

struct Model {
  std::vector<std::string> names;  // of the leaves
  std::shared_ptr<const Complex> complex;
};

/// Steps from use to use.
class Walker {
 public:
  explicit Walker(const Complex& complex) : complex_(complex) {}
  EdgeUse mate(const EdgeUse& u) const { return {u.face, 1 - u.side, u.edge}; }
  /// The other use that looks into the same wedge.
  EdgeUse radial(const EdgeUse& u) const {
    const std::span<const FaceUse> uses = complex_.edge_uses[u.edge.edge()];
    const auto at = std::find(uses.begin(), uses.end(), FaceUse{u.face, u.edge});
    if (at->after().side() == u.side) {
      const FaceUse& following = at + 1 == uses.end() ? uses.front() : at[1];
      return {following.face, following.before().side(), following.half_edge};
    }
    const FaceUse& preceding = at == uses.begin() ? uses.back() : at[-1];
    return {preceding.face, preceding.after().side(), preceding.half_edge};
  }
  EdgeUse next(const EdgeUse& u) const { return along(u, true); }
  EdgeUse previous(const EdgeUse& u) const { return along(u, false); }
  /// About v: to the other edge of the corner that u has there, and over the wedge.
  EdgeUse turn(const EdgeUse& u, VertexId v) const { return radial(leaves(u, v) ? previous(u) : next(u)); }
  /// A corner at v by the use that leaves it.
  EdgeUse corner(const EdgeUse& u, VertexId v) const { return leaves(u, v) ? u : next(u); }

  std::vector<EdgeUse> uses() const {
    std::vector<EdgeUse> all;
    for (const EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      for (const FaceUse& use : complex_.edge_uses[e]) {
        for (const unsigned side : {0u, 1u}) all.push_back({use.face, side, use.half_edge});
      }
    }
    return all;
  }

 private:
  bool leaves(const EdgeUse& u, VertexId v) const { return complex_.origin(u.edge) == v; }
  EdgeUse along(const EdgeUse& u, bool forward) const {
    for (const LoopId l : complex_.face_loops[u.face]) {
      const std::span<const HalfEdge> loop = complex_.loop[l];
      const auto at = static_cast<std::size_t>(std::find(loop.begin(), loop.end(), u.edge) - loop.begin());
      if (at < loop.size()) return {u.face, u.side, loop[(at + (forward ? 1 : loop.size() - 1)) % loop.size()]};
    }
    throw InvariantError("a half-edge that is in no loop of its face");
  }
  const Complex& complex_;
};

std::string region_name(const Model& model, RegionId r) {
  std::string text;
  for (const Label& label : model.complex->labels(r)) text += model.names[label.leaf.index()];
  return text.empty() ? "outside" : text;
}
std::string region_name(const Model& model, const EdgeUse& u) {
  return region_name(model, model.complex->region(HalfFace(u.face, u.side)));
}

std::string face_name(const Model& model, FaceId f) {
  std::string text;
  for (const Cover& cover : model.complex->cover(f)) {
    text += (text.empty() ? "" : " and ") + model.names[model.complex->sources[cover.source].leaf.index()];
  }
  return text;
}

VertexId vertex_at(const Complex& complex, const RationalPoint& p) {
  return *std::find_if(complex.vertices.begin(), complex.vertices.end(),
                       [&](VertexId v) { return complex.points.rational(v) == p; });
}

/// Mate and radial in turn, until the first use is met again.
void walk_around_edge(const Model& model, EdgeId e) {
  const Walker walker(*model.complex);
  const FaceUse& use = model.complex->edge_uses[e].front();
  const EdgeUse first{use.face, use.before().side(), use.half_edge};
  EdgeUse u = first;
  do {
    std::cout << "  a face of " << face_name(model, u.face) << ", then ";
    u = walker.mate(u);
    std::cout << region_name(model, u) << "\n";
    u = walker.radial(u);
  } while (u != first);
}

/// A walk for each circle in which a region meets the vertex, and one around each wire.
void walk_around_vertex(const Model& model, VertexId v) {
  const Walker walker(*model.complex);
  std::set<EdgeUse> seen;
  for (const EdgeUse& start : walker.uses()) {
    if (model.complex->origin(start.edge) != v || seen.contains(start)) continue;
    std::cout << "  " << region_name(model, start) << ":";
    std::string separator = " past corners of ";
    EdgeUse u = start;
    do {
      seen.insert(walker.corner(u, v));
      std::cout << separator << face_name(model, u.face);
      separator = ", ";
      u = walker.turn(u, v);
    } while (walker.corner(u, v) != start);
    std::cout << "\n";
  }
  for (const EdgeId e : model.complex->vertex_edges[v]) {
    if (!model.complex->edge_uses[e].empty()) continue;
    std::cout << "  " << region_name(model, model.complex->edge_region[e]) << ": around a wire\n";
  }
}

/// Loop and radial from each use that no walk has reached: the sides of faces that see each other.
void walk_over_skins(const Model& model) {
  const Walker walker(*model.complex);
  const std::vector<EdgeUse> uses = walker.uses();
  std::cout << "  " << uses.size() << " uses of edges\n";
  std::set<EdgeUse> seen;
  for (const EdgeUse& start : uses) {
    if (!seen.insert(start).second) continue;
    std::set<HalfFace> skin;
    std::vector<EdgeUse> reached{start};
    while (!reached.empty()) {
      const EdgeUse u = reached.back();
      reached.pop_back();
      skin.insert(HalfFace(u.face, u.side));
      for (const EdgeUse& neighbour : {walker.next(u), walker.radial(u)}) {
        if (seen.insert(neighbour).second) reached.push_back(neighbour);
      }
    }
    std::cout << "  " << region_name(model, start) << ": " << skin.size() << " sides of faces\n";
  }
}

int main() {
  const auto east = prepare(BoxShape{{0, 0, 0}, {1, 1, 1}});
  const auto north = prepare(BoxShape{{-1, 0, 0}, {0, 1, 1}});
  const auto west = prepare(BoxShape{{-1, -1, 0}, {0, 0, 1}});
  const auto sheet = prepare(PolygonShape{{{0, 0, 0}, {1, -1, 0}, {1, -1, 1}, {0, 0, 1}}, {}});
  const Model around{{"east", "north", "west", "sheet"},
                     build_complex(make_soup({{east}, {north}, {west}, {sheet}}))};

  const VertexId bottom = vertex_at(*around.complex, {0, 0, 0}), top = vertex_at(*around.complex, {0, 0, 1});
  for (const EdgeId e : around.complex->vertex_edges[bottom]) {
    if (around.complex->edge_ends[e] != std::array{bottom, top}) continue;
    std::cout << "about the edge from 0 0 0 to 0 0 1\n";
    walk_around_edge(around, e);
  }
  std::cout << "skins\n";
  walk_over_skins(around);

  const auto far = prepare(BoxShape{{1, 1, 1}, {2, 2, 2}});
  const auto flap = prepare(PolygonShape{{{1, 1, 1}, {0, 2, 1}, {0, 2, 2}}, {}});
  const auto bar = prepare(PolylineShape{{{1, 1, 1}, {2, 0, 1}}, false});
  const Model corner{{"east", "far", "flap", "bar"}, build_complex(make_soup({{east}, {far}, {flap}, {bar}}))};
  std::cout << "about the vertex 1 1 1\n";
  walk_around_vertex(corner, vertex_at(*corner.complex, {1, 1, 1}));
}

// Output:
// about the edge from 0 0 0 to 0 0 1
//   a face of east and north, then north
//   a face of north and west, then west
//   a face of west, then outside
//   a face of sheet, then outside
//   a face of east, then east
// skins
//   136 uses of edges
//   outside: 16 sides of faces
//   east: 6 sides of faces
//   north: 6 sides of faces
//   west: 6 sides of faces
// about the vertex 1 1 1
//   outside: past corners of east, east, east
//   east: past corners of east, east, east
//   far: past corners of far, far, far
//   outside: past corners of far, far, far
//   outside: past corners of flap, flap
//   outside: around a wire
