#include "csg/picture/cells.h"

#include <algorithm>
#include <map>

#include "csg/picture/loops.h"
#include "kernel/base/limits.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using Index = PictureCells::Index;

/// Cells and a plane in one complex. Faces name the regions on their sides, so that the kernel knows the region of
/// each piece of the plane.
class Cutter {
 public:
  Cutter(const PictureCells& cells, const DrawOptions::Cut& plane, const RationalPoint& towards, int threads)
      : cells_(cells), normal_(plane.normal), offset_(plane.offset) {
    if (dot(normal_, towards) < 0) {
      for (Rational& x : normal_) x = -x;
      offset_ = -offset_;
    }
    Soup soup;
    const LeafId model = soup.add_leaf(Fill::sides);
    std::vector<PointId> points;
    for (const RationalPoint& p : cells.points) points.push_back(soup.add_point(p));
    for (Index i = 0; i < cells.faces.size(); ++i) {
      const PictureCells::Face& face = cells.faces[i];
      for (const auto& facet : face.facets) {
        soup.add_face(model, soup_loops(facet, [&](Index p) { return points[p]; }), i, i, label(face.regions[0]),
                      label(face.regions[1]));
      }
    }
    for (Index i = 0; i < cells.edges.size(); ++i) {
      for (const auto& [a, b] : cells.edges[i].segments) soup.add_wire(model, points[a], points[b], i);
    }
    for (const PictureCells::Vertex& v : cells.vertices) soup.add_isolated(model, points[v.point]);
    knife_ = soup.add_leaf(Fill::none);
    std::vector<std::vector<PointId>> loops(1);
    for (const RationalPoint& p : knife()) loops[0].push_back(soup.add_point(p));
    soup.add_face(knife_, loops, 0, 0);
    complex_ = build_complex(soup, {threads});
  }

  PictureCells run() {
    keep_vertices();
    for (const FaceId f : IdRange<FaceId>(complex_->face_count())) keep_face(f);
    for (const EdgeId e : IdRange<EdgeId>(complex_->edge_count())) keep_edge(e);
    for (Index i = 0; i < segments_.size(); ++i) {
      const PictureCells::Edge& edge = cells_.edges[i];
      if (!segments_[i].empty()) out_.edges.push_back({edge.edge, edge.regions, std::move(segments_[i])});
    }
    for (auto& [regions, segments] : cuts_) out_.edges.push_back({kNone, regions, std::move(segments)});
    return std::move(out_);
  }

 private:
  const PictureCells& cells_;
  RationalPoint normal_;
  Rational offset_;
  LeafId knife_;
  std::shared_ptr<const Complex> complex_;
  IdVector<VertexId, int> side_;  // 1: cut away, 0: in the plane
  IdVector<VertexId, Index> number_;
  std::vector<std::vector<std::array<Index, 2>>> segments_;  // by edge of cells_
  std::vector<char> kept_face_;
  std::map<std::pair<Index, std::array<Index, 2>>, Index> pieces_;        // of a face between two regions, in out_
  std::map<std::vector<Index>, std::vector<std::array<Index, 2>>> cuts_;  // new lines by the regions about them
  PictureCells out_;

  static std::uint32_t label(Index region) { return region == kNone ? 0 : region + 1; }
  Index region(RegionId r) const {
    const auto labels = complex_->labels(r);
    return labels.empty() ? kNone : labels.front().region - 1;
  }

  /// A parallelogram in the plane, over the box of all points along the plane's steepest axis, and a little more.
  std::vector<RationalPoint> knife() const {
    const std::size_t axis = steepest_axis(normal_), u = (axis + 1) % 3, v = (axis + 2) % 3;
    RationalPoint low = cells_.points.front(), high = low;
    for (const RationalPoint& p : cells_.points) {
      for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    }
    std::vector<RationalPoint> out;
    for (const auto& [right, upper] : {std::pair(false, false), {true, false}, {true, true}, {false, true}}) {
      RationalPoint p;
      p[u] = right ? Rational(high[u] + 1) : Rational(low[u] - 1);
      p[v] = upper ? Rational(high[v] + 1) : Rational(low[v] - 1);
      p[axis] = (offset_ - normal_[u] * p[u] - normal_[v] * p[v]) / normal_[axis];
      out.push_back(p);
    }
    return out;
  }

  void keep_vertices() {
    side_.assign(complex_->points.size(), 0);
    number_.assign(complex_->points.size(), kNone);
    segments_.resize(cells_.edges.size());
    kept_face_.assign(complex_->face_count(), 0);
    std::map<RationalPoint, Index> wanted;  // vertices of the node by place
    for (const PictureCells::Vertex& v : cells_.vertices) wanted.emplace(cells_.points[v.point], v.vertex);
    for (const VertexId v : complex_->vertices) {
      const RationalPoint p = complex_->points.rational(v);
      side_[v] = cmp(dot(normal_, p), offset_);
      const auto found = wanted.find(p);
      if (side_[v] <= 0 && found != wanted.end()) out_.vertices.push_back({found->second, number(v)});
    }
  }

  Index number(VertexId v) {
    if (number_[v] == kNone) {
      number_[v] = static_cast<Index>(out_.points.size());
      out_.points.push_back(complex_->points.rational(v));
    }
    return number_[v];
  }

  /// -1: kept, 0: in the plane, 1: cut away. A cell has no corners on both sides.
  int side(FaceId f) const {
    int out = 0;
    for (const HalfEdge h : complex_->half_edges(f)) out = out != 0 ? out : side_[complex_->origin(h)];
    return out;
  }

  void keep_face(FaceId f) {
    const int where = side(f);
    if (where > 0) return;
    Index of = kNone;
    std::array<Index, 2> regions{};
    bool is_model = false;
    for (const Cover& cover : complex_->cover(f)) {
      const Soup::Face& source = complex_->sources[cover.source];
      if (source.leaf == knife_) continue;
      is_model = true;
      of = cells_.faces[source.leaf_face].face;
    }
    for (const unsigned s : {0U, 1U}) regions[s] = region(complex_->region(HalfFace(f, s)));
    if (where == 0) {
      // The side of the face that looks to what was cut away.
      const ExactPlane& plane = complex_->points.exact_plane(complex_->plane(f));
      const bool front = sgn(normal_[0] * plane.a + normal_[1] * plane.b + normal_[2] * plane.c) > 0;
      regions[front ? 0 : 1] = kNone;
      if (!is_model && regions[front ? 1 : 0] == kNone) return;
    }
    kept_face_[f.index()] = is_model && where != 0 ? 1 : 0;
    auto loops = facet_loops<FlatComplex::Loop>(*complex_, f, [&](VertexId v) { return number(v); });
    // A piece that looks the other way than the first of its face is turned.
    auto at = pieces_.find({of, regions});
    if (const auto turned = pieces_.find({of, {regions[1], regions[0]}});
        at == pieces_.end() && turned != pieces_.end() && regions[0] != regions[1]) {
      turn(loops);
      at = turned;
    }
    if (at == pieces_.end()) {
      at = pieces_.emplace(std::pair(of, regions), static_cast<Index>(out_.faces.size())).first;
      out_.faces.push_back({of, regions, {}});
    }
    out_.faces[at->second].facets.push_back(std::move(loops));
  }

  void keep_edge(EdgeId e) {
    const auto& [a, b] = complex_->edge_ends[e];
    if (side_[a] > 0 || side_[b] > 0) return;
    bool known = false;
    for (const SegmentId s : complex_->edge_segments[e]) {
      for (const WireId w : complex_->segment_wires[s]) {
        if (known) continue;
        segments_[complex_->wires[w].leaf_edge].push_back({number(a), number(b)});
        known = true;
      }
    }
    if (known || side_[a] != 0 || side_[b] != 0) return;
    const auto uses = complex_->edge_uses[e];
    std::vector<Index> about;
    for (const FaceUse& use : uses) {
      if (kept_face_[use.face.index()] == 0) continue;
      for (const RegionId r : complex_->face_regions[use.face]) about.push_back(region(r));
    }
    if (about.empty()) return;
    sort_unique(about);
    cuts_[about].push_back({number(a), number(b)});
  }
};

}  // namespace

PictureCells picture_cells(const Complex& complex, const FlatComplex& flat) {
  PictureCells out;
  for (const VertexId v : flat.points) out.points.push_back(complex.points.rational(v));
  for (Index i = 0; i < flat.faces.size(); ++i) {
    const FlatComplex::Face& face = flat.faces[i];
    PictureCells::Face& shown = out.faces.emplace_back();
    shown.face = i;
    for (std::size_t s = 0; s < 2; ++s) shown.regions[s] = flat.active(face.regions[s]) ? face.regions[s] : kNone;
    if (face.facets.empty()) {
      std::vector<FlatComplex::Loop> loops = face.loops;
      drop_slits(loops);
      shown.facets.push_back(std::move(loops));
    }
    for (const FlatComplex::Facet& facet : face.facets) shown.facets.push_back(facet.loops);
  }
  for (Index i = 0; i < flat.edges.size(); ++i) {
    const FlatComplex::Edge& edge = flat.edges[i];
    PictureCells::Edge& shown = out.edges.emplace_back();
    shown.edge = i;
    for_each_segment(edge, [&](Index a, Index b) { shown.segments.push_back({a, b}); });
  }
  for (Index i = 0; i < flat.vertices.size(); ++i) out.vertices.push_back({i, flat.vertices[i].point});
  return out;
}

PictureCells cut(const PictureCells& cells, const DrawOptions::Cut& plane, const RationalPoint& towards,
                 int threads) {
  if (cells.points.empty()) return cells;
  return Cutter(cells, plane, towards, threads).run();
}

}  // namespace cnrg
