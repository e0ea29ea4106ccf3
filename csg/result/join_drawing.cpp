// Facets without joints keep their triangles; others are triangulated again, with the joints as corners. Segments
// are common to all that they bound, so what fits together before fits afterwards.
#include "csg/result/join_drawing.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "csg/result/flat_drawing.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/distance.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/triangulate.h"

namespace cnrg {
namespace {

using Index = Parts::Index;
constexpr std::size_t kUncheckedFacets = 1024;  // facets between two looks at the watch

class Mover {
 public:
  Mover(const Parts& parts, const JoinMoves& moves, const Watch& watch)
      : watch_(watch), parts_(parts), at_(parts.points()), to_(moves.to) {
    drawing_.triangles = moves.triangles;
    for (const Joint& joint : moves.joints) {
      const Index number = Index(at_.size());
      at_.push_back(joint.at);
      to_.push_back(joint.to);
      if (joint.on == Near::point_facet) {
        in_facet_[joint.part].push_back(number);
      } else {
        const auto& [a, b] = parts.segments()[joint.part].ends;
        in_segment_[edge_key(a, b)].push_back(number);
      }
    }
    for (auto& [key, list] : in_segment_) {
      const RationalPoint& from = at_[Index(key >> 32)];  // the lower number
      const auto along = [&](Index p) {
        const RationalPoint d = at_[p] - from;
        return dot(d, d);
      };
      std::sort(list.begin(), list.end(), [&](Index p, Index q) { return along(p) < along(q); });
    }
  }

  MovedDrawing run() {
    draw();
    return refine();
  }

 private:
  const Watch& watch_;
  const Parts& parts_;
  std::vector<RationalPoint> at_, to_;                                // points, then joints
  std::unordered_map<std::uint64_t, std::vector<Index>> in_segment_;  // joints from the end of the lower number on
  std::unordered_map<Index, std::vector<Index>> in_facet_;
  NumberedDrawing drawing_;  // by numbers of `at_`

  /// From a to b without b: a and the joints between them.
  void walk(Index a, Index b, std::vector<Index>& out) const {
    out.push_back(a);
    const auto found = in_segment_.find(edge_key(a, b));
    if (found == in_segment_.end()) return;
    if (a < b) out.insert(out.end(), found->second.begin(), found->second.end());
    else out.insert(out.end(), found->second.rbegin(), found->second.rend());
  }

  void draw() {
    const FlatComplex& flat = parts_.flat();
    const NumberedDrawing plain = drawing_of_cells(flat);
    drawing_.isolated = plain.isolated;
    std::vector<Index> chain;
    for (const auto& [ends, edge] : plain.pieces) {
      chain.clear();
      walk(ends[0], ends[1], chain);
      chain.push_back(ends[1]);
      for (std::size_t k = 0; k + 1 < chain.size(); ++k)
        drawing_.pieces.push_back({{chain[k], chain[k + 1]}, edge});
    }
    if (!drawing_.triangles.empty()) return;
    PointTable table;
    for (const RationalPoint& p : at_) {
      if (table.size() % kUncheckedFacets == 0) watch_.check();
      if (is_double(p[0]) && is_double(p[1]) && is_double(p[2]))
        table.add(to_double(p[0]), to_double(p[1]), to_double(p[2]));
      else table.add(p);
    }
    std::size_t t = 0;
    for (Index f = 0; f < parts_.facets().size(); ++f) {
      const std::size_t begin = t;
      while (t < parts_.triangles().size() && parts_.triangles()[t].facet == f) ++t;
      draw_facet(f, begin, t, table);
      if (f % kUncheckedFacets == 0) watch_.check();
    }
  }

  void draw_facet(Index f, std::size_t begin, std::size_t end, PointTable& table) {
    const Parts::Facet& facet = parts_.facets()[f];
    std::vector<std::vector<VertexId>> walks;
    std::vector<Index> chain;
    bool jointed = false;
    for (const FlatComplex::Loop& loop : parts_.loops(facet)) {
      chain.clear();
      for (std::size_t k = 0; k < loop.size(); ++k) walk(loop[k], loop[(k + 1) % loop.size()], chain);
      jointed = jointed || chain.size() > loop.size();
      auto& to = walks.emplace_back();
      for (const Index p : chain) to.emplace_back(p);
    }
    std::vector<VertexId> isolated;
    for (const Index p : parts_.isolated(facet)) isolated.emplace_back(p);
    if (const auto found = in_facet_.find(f); found != in_facet_.end()) {
      jointed = true;
      for (const Index p : found->second) isolated.emplace_back(p);
    }
    if (!jointed) {
      for (std::size_t t = begin; t < end; ++t)
        drawing_.triangles.push_back({parts_.triangles()[t].corners, facet.face});
      return;
    }
    const auto& [a, b, c] = parts_.triangles()[begin].corners;
    const PlaneId plane = table.add_plane(VertexId(a), VertexId(b), VertexId(c));
    for (const auto& [p, q, r] : triangulate(table, projection_of(table, plane), walks, isolated))
      drawing_.triangles.push_back({{p.value(), q.value(), r.value()}, facet.face});
  }

  MovedDrawing refine() const {
    Soup soup;
    const LeafId leaf = soup.add_leaf(Fill::none);
    std::map<RationalPoint, PointId> ids;
    const auto id = [&](Index p) {
      const auto [it, fresh] = ids.try_emplace(to_[p]);
      if (fresh) it->second = soup.add_point(to_[p]);
      return it->second;
    };
    std::vector<Index> face_of;  // by source
    std::unordered_map<std::uint64_t, char> sides;
    std::vector<PointId> held;
    for (const auto& t : drawing_.triangles) {
      if (face_of.size() % kUncheckedFacets == 0) watch_.check();
      const auto& [a, b, c] = t.points;
      if (collinear(to_[a], to_[b], to_[c])) continue;
      const std::array<PointId, 3> p{id(a), id(b), id(c)};
      const auto number = std::uint32_t(face_of.size());
      soup.add_triangle(leaf, p[0], p[1], p[2], number, number);
      face_of.push_back(t.face);
      for (std::size_t k = 0; k < 3; ++k) sides[edge_key(p[k].value(), p[(k + 1) % 3].value())] = 1;
      held.insert(held.end(), p.begin(), p.end());
    }
    std::map<std::array<PointId, 2>, std::vector<Index>> pieces;
    for (const auto& [ends, edge] : drawing_.pieces) {
      if (to_[ends[0]] == to_[ends[1]]) continue;
      const PointId a = id(ends[0]), b = id(ends[1]);
      pieces[{std::min(a, b), std::max(a, b)}].push_back(edge);
      held.push_back(a), held.push_back(b);
    }
    auto number = std::uint32_t(face_of.size());
    for (auto& [ends, edges] : pieces) {
      sort_unique(edges);
      if (!sides.contains(edge_key(ends[0].value(), ends[1].value())))
        soup.add_wire(leaf, ends[0], ends[1], number++);
    }
    sort_unique(held);
    for (const Index p : drawing_.isolated) {
      const PointId at = id(p);
      if (!std::binary_search(held.begin(), held.end(), at)) soup.add_isolated(leaf, at);
    }
    if (soup.point_count() == 0) {
      throw InputError("nothing would be left: all of the result collapses; give a smaller distance");
    }
    RefineOptions options;
    options.vertices = true;
    options.watch = watch_;
    RefineReport report;
    MovedDrawing out{ComplexDraft(soup, options, &report), {}, {}, {}, 1, false, 0};
    tell(out, report, ids, face_of, pieces);
    return out;
  }

  void tell(MovedDrawing& out, const RefineReport& report, const std::map<RationalPoint, PointId>& ids,
            const std::vector<Index>& face_of,
            const std::map<std::array<PointId, 2>, std::vector<Index>>& pieces) const {
    const Complex& complex = *out.complex;
    std::vector<Index> list;
    for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
      list.clear();
      for (const Cover& cover : complex.cover(f))
        list.push_back(2 * face_of[cover.source.index()] + (cover.same ? 0 : 1));
      std::sort(list.begin(), list.end());
      out.faces.push_back(list);
    }
    std::map<std::array<VertexId, 2>, const std::vector<Index>*> of_segment;
    for (const auto& [ends, edges] : pieces) {
      const VertexId a = report.vertex_of[ends[0].index()], b = report.vertex_of[ends[1].index()];
      of_segment[{std::min(a, b), std::max(a, b)}] = &edges;
    }
    for (const EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
      list.clear();
      for (const SegmentId s : complex.edge_segments[e]) {
        const auto& [a, b] = complex.segment_ends[s];
        const auto found = of_segment.find({std::min(a, b), std::max(a, b)});
        if (found != of_segment.end()) list.insert(list.end(), found->second->begin(), found->second->end());
      }
      sort_unique(list);
      out.edges.push_back(list);
    }
    for (std::size_t p = 0; p < parts_.points().size(); ++p) {
      const auto found = ids.find(to_[p]);
      out.points.push_back(found == ids.end() ? VertexId::none() : report.vertex_of[found->second.index()]);
    }
    Rational farthest = 0;
    for (std::size_t p = 0; p < at_.size(); ++p) {
      if (at_[p] == to_[p]) continue;
      const RationalPoint d = to_[p] - at_[p];
      farthest = std::max<Rational>(farthest, dot(d, d));
    }
    out.displacement = nearest_root(farthest) * (1 + 0x1p-50);
  }
};

}  // namespace

MovedDrawing move(const Parts& parts, const JoinMoves& moves, const Watch& watch) {
  return Mover(parts, moves, watch).run();
}

}  // namespace cnrg
