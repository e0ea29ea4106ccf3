// Walls are read off the simplified complex: a face with two regions, of which one at least is active.
#include "csg/topology/manufacturable.h"

#include <algorithm>
#include <map>

#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

using Place = SimplifiedComplex::Place;

/// Which simplified edges and vertices are in the closure of some faces.
class Closure {
 public:
  explicit Closure(const SimplifiedComplex& s) : edges(s.edges.size(), 0), vertices(s.vertices.size(), 0), s_(s) {}

  std::vector<char> edges, vertices;  // by number

  void add(const Complex& complex, const SimplifiedComplex::Face& face) {
    for (const auto& loop : face.loops) {
      for (const HalfEdge h : loop) {
        mark(s_.edge_place[h.edge().index()]);
        mark(s_.vertex_place[complex.origin(h).index()]);
      }
    }
    for (const VertexId v : face.isolated) mark(s_.vertex_place[v.index()]);
  }
  void add(const Complex& complex, const SimplifiedComplex::Edge& edge) {
    for (const HalfEdge h : edge.chain) {
      mark(s_.vertex_place[complex.origin(h).index()]);
      mark(s_.vertex_place[complex.target(h).index()]);
    }
  }

 private:
  void mark(const Place& place) {
    if (place.index == SimplifiedComplex::kNowhere) return;
    if (place.dimension == 1) edges[place.index] = 1;
    if (place.dimension == 0) vertices[place.index] = 1;
  }
  const SimplifiedComplex& s_;
};

bool is_wall(const SimplifiedComplex& s, const SimplifiedComplex::Face& face) {
  const auto active = [&](std::uint32_t region) {
    return region != SimplifiedComplex::kNowhere && s.regions[region].component != 0;
  };
  return face.regions[0] != face.regions[1] && (active(face.regions[0]) || active(face.regions[1]));
}

void add_thin(const Complex& complex, const SimplifiedComplex& s, Manufacturability& out) {
  Closure walls(s), thin(s);
  for (std::uint32_t i = 0; i < s.faces.size(); ++i) {
    const auto& face = s.faces[i];
    if (is_wall(s, face)) {
      walls.add(complex, face);
    } else if (face.component != 0) {
      thin.add(complex, face);
      out.dangling_faces.push_back(cell_name(2, i));
    }
  }
  for (std::uint32_t i = 0; i < s.edges.size(); ++i) {
    if (s.edges[i].component == 0 || walls.edges[i]) continue;
    if (!thin.edges[i]) out.wires.push_back(cell_name(1, i));
    thin.add(complex, s.edges[i]);
  }
  for (std::uint32_t i = 0; i < s.vertices.size(); ++i) {
    if (s.vertices[i].component != 0 && !walls.vertices[i] && !thin.vertices[i])
      out.loose_points.push_back(cell_name(0, i));
  }
}

void add_touches(const Complex& complex, const SimplifiedComplex& s, Component component, const CellSet& solid,
                 Neighbourhoods& neighbourhoods, Manufacturability& out) {
  const Manifoldness m = manifoldness(complex, solid, neighbourhoods);
  if (m.manifold()) return;
  std::map<std::pair<int, std::string>, std::vector<std::string>> found;  // edges first
  const auto look = [&](const auto& shapes, auto cell, int order, const std::string& name) {
    const LocalShape* const shape = value_of_key(shapes, cell);
    if (shape != nullptr && !shape->reason.empty()) found[{order, shape->reason}].push_back(name);
  };
  for (std::uint32_t i = 0; i < s.edges.size(); ++i)
    look(m.edges, s.edges[i].chain.front().edge(), -1, cell_name(1, i));
  for (std::uint32_t i = 0; i < s.vertices.size(); ++i) look(m.vertices, s.vertices[i].cell, 0, cell_name(0, i));
  for (auto& [key, cells] : found) out.touches.push_back({component, key.second, std::move(cells)});
}

}  // namespace

bool Manufacturability::yes() const {
  return solids > 0 && dangling_faces.empty() && wires.empty() && loose_points.empty() && touches.empty() &&
         unbounded.empty();
}

Manufacturability manufacturability(const Complex& complex, const Selection& selection,
                                    const SimplifiedComplex& simplified, Neighbourhoods& neighbourhoods) {
  Manufacturability out;
  add_thin(complex, simplified, out);
  std::map<Component, CellSet> solids;
  for (const auto& [region, component] : selection.regions) solids[component].regions.push_back(region);
  out.solids = solids.size();
  for (const auto& [component, solid] : solids) {
    if (std::any_of(solid.regions.begin(), solid.regions.end(), [&](RegionId r) { return complex.unbounded(r); }))
      out.unbounded.push_back(component);
    add_touches(complex, simplified, component, solid, neighbourhoods, out);
  }
  return out;
}

}  // namespace cnrg
