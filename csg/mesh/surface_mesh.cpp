// The surface mesh: points, straight pieces of edges, facets and regions as entities with what bounds them.
#include <algorithm>

#include "csg/mesh/material_field.h"
#include "csg/mesh/mesh.h"
#include "csg/result/flat.h"
#include "csg/result/solid.h"
#include "kernel/base/limits.h"
#include "kernel/base/number_table.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;

class SurfaceMesher {
 public:
  SurfaceMesher(const ResultView& view, const FlatComplex& flat, const RoundedPoints& points)
      : flat_(flat), rounded_(points), tagger_(view, flat), groups_(mesh_groups(view, flat)) {
    mesh_.node = view.node;
    mesh_.flat = true;
    mesh_.one_group = view.one_group;
    mesh_.groups = groups_.names;
    mesh_.sources = groups_.sources;
  }

  Mesh run() {
    number_points();
    add_edges();
    add_faces();
    add_regions();
    return std::move(mesh_);
  }

 private:
  const FlatComplex& flat_;
  const RoundedPoints& rounded_;
  CellTagger tagger_;
  MeshGroups groups_;
  Mesh mesh_;
  std::vector<Index> point_;                  // entity of dimension 0 and point of the mesh, or kNone
  NumberTable segment_;                       // entity of dimension 1 between two points
  std::vector<std::array<Index, 2>> facets_;  // of each face: entities of dimension 2, first and end
  std::vector<std::array<Index, 2>> steps_;   // around a facet
  std::vector<std::uint64_t> walked_;         // the same, sorted

  /// Every point that something has is an entity; those that are vertices of the result are features.
  void number_points() {
    point_.assign(flat_.points.size(), kNone);
    const auto use = [&](Index p) { point_[p] = 0; };
    std::size_t most = 0;  // segments
    for (const auto& f : flat_.faces) {
      most += 3 * f.triangles.size();
      for (const auto& t : f.triangles) std::ranges::for_each(t, use);
    }
    for (const auto& e : flat_.edges) {
      most += e.points.size();
      std::ranges::for_each(e.points, use);
    }
    segment_ = NumberTable(most);
    for (const auto& v : flat_.vertices) use(v.point);
    for (Index p = 0; p < point_.size(); ++p) {
      if (point_[p] == kNone) continue;
      point_[p] = Index(mesh_.points.size());
      mesh_.points.push_back(rounded_.xyz[p]);
      mesh_.vertices.push_back({{point_[p]}, point_[p]});
      mesh_.entities[0].emplace_back().feature = false;
    }
    for (Index i = 0; i < flat_.vertices.size(); ++i) {
      auto& entity = mesh_.entities[0][point_[flat_.vertices[i].point]];
      entity.feature = true;
      entity.groups = groups_.of[0][i];
      entity.tags = tagger_.vertex(i);
    }
  }

  /// The piece between two points: one of an edge of the result, or a new one between two facets of a patch.
  Index segment(Index a, Index b) {
    const auto ends = sorted(std::array{point_[a], point_[b]});
    const std::uint64_t hash = edge_key(a, b) * 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio
    Index& known = segment_.slot(hash >> 32, [&](Index s) { return mesh_.segments[s].points == ends; });
    if (known == kNone) {
      known = Index(mesh_.segments.size());
      mesh_.segments.push_back({ends, known});
      auto& entity = mesh_.entities[1].emplace_back();
      entity.feature = false;
      entity.tags.dimension = 1;
      entity.boundary = {std::int32_t(ends[0] + 1), -std::int32_t(ends[1] + 1)};
    }
    return known;
  }

  void add_edges() {
    for (Index i = 0; i < flat_.edges.size(); ++i) {
      const auto& e = flat_.edges[i];
      for_each_segment(e, [&](Index a, Index b) {
        auto& entity = mesh_.entities[1][segment(a, b)];
        entity.feature = true;
        entity.wire = e.wire;
        entity.groups = groups_.of[1][i];
        entity.tags = tagger_.edge(i);
      });
    }
  }

  void add_entity(Index face, const std::vector<std::array<Index, 2>>& steps, Index begin, Index end) {
    const Index number = Index(mesh_.entities[2].size());
    Mesh::Entity entity;
    for (const auto& [a, b] : steps) {
      const std::int32_t s = std::int32_t(segment(a, b) + 1);
      entity.boundary.push_back(point_[a] < point_[b] ? s : -s);
    }
    entity.groups = groups_.of[2][face];
    entity.tags = tagger_.face(face);
    mesh_.entities[2].push_back(std::move(entity));
    for (Index t = begin; t < end; ++t) {
      const auto& points = flat_.faces[face].triangles[t];
      mesh_.triangles.push_back({{point_[points[0]], point_[points[1]], point_[points[2]]}, number});
    }
  }

  /// One entity; or a triangle each, where an edge or a point lies inside that a mesher would not see otherwise.
  void add_facet(Index face, const std::vector<FlatComplex::Loop>& loops, bool isolated, Index begin, Index end) {
    steps_.clear(), walked_.clear();
    for (const auto& loop : loops) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        steps_.push_back({loop[k], loop[(k + 1) % loop.size()]});
        walked_.push_back(edge_key(steps_.back()[0], steps_.back()[1]));
      }
    }
    std::sort(walked_.begin(), walked_.end());
    const bool inside = isolated || std::adjacent_find(walked_.begin(), walked_.end()) != walked_.end();
    if (!inside) return add_entity(face, steps_, begin, end);
    for (Index t = begin; t < end; ++t) {
      const auto& p = flat_.faces[face].triangles[t];
      add_entity(face, {{p[0], p[1]}, {p[1], p[2]}, {p[2], p[0]}}, t, t + 1);
    }
  }

  void add_faces() {
    for (Index i = 0; i < flat_.faces.size(); ++i) {
      const Index first = Index(mesh_.entities[2].size());
      for_each_facet(flat_.faces[i], [&](const auto& loops, const auto& isolated, Index begin, Index end) {
        add_facet(i, loops, !isolated.empty(), begin, end);
      });
      facets_.push_back({first, Index(mesh_.entities[2].size())});
    }
  }

  /// A dangling face in a region bounds it on both sides and is listed once.
  void add_regions() {
    for (Index i = 0; i < flat_.regions.size(); ++i) {
      const auto& region = flat_.regions[i];
      if (region.component == 0) continue;
      std::vector<Index> sides;
      for (const auto& shell : region.shells) sides.insert(sides.end(), shell.begin(), shell.end());
      std::sort(sides.begin(), sides.end());
      auto& entity = mesh_.entities[3].emplace_back();
      for (std::size_t k = 0; k < sides.size(); ++k) {
        const auto& [begin, end] = facets_[sides[k] >> 1];
        const bool front = (sides[k] & 1) == 0,
                   both = k + 1 < sides.size() && front && sides[k + 1] == sides[k] + 1;
        for (Index f = begin; f < end; ++f)
          entity.boundary.push_back(front && !both ? -std::int32_t(f + 1) : std::int32_t(f + 1));
        k += both;
      }
      entity.groups = groups_.of[3][i];
      entity.tags = tagger_.region(i);
    }
  }
};

}  // namespace

Mesh surface_mesh(const ResultView& view, const FlatComplex& flat, const RoundedPoints& points) {
  Mesh mesh = SurfaceMesher(view, flat, points).run();
  add_properties(view, mesh);
  return mesh;
}

Drawing drawing_of(const FlatComplex& flat) {
  Drawing drawing;
  std::vector<char> drawn(flat.points.size(), 0);
  for (const auto& f : flat.faces) {
    drawing.triangles.insert(drawing.triangles.end(), f.triangles.begin(), f.triangles.end());
    drawing.sides.insert(drawing.sides.end(), f.triangles.size(), f.regions);
    for (const auto& t : f.triangles)
      for (const Index p : t) drawn[p] = 1;
  }
  for (const auto& e : flat.edges) {
    for (const Index p : e.points) drawn[p] = 1;
    if (!e.wire) continue;
    for_each_segment(e, [&](Index a, Index b) {
      drawing.segments.push_back({a, b});
      drawing.around_segments.push_back(e.region);
    });
  }
  for (const auto& v : flat.vertices) {
    if (drawn[v.point]) continue;
    drawing.points.push_back(v.point);
    drawing.around_points.push_back(v.region);
  }
  return drawing;
}

}  // namespace cnrg
