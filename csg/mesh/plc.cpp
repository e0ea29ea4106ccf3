// Faces as facets, edges as segments. A facet goes to the mesher as a
// whole where it can, since its own triangles would bind the mesh; else as these triangles.
#include "csg/mesh/plc.h"

#include <algorithm>
#include <set>
#include <span>

#include "csg/result/flat.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/triangulate.h"

namespace cnrg {
namespace {

using Index = Plc::Index;
using Vector = std::array<double, 3>;
using Loop = FlatComplex::Loop;

class PlcBuilder {
 public:
  PlcBuilder(const ResultView& view, const FlatComplex& flat, const RoundedResult& rounded, PlcFacets facets)
      : exact_(view.complex->points), flat_(flat), facets_(facets) {
    plc_.points = rounded.points().xyz;
    for (const Vector& p : plc_.points) table_.add(p[0], p[1], p[2]);
  }

  Plc run() {
    for (Index i = 0; i < flat_.faces.size(); ++i) add_face(i);
    for (Index i = 0; i < flat_.edges.size(); ++i) add_edge(i);
    add_regions(plc_, flat_);
    return std::move(plc_);
  }

 private:
  const PointTable& exact_;
  const FlatComplex& flat_;
  const PlcFacets facets_;
  PointTable table_;  // the rounded points, by their numbers
  Plc plc_;
  Index pieces_ = 0;

  Vector at(Index p) const { return plc_.points[p]; }

  void add_edge(Index i) {
    const auto& edge = flat_.edges[i];
    for_each_segment(edge, [&](Index a, Index b) { plc_.segments.push_back({{a, b}, i, edge.wire}); });
  }

  void add_face(Index i) {
    for_each_facet(flat_.faces[i], [&](const auto& loops, const auto& isolated, Index begin, Index end) {
      add_facet(i, loops, isolated, begin, end);
    });
  }

  void add_facet(Index face, const std::vector<Loop>& loops, std::span<const Index> isolated, Index begin,
                 Index end) {
    const Index piece = pieces_++;
    const auto& triangles = flat_.faces[face].triangles;
    if (facets_ != PlcFacets::triangles && end - begin > 1) {
      Plc::Facet facet;
      facet.face = face, facet.piece = piece;
      if (make_polygons(loops, isolated, triangles[begin], facet)) {
        plc_.facets.push_back(std::move(facet));
        return;
      }
    }
    for (Index t = begin; t < end; ++t) {
      plc_.facets.push_back({{{triangles[t][0], triangles[t][1], triangles[t][2]}}, {}, face, piece});
    }
  }

  /// False where a facet has to be triangles: it is not as planar as asked for, walks over itself, or has a hole
  /// without a point of doubles in it.
  bool make_polygons(const std::vector<Loop>& loops, std::span<const Index> isolated,
                     const std::array<Index, 3>& corners, Plc::Facet& facet) {
    const VertexId a(corners[0]), b(corners[1]), c(corners[2]);
    const auto in_plane = [&](Index p) {
      return facets_ == PlcFacets::all || orient3d(table_, a, b, c, VertexId(p)) == 0;
    };
    for (const Loop& loop : loops) {
      if (loop.size() < 3 || !std::all_of(loop.begin(), loop.end(), in_plane)) return false;
      if (std::set<Index>(loop.begin(), loop.end()).size() != loop.size()) return false;
    }
    if (!std::all_of(isolated.begin(), isolated.end(), in_plane)) return false;
    const Projection axes = projection_of(table_, table_.add_plane(a, b, c));
    const std::size_t outer = outer_loop(loops, axes);
    facet.polygons.emplace_back(loops[outer].begin(), loops[outer].end());
    for (std::size_t k = 0; k < loops.size(); ++k) {
      if (k == outer) continue;
      facet.polygons.emplace_back(loops[k].begin(), loops[k].end());
      Vector inside;
      if (!point_in(loops[k], corners, inside)) return false;
      facet.holes.push_back(inside);
    }
    for (const Index p : isolated) facet.polygons.push_back({p});
    return true;
  }

  /// The loop around all others has the largest area.
  std::size_t outer_loop(const std::vector<Loop>& loops, Projection axes) const {
    std::size_t outer = 0;
    Rational most = -1;
    for (std::size_t k = 0; loops.size() > 1 && k < loops.size(); ++k) {
      Rational area = 0;
      for (std::size_t i = 0; i < loops[k].size(); ++i) {
        const Vector p = at(loops[k][i]), q = at(loops[k][(i + 1) % loops[k].size()]);
        area += from_double(p[axes.u]) * from_double(q[axes.v]) - from_double(q[axes.u]) * from_double(p[axes.v]);
      }
      area = abs(area);
      if (area <= most) continue;
      most = area;
      outer = k;
    }
    return outer;
  }

  /// The middle of the largest triangle inside a loop, if rounding leaves it strictly inside of that triangle. The
  /// exact points are triangulated, since rounded ones may cross as seen along an axis.
  bool point_in(const Loop& loop, const std::array<Index, 3>& corners, Vector& inside) const {
    PointTable table;
    std::vector<VertexId> walk;
    for (const Index p : loop) walk.push_back(table.add(exact_.rational(flat_.points[p])));
    std::array<VertexId, 3> plane;
    for (std::size_t k = 0; k < 3; ++k) plane[k] = table.add(exact_.rational(flat_.points[corners[k]]));
    const Projection axes = projection_of(table, table.add_plane(plane[0], plane[1], plane[2]));
    double most = 0;
    std::array<Index, 3> best{};
    for (const auto& t : triangulate(table, axes, std::span(&walk, 1))) {
      const Vector p = at(loop[t[0].index()]), q = at(loop[t[1].index()]), r = at(loop[t[2].index()]);
      const double area =
          (q[axes.u] - p[axes.u]) * (r[axes.v] - p[axes.v]) - (q[axes.v] - p[axes.v]) * (r[axes.u] - p[axes.u]);
      if (area <= most) continue;
      most = area;
      for (std::size_t k = 0; k < 3; ++k) {
        best[k] = loop[t[k].index()];
        inside[k] = (p[k] + q[k] + r[k]) / 3;
      }
    }
    if (most == 0) return false;
    const ExactPoint middle = ExactPoint::from(from_doubles(inside));
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId from(best[k]), to(best[(k + 1) % 3]);
      if (orient2d(axes, table_.view(from), table_.view(to), view_of(middle)) <= 0) return false;
    }
    return true;
  }
};

}  // namespace

Plc plc_of(const ResultView& view, const FlatComplex& flat, const RoundedResult& rounded, PlcFacets facets) {
  return PlcBuilder(view, flat, rounded, facets).run();
}

void add_regions(Plc& plc, const FlatComplex& flat) {
  for (Index i = 0; i < flat.regions.size(); ++i) {
    const auto& region = flat.regions[i];
    if (region.component != 0) plc.regions.push_back({{}, i});
    else if (region.bounded) plc.holes.push_back({{}, i});
  }
}

void set_seeds(Plc& plc, const RoundedResult& rounded) {
  for (auto* list : {&plc.regions, &plc.holes}) {
    for (Plc::Seed& seed : *list) seed.point = rounded.seed(seed.region);
  }
}

}  // namespace cnrg
