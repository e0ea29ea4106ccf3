#include "csg/mesh/cell_mesh.h"

#include <cstdlib>

#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;

}  // namespace

EdgePieces::EdgePieces(const FlatComplex& flat) {
  for (Index i = 0; i < flat.edges.size(); ++i) {
    for_each_segment(flat.edges[i], [&](Index a, Index b) { pieces_[edge_key(a, b)] = {i, a < b}; });
  }
}

std::int32_t EdgePieces::step(Index a, Index b) const {
  const auto piece = pieces_.find(edge_key(a, b));
  require(piece != pieces_.end(), "mesh: a face is bounded by what is no edge");
  const std::int32_t e = std::int32_t(piece->second.edge + 1);
  return piece->second.forward == (a < b) ? e : -e;
}

Mesh mesh_of_cells(const ResultView& view, const FlatComplex& flat, bool with_regions) {
  const MeshGroups groups = mesh_groups(view, flat);
  const CellTagger tagger(view, flat);
  const EdgePieces pieces(flat);
  Mesh mesh;
  mesh.node = view.node;
  mesh.groups = groups.names;
  mesh.sources = groups.sources;
  std::vector<Index> vertex_at(flat.points.size(), kNone);
  for (Index i = 0; i < flat.vertices.size(); ++i) {
    vertex_at[flat.vertices[i].point] = i;
    mesh.entities[0].push_back({groups.of[0][i], {}, true, false, tagger.vertex(i)});
  }
  for (Index i = 0; i < flat.edges.size(); ++i) {
    const auto& edge = flat.edges[i];
    Mesh::Entity entity{groups.of[1][i], {}, true, edge.wire, tagger.edge(i)};
    if (!edge.closed) {
      entity.boundary = {std::int32_t(vertex_at[edge.points.front()] + 1),
                         -std::int32_t(vertex_at[edge.points.back()] + 1)};
    }
    mesh.entities[1].push_back(std::move(entity));
  }
  for (Index i = 0; i < flat.faces.size(); ++i) {
    Mesh::Entity entity{groups.of[2][i], {}, true, false, tagger.face(i)};
    std::unordered_map<Index, char> seen;  // a slit is walked twice and listed once
    for (const auto& loop : flat.faces[i].loops) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const std::int32_t s = pieces.step(loop[k], loop[(k + 1) % loop.size()]);
        if (seen.try_emplace(Index(std::abs(s)), 1).second) entity.boundary.push_back(s);
      }
    }
    mesh.entities[2].push_back(std::move(entity));
  }
  if (!with_regions) mesh.groups[3].clear();
  for (Index i = 0; with_regions && i < flat.regions.size(); ++i) {
    if (flat.regions[i].component == 0) continue;
    Mesh::Entity entity{groups.of[3][i], {}, true, false, tagger.region(i)};
    for (const auto& shell : flat.regions[i].shells) {
      for (const Index side : shell) {
        const std::int32_t f = std::int32_t((side >> 1) + 1);
        const bool again = !entity.boundary.empty() && std::abs(entity.boundary.back()) == f;
        if (!again) entity.boundary.push_back((side & 1) == 0 ? -f : f);  // both sides of a face are neighbours
      }
    }
    mesh.entities[3].push_back(std::move(entity));
  }
  return mesh;
}

void prove_edges(const Mesh& mesh, const FlatComplex& flat) {
  const auto& segments = mesh.segments;
  std::size_t at = 0;
  std::unordered_map<Index, int> degree;
  for (Index e = 0; e < flat.edges.size(); ++e) {
    degree.clear();
    for (; at < segments.size() && segments[at].entity == e; ++at) {
      for (const Index p : segments[at].points) ++degree[p];
    }
    // A chain may come back to the vertex where it began.
    const auto& edge = flat.edges[e];
    const bool returns = edge.closed || edge.points.front() == edge.points.back();
    for (std::size_t k = 0; k + (returns && !edge.closed ? 1 : 0) < edge.points.size(); ++k) {
      const Index p = edge.points[k];
      const bool end = !returns && (k == 0 || k + 1 == edge.points.size());
      const auto found = degree.find(p);
      require(found != degree.end() && found->second == (end ? 1 : 2), "mesh: the mesher lost a part of an edge");
      degree.erase(found);
    }
    for (const auto& [p, n] : degree) require(n == 2, "mesh: the mesher returns an edge with a gap");
  }
  require(at == segments.size(), "mesh: the mesher returns a segment of no edge");
}

void prove_faces(const Mesh& mesh, const FlatComplex& flat) {
  struct Side {
    Index face, a, b;
    auto operator<=>(const Side&) const = default;
  };
  std::vector<std::pair<std::size_t, std::size_t>> of_edge(flat.edges.size(), {0, 0});
  const auto& segments = mesh.segments;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    auto& [begin, end] = of_edge[segments[i].entity];
    if (end == 0) begin = i;
    end = i + 1;
  }
  const EdgePieces pieces(flat);
  std::vector<Side> sides;
  std::vector<char> present(flat.faces.size(), 0);
  const auto add = [&](Index face, Index a, Index b) { sides.push_back({face, std::min(a, b), std::max(a, b)}); };
  for (const auto& t : mesh.triangles) {
    present[t.entity] = 1;
    for (std::size_t k = 0; k < 3; ++k) add(t.entity, t.points[k], t.points[(k + 1) % 3]);
  }
  for (Index f = 0; f < flat.faces.size(); ++f) {
    require(present[f], "mesh: the mesher lost a face");
    // A walk takes each edge as a whole, so its first piece counts for it.
    for (const auto& loop : flat.faces[f].loops) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Index a = loop[k], b = loop[(k + 1) % loop.size()];
        const Index e = Index(std::abs(pieces.step(a, b)) - 1);
        const auto& chain = flat.edges[e].points;
        if (edge_key(a, b) != edge_key(chain[0], chain[1])) continue;
        for (std::size_t i = of_edge[e].first; i < of_edge[e].second; ++i) {
          add(f, segments[i].points[0], segments[i].points[1]);
        }
      }
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end] == sides[i]) ++end;
    require((end - i) % 2 == 0, "mesh: the mesher lost a part of a face");
  }
}

void take_points(Mesh& mesh, const std::vector<std::array<double, 3>>& points) {
  std::vector<Index> number(points.size(), kNone);
  const auto for_all = [&](const auto& body) {
    for (auto& s : mesh.vertices) body(s.points);
    for (auto& s : mesh.segments) body(s.points);
    for (auto& s : mesh.triangles) body(s.points);
    for (auto& s : mesh.quads) body(s.points);
    for (auto& s : mesh.tetrahedra) body(s.points);
  };
  for_all([&](const auto& corners) {
    for (const Index p : corners) number[p] = 0;
  });
  for (Index p = 0; p < number.size(); ++p) {
    if (number[p] == kNone) continue;
    number[p] = Index(mesh.points.size());
    mesh.points.push_back(points[p]);
  }
  for_all([&](auto& corners) {
    for (Index& p : corners) p = number[p];
  });
}

void prove_sides(const Mesh& mesh, const FlatComplex& flat, const std::vector<Mesh::Index>& region_entity,
                 const Watch& watch) {
  struct Side {
    std::array<Index, 3> points;
    Index region, face;  // one of them, the other kNone
    auto operator<=>(const Side&) const = default;
  };
  std::vector<Side> sides;
  for (const auto& t : mesh.tetrahedra) {
    for (const auto& [i, j, k] : kOutsides)
      sides.push_back({sorted(std::array{t.points[i], t.points[j], t.points[k]}), t.entity, kNone});
  }
  for (const auto& t : mesh.triangles) sides.push_back({sorted(t.points), kNone, t.entity});
  watch.check();
  std::sort(sides.begin(), sides.end());
  watch.check();
  std::vector<Index> found, expected;
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    found.clear(), expected.clear();
    std::size_t faces = 0;
    for (; end < sides.size() && sides[end].points == sides[i].points; ++end) {
      if (sides[end].face == kNone) {
        found.push_back(sides[end].region);
        continue;
      }
      ++faces;
      for (const Index r : flat.faces[sides[end].face].regions) {
        if (flat.active(r)) expected.push_back(region_entity[r]);
      }
    }
    std::sort(expected.begin(), expected.end());
    const bool right = faces == 1   ? found == expected
                       : faces == 0 ? found.size() == 2 && found[0] == found[1]
                                    : false;
    require(right, "tetrahedra: the mesher returns tetrahedra on the wrong side of a face");
  }
}

}  // namespace cnrg
