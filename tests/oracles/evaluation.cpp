#include "tests/oracles/evaluation.h"

#include <algorithm>
#include <map>

#include "csg/operators/component_lists.h"
#include "csg/operators/detect_regions.h"
#include "tests/scenes/measure.h"

namespace cnrg::properties {
namespace {

using Place = SimplifiedComplex::Place;

/// Ends of the simplified vertices along a walk, in its order; vertices that were merged away are passed over.
std::vector<VertexId> corners(const Complex& c, const SimplifiedComplex& s, std::span<const HalfEdge> walk) {
  std::vector<VertexId> result;
  for (const HalfEdge h : walk)
    if (s.vertex_place[c.origin(h).index()].dimension == 0) result.push_back(c.origin(h));
  return result;
}

bool front_is_up(const Complex& c, HalfFace front) {
  const ExactPlane& plane = c.points.exact_plane(c.plane(front.face()));
  const int x = sgn(plane.a), y = sgn(plane.b), z = sgn(plane.c);
  return ((x != 0 ? x : y != 0 ? y : z) > 0) == (front.side() == 0);
}

std::vector<scenes::Polygon> loops_of(const Complex& c, const SimplifiedComplex& s,
                                      const SimplifiedComplex::Face& f) {
  std::vector<scenes::Polygon> loops;
  for (const auto& walk : f.loops) {
    loops.emplace_back();
    for (const VertexId v : corners(c, s, walk)) loops.back().push_back(c.points.rational(v));
  }
  return loops;
}

}  // namespace

Selection joined(Selection s) {
  const auto one = [](auto& list) {
    for (auto& [cell, component] : list) component = 1;
  };
  one(s.vertices);
  one(s.edges);
  one(s.faces);
  one(s.regions);
  return s;
}

Selection point_set(const Complex& complex, const Group& group) { return joined(selection_of(complex, group)); }

Component component_at(const Selection& selection, const Location& at) {
  switch (at.dimension) {
    case 0: return component_in(selection.vertices, at.vertex);
    case 1: return component_in(selection.edges, at.edge);
    case 2: return component_in(selection.faces, at.face);
    default: return component_in(selection.regions, at.region);
  }
}

Skeleton skeleton(const Complex& complex, const Group& group) {
  return skeleton(complex, point_set(complex, group));
}

NefSet to_nef(const Complex& complex, const Group& group) { return to_nef(complex, point_set(complex, group)); }

Skeleton skeleton(const Complex& complex, const Selection& set) {
  const SimplifiedComplex s = simplify(complex, set, {}, SimplifyMode::points);
  Skeleton result;
  std::map<VertexId, std::uint32_t> number;
  for (const auto& v : s.vertices) {
    number[v.cell] = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.push_back({complex.points.rational(v.cell), v.component != 0});
  }
  for (const auto& e : s.edges)
    result.edges.push_back(
        {{number.at(complex.origin(e.chain.front())), number.at(complex.target(e.chain.back()))},
         e.component != 0});
  for (const auto& f : s.faces) {
    Skeleton::Facet facet;
    facet.mark = f.component != 0;
    const bool front = s.regions[f.regions[0]].component != 0, back = s.regions[f.regions[1]].component != 0;
    const bool up = front_is_up(complex, f.cells.front());
    facet.above = up ? front : back;
    facet.below = up ? back : front;
    for (const auto& walk : f.loops) {
      const auto loop = corners(complex, s, walk);
      for (std::size_t i = 0; i < loop.size(); ++i)
        facet.boundary.push_back({number.at(loop[i]), number.at(loop[(i + 1) % loop.size()])});
    }
    for (const VertexId v : f.isolated) facet.isolated.push_back(number.at(v));
    result.facets.push_back(std::move(facet));
  }
  result.volumes = std::max<std::size_t>(s.regions.size(), 1);  // a set without walls may list no region
  result.sort();
  return result;
}

NefSet to_nef(const Complex& complex, const Selection& set) {
  const SimplifiedComplex s = simplify(complex, set, {}, SimplifyMode::points);
  std::vector<NefSet> walls, off;
  // What the closed walls give with the right mark: edges and vertices of marked faces alone, and so on.
  std::vector<char> edge_given(s.edges.size(), 0), edge_taken(s.edges.size(), 0);
  std::vector<char> vertex_given(s.vertices.size(), 0), vertex_taken(s.vertices.size(), 0);
  const auto touch = [](const Place& place, bool given, std::vector<char>& gives, std::vector<char>& takes) {
    (given ? gives : takes)[place.index] = 1;
  };
  const auto touch_vertex = [&](VertexId v, bool given) {
    if (s.vertex_place[v.index()].dimension == 0)
      touch(s.vertex_place[v.index()], given, vertex_given, vertex_taken);
  };
  for (const auto& f : s.faces) {
    const bool marked = f.component != 0;
    walls.push_back(NefSet::polygon(loops_of(complex, s, f)));
    if (!marked) off.push_back(walls.back());
    for (const auto& walk : f.loops)
      for (const HalfEdge h : walk) {
        touch(s.edge_place[h.edge().index()], marked, edge_given, edge_taken);
        touch_vertex(complex.origin(h), marked);
      }
    for (const VertexId v : f.isolated) touch_vertex(v, marked);
  }
  std::vector<RationalPoint> inside;
  for (const auto& r : s.regions)
    if (r.component != 0) inside.push_back(scenes::point_in(complex, r.cells.front()));
  // Space without walls lists no region.
  if (s.regions.empty() && !set.regions.empty()) inside.push_back(scenes::point_in(complex, set.regions[0].first));
  NefSet result = NefSet::unite_all(std::move(walls)).fill(inside).without(NefSet::unite_all(std::move(off)));
  std::vector<NefSet> on;
  off.clear();
  for (std::size_t i = 0; i < s.edges.size(); ++i) {
    const VertexId a = complex.origin(s.edges[i].chain.front()), b = complex.target(s.edges[i].chain.back());
    const bool marked = s.edges[i].component != 0;
    touch_vertex(a, marked);
    touch_vertex(b, marked);
    if (marked && edge_given[i] && !edge_taken[i]) continue;
    (marked ? on : off).push_back(NefSet::segment(complex.points.rational(a), complex.points.rational(b)));
  }
  result = result.without(NefSet::unite_all(std::move(off))).unite(NefSet::unite_all(std::move(on)));
  on.clear(), off.clear();
  for (std::size_t i = 0; i < s.vertices.size(); ++i) {
    const bool marked = s.vertices[i].component != 0;
    if (marked && vertex_given[i] && !vertex_taken[i]) continue;
    (marked ? on : off).push_back(NefSet::point(complex.points.rational(s.vertices[i].cell)));
  }
  return result.without(NefSet::unite_all(std::move(off))).unite(NefSet::unite_all(std::move(on)));
}

Rational volume(const Complex& complex, const Group& group) {
  std::vector<Rational> parts;
  for (const auto& [cell, region] : group.cells) parts.push_back(scenes::volume(complex, cell));
  return sum(std::move(parts));
}

std::string validate(const Complex& complex, const Group& group) {
  for (const FaceId f : group.faces) {
    std::vector<EdgeId> edges;
    std::vector<VertexId> vertices;
    complex.closure_edges(f, edges);
    vertices.assign(complex.face_vertices[f].begin(), complex.face_vertices[f].end());
    for (const LoopId l : complex.face_loops[f])
      for (const HalfEdge h : complex.loop[l]) vertices.push_back(complex.origin(h));
    for (const EdgeId e : edges)
      if (!group.has(e)) return "an edge of face " + std::to_string(f.value()) + " is missing";
    for (const VertexId v : vertices)
      if (!group.has(v)) return "a vertex of face " + std::to_string(f.value()) + " is missing";
  }
  for (const EdgeId e : group.edges)
    for (const VertexId v : complex.edge_ends[e])
      if (!group.has(v)) return "an end of edge " + std::to_string(e.value()) + " is missing";
  for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
    const auto [front, back] = complex.face_regions[f];
    if (group.region_of(front) != group.region_of(back) && !group.has(f))
      return "face " + std::to_string(f.value()) + " is between two regions and no wall";
  }
  std::vector<RegionId> inside;
  for (const auto& [cell, region] : group.cells) inside.push_back(cell);
  std::map<std::uint32_t, std::uint32_t> same;
  for (const auto& [cell, region] : detect_regions(complex, inside, group.faces)) {
    const auto [it, fresh] = same.emplace(group.region_of(cell), region);
    if (it->second != region) return "region " + std::to_string(it->first) + " is not connected";
  }
  if (same.size() != group.regions.size()) return "the number of regions is not that of their attributes";
  for (const EdgeId e : group.features.edges)
    if (!group.has(e)) return "feature edge " + std::to_string(e.value()) + " is no entity";
  for (const VertexId v : group.features.vertices)
    if (!group.has(v)) return "feature vertex " + std::to_string(v.value()) + " is no entity";
  return {};
}

}  // namespace cnrg::properties
