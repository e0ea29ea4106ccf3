// `CarriedGroup::Maker` makes a soup of a value. `simplify` unites the cells between which only removed cells lie;
// marks say what must stay apart.
#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "csg/operators/origins.h"
#include "csg/transfer/carried_groups.h"
#include "csg/transfer/marked_cells.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/selection/curve.h"
#include "kernel/selection/simplify.h"

namespace cnrg {
namespace {

std::vector<LeafId> list_of(std::span<const LeafId> leaves) { return {leaves.begin(), leaves.end()}; }

/// Numbers from 0 for keys, in the order in which they come.
template <class Key>
class KeyNumbers {
 public:
  /// The number of a key, and whether it is new.
  std::pair<std::uint32_t, bool> operator()(const Key& key) {
    const auto [it, fresh] = known_.try_emplace(key, static_cast<std::uint32_t>(known_.size()));
    return {it->second, fresh};
  }

 private:
  std::map<Key, std::uint32_t> known_;
};

}  // namespace

class CarriedGroup::Maker {
 public:
  Maker(const Complex& complex, const Group& group, const LeafPlaces& places, CarriedGroup& out)
      : complex_(complex),
        group_(group),
        places_(places),
        out_(out),
        marks_(complex),
        face_origin_(complex.face_count()),
        edge_origin_(complex.edge_count()),
        vertex_origin_(complex.points.size()),
        edge_feature_(complex.edge_count(), 0),
        edge_key_(complex.edge_count(), kNone),
        edge_gone_(complex.edge_count(), 0),
        edge_facets_(complex.edge_count(), 0),
        class_of_(complex.region_count, 0),
        point_(complex.points.size(), kNone),
        dropped_(complex.points.size(), 0),
        source_(complex.sources.size(), kNone),
        wire_(complex.wires.size(), kNone),
        segment_(complex.segment_ends.size(), kNone) {}

  void run() {
    for (const LeafId leaf : IdRange<LeafId>(complex_.leaf_count)) all_.push_back(leaf);
    take_attributes();
    find_classes();
    mark_faces();
    mark_edges();
    mark_vertices();
    Group classes;
    classes.cells.reserve(group_.cells.size());
    for (const auto& [r, region] : group_.cells) classes.cells.emplace_back(r, class_of_[r]);
    classes.regions.resize(out_.classes_.size());
    classes.faces = group_.faces;
    classes.edges = group_.edges;
    classes.vertices = group_.vertices;
    simple_ =
        simplify(complex_, selection_of(complex_, classes), group_.features, SimplifyMode::features, &marks_);
    leaf_ = soup_.add_leaf(Fill::sides);
    drop_vertices();
    add_points();
    for (Index i = 0; i < simple_.faces.size(); ++i) add_face(i);
    for (const auto& edge : simple_.edges) add_edges(edge);
    add_vertices();
    out_.leaf_ = std::make_shared<const GeometryLeaf>(std::move(soup_), std::vector<Attributes>());
  }

 private:
  const Complex& complex_;
  const Group& group_;
  const LeafPlaces& places_;
  CarriedGroup& out_;
  MarkedCells marks_;
  IdVector<FaceId, LeafSetId> face_origin_;  // none() for what is no entity
  IdVector<EdgeId, LeafSetId> edge_origin_;
  IdVector<VertexId, LeafSetId> vertex_origin_;
  IdVector<EdgeId, char> edge_feature_;
  IdVector<EdgeId, Index> edge_key_, edge_gone_, edge_facets_;
  IdVector<RegionId, Index> class_of_;  // from 1
  SimplifiedComplex simple_;
  Soup soup_;
  LeafId leaf_;
  IdVector<VertexId, Index> point_;
  IdVector<VertexId, char> dropped_;
  IdVector<SourceId, Index> source_;
  IdVector<WireId, Index> wire_;
  IdVector<SegmentId, Index> segment_;
  IdVector<EdgeId, Index> walked_by_;
  IdVector<EdgeId, char> slit_;
  KeyNumbers<std::pair<SourceSetId, bool>> covers_;
  KeyNumbers<std::vector<Index>> lists_of_segments_;
  KeyNumbers<std::vector<LeafCell>> lists_of_gone_;
  KeyNumbers<std::pair<SourceId, std::uint32_t>> facets_;  // source, or place among the complex's removed ones
  KeyNumbers<std::vector<Index>> lists_of_facets_;
  std::vector<VertexId> listed_;
  std::vector<LeafId> all_;

  void take_attributes() {
    out_.dominance_ = group_.dominance;
    out_.regions_ = group_.regions;
    const Origins& origins = group_.origins;
    out_.sets_ = origins.sets;
    for (std::size_t i = 0; i < group_.faces.size(); ++i) face_origin_[group_.faces[i]] = origins.faces[i];
    for (std::size_t i = 0; i < group_.edges.size(); ++i) edge_origin_[group_.edges[i]] = origins.edges[i];
    for (std::size_t i = 0; i < group_.vertices.size(); ++i)
      vertex_origin_[group_.vertices[i]] = origins.vertices[i];
    for (const EdgeId e : group_.features.edges) edge_feature_[e] = 1;
  }

  /// 3-cells of one region are of one class if they came from the same regions of leaves.
  void find_classes() {
    KeyNumbers<std::pair<std::uint32_t, LabelSetId>> numbers;
    for (const auto& [r, region] : group_.cells) {
      const auto [number, fresh] = numbers({region, complex_.region_labels[r]});
      class_of_[r] = number + 1;
      if (!fresh) continue;
      Class& made = out_.classes_.emplace_back(Class{region, {}});
      const auto labels = complex_.labels(r);
      made.labels.assign(labels.begin(), labels.end());
    }
  }

  /// Entities and walls between classes stay; pieces of the same input faces, with the same on both sides, are
  /// one.
  void mark_faces() {
    using Side = std::pair<Index, LabelSetId>;
    KeyNumbers<std::tuple<SourceSetId, LeafSetId, Side, Side, std::vector<LeafCell>>> numbers;
    const auto side = [&](RegionId r) { return Side(class_of_[r], complex_.region_labels[r]); };
    const auto mark = [&](FaceId f) {
      const auto& [front, back] = complex_.face_regions[f];
      const auto further = complex_.face_leaf_cells[f];
      marks_.faces[f] = 1 + numbers({complex_.face_cover[f], face_origin_[f], side(front), side(back),
                                     std::vector<LeafCell>(further.begin(), further.end())})
                                .first;
    };
    for (const FaceId f : group_.faces) mark(f);
    for (const auto& [r, region] : group_.cells) {
      for (const HalfFace h : complex_.region_faces[r]) {
        const FaceId f = h.face();
        if (marks_.faces[f] == 0 && class_of_[complex_.region(h.opposite())] != class_of_[r]) mark(f);
      }
    }
  }

  void add_cover(FaceId f, std::vector<LeafCell>& out) const {
    if (marks_.faces[f] == 0) return;
    for (const Cover& x : complex_.cover(f)) {
      const Soup::Face& source = complex_.sources[x.source];
      out.push_back({source.leaf, 2, source.leaf_face});
    }
  }
  void add_wires(EdgeId e, std::vector<LeafCell>& out) const {
    if (edge_key_[e] == kNone) return;
    for (const SegmentId s : complex_.edge_segments[e]) {
      for (const WireId w : complex_.segment_wires[s])
        out.push_back({complex_.wires[w].leaf, 1, complex_.wires[w].leaf_edge});
    }
  }
  /// What held a cell and was removed: all that held it, less what the carried cells around it still tell.
  template <class IdT>
  Index gone(IdT cell) {
    std::vector<LeafCell> carried;
    std::vector<FaceId> faces;
    std::vector<RegionId> regions;
    if constexpr (std::is_same_v<IdT, FaceId>) faces = {cell};
    else complex_.star_faces(cell, faces);
    complex_.star_regions(cell, regions);
    if constexpr (std::is_same_v<IdT, EdgeId>) add_wires(cell, carried);
    if constexpr (std::is_same_v<IdT, VertexId>) {
      for (const EdgeId e : complex_.vertex_edges[cell]) add_wires(e, carried);
      for (const LeafId leaf : complex_.isolated_leaves[cell]) carried.push_back({leaf, 0, 0});
    }
    for (const FaceId f : faces) add_cover(f, carried);
    for (const RegionId r : regions) {
      if (class_of_[r] == 0) continue;
      for (const Label& label : complex_.labels(r)) carried.push_back({label.leaf, 3, label.region});
    }
    sort_unique(carried);
    std::vector<LeafCell> gone = in_first_alone(leaf_cells(complex_, cell, all_), carried);
    const auto [number, fresh] = lists_of_gone_(gone);
    if (fresh) out_.gone_.push_back(std::move(gone));
    return number;
  }

  /// The facets around an edge along a curved surface or a curve that are not carried: what curve it is a piece
  /// of.
  Index removed_facets(EdgeId e) {
    std::vector<Index> list;
    bool curved = has_wire(e);
    const auto see = [&](const Soup::Face& source) {
      curved = curved || source.surface != 0 || source.curved_sides;
    };
    for (const FaceUse& use : complex_.edge_uses[e]) {
      for (const Cover& x : complex_.cover(use.face)) see(complex_.sources[x.source]);
    }
    for (const std::uint32_t k : complex_.edge_removed_facets[e]) see(complex_.removed_facets[k].source);
    if (curved) {
      for (const FaceUse& use : complex_.edge_uses[e]) {
        if (marks_.faces[use.face] != 0) continue;
        for (const Cover& x : complex_.cover(use.face)) {
          const auto [number, fresh] = facets_({x.source, 0});
          const PlaneId plane = complex_.plane(use.face);
          if (fresh) out_.facets_.push_back({complex_.sources[x.source], complex_.points.exact_plane(plane), {}});
          list.push_back(number);
        }
      }
      for (const std::uint32_t k : complex_.edge_removed_facets[e]) {
        const auto [number, fresh] = facets_({SourceId::none(), k});
        if (fresh) out_.facets_.push_back(complex_.removed_facets[k]);
        list.push_back(number);
      }
      sort_unique(list);
    }
    const auto [number, fresh] = lists_of_facets_(list);
    if (fresh) out_.facets_of_.push_back(std::move(list));
    return number;
  }

  bool has_wire(EdgeId e) const {
    const auto segments = complex_.edge_segments[e];
    return std::any_of(segments.begin(), segments.end(),
                       [&](SegmentId s) { return !complex_.segment_wires[s].empty(); });
  }

  /// An edge vanishes if it only parts two pieces of one face.
  void mark_edges() {
    KeyNumbers<std::tuple<std::vector<SegmentId>, LeafSetId, bool, Index, Index>> numbers;
    for (const EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      std::array<FaceId, 2> pair;
      std::size_t count = 0;
      for (const FaceUse& use : complex_.edge_uses[e]) {
        if (marks_.faces[use.face] == 0) continue;
        if (count < 2) pair[count] = use.face;
        ++count;
      }
      if (count == 0 && !edge_origin_[e].valid()) continue;
      const auto segments = complex_.edge_segments[e];
      edge_key_[e] = 0;  // it is carried
      edge_gone_[e] = gone(e);
      edge_facets_[e] = removed_facets(e);
      edge_key_[e] = numbers({std::vector<SegmentId>(segments.begin(), segments.end()), edge_origin_[e],
                              edge_feature_[e] != 0, edge_gone_[e], edge_facets_[e]})
                         .first;
      const bool vanishes = count == 2 && marks_.faces[pair[0]] == marks_.faces[pair[1]] &&
                            edge_feature_[e] == 0 && edge_origin_[e] == face_origin_[pair[0]] && !has_wire(e);
      marks_.edges[e] = vanishes ? 0 : 1 + edge_key_[e];
    }
  }

  void mark_vertices() {
    for (const VertexId v : complex_.vertices) {
      bool stays = !complex_.isolated_leaves[v].empty() || !complex_.curve_ends[v].empty();
      for (const EdgeId e : complex_.vertex_edges[v]) {
        stays = stays || (edge_key_[e] != kNone && edge_origin_[e] != vertex_origin_[v]);
      }
      for (const FaceId f : complex_.vertex_faces[v])
        stays = stays || (marks_.faces[f] != 0 && face_origin_[f] != vertex_origin_[v]);
      marks_.vertices[v] = stays ? 1 : 0;
    }
    for (const VertexId v : group_.features.vertices) marks_.vertices[v] = 1;
  }

  /// All that faces and edges name, in the order of the complex.
  void add_points() {
    std::vector<VertexId> needed;
    for (const auto& edge : simple_.edges) {
      for (const HalfEdge h : edge.chain) {
        for (const VertexId v : complex_.edge_ends[h.edge()]) {
          if (!dropped_[v]) needed.push_back(v);
        }
      }
    }
    for (const auto& vertex : simple_.vertices) needed.push_back(vertex.cell);
    for (const auto& face : simple_.faces) {
      const auto plane = complex_.points.plane_points(complex_.plane(face.cells[0].face()));
      needed.insert(needed.end(), plane.begin(), plane.end());
    }
    sort_unique(needed);
    for (const VertexId v : needed) {
      const double* xyz = complex_.points.doubles(v);
      const PointId p =
          xyz != nullptr ? soup_.add_point(xyz[0], xyz[1], xyz[2]) : soup_.add_point(complex_.points.rational(v));
      point_[v] = p.value();
    }
  }

  Index point(VertexId v) const {
    require(point_[v] != kNone, "carried: a point that no edge has");
    return point_[v];
  }

  /// A vertex between two pieces of one segment that differ in nothing is needed no more.
  void drop_vertices() {
    for (const auto& edge : simple_.edges) {
      for (std::size_t i = 0; i < edge.chain.size(); ++i) {
        if (i + 1 == edge.chain.size() && !edge.closed) break;
        const HalfEdge h = edge.chain[i], next = edge.chain[(i + 1) % edge.chain.size()];
        const bool alike = edge_key_[h.edge()] == edge_key_[next.edge()] && h.edge() != next.edge();
        if (alike && share_segment(complex_, h.edge(), next.edge())) dropped_[complex_.target(h)] = 1;
      }
    }
    walked_by_.assign(complex_.edge_count(), kNone);
    slit_.assign(complex_.edge_count(), 0);
  }

  Index source(SourceId s) {
    Index& known = source_[s];
    if (known != kNone) return known;
    known = static_cast<Index>(out_.sources_.size());
    const Soup::Face& face = complex_.sources[s];
    out_.sources_.push_back({face, places_.faces[s], complex_.leaf_regions[face.leaf]});
    return known;
  }

  Index cover(FaceId f, bool flipped) {
    const auto [number, fresh] = covers_({complex_.face_cover[f], flipped});
    if (fresh) {
      auto& list = out_.covers_.emplace_back();
      for (const Cover& c : complex_.cover(f)) list.emplace_back(source(c.source), c.same != flipped);
    }
    return number;
  }

  void add_face(Index i) {
    const auto& face = simple_.faces[i];
    std::vector<std::vector<PointId>> loops;
    for (const auto& walk : face.loops) {
      auto& loop = loops.emplace_back();
      for (const HalfEdge h : walk) {
        slit_[h.edge()] |= walked_by_[h.edge()] == i ? 1 : 0;
        walked_by_[h.edge()] = i;
        const VertexId v = complex_.origin(h);
        if (!dropped_[v]) loop.push_back(PointId(point(v)));
      }
      if (loop.size() < 3) loops.pop_back();  // a slit alone: its edges are wires
    }
    const HalfFace front = face.cells[0];
    const bool flipped = front.side() == 1;
    const auto& [before, behind] = complex_.face_regions[front.face()];
    soup_.add_face(leaf_, loops, i, i, class_of_[flipped ? behind : before], class_of_[flipped ? before : behind]);
    const auto [a, b, c] = complex_.points.plane_points(complex_.plane(front.face()));
    soup_.set_plane({PointId(point(a)), PointId(point(flipped ? c : b)), PointId(point(flipped ? b : c))});
    out_.faces_.push_back({cover(front.face(), flipped), face_origin_[front.face()], gone(front.face())});
  }

  Index wire(WireId w) {
    Index& known = wire_[w];
    if (known != kNone) return known;
    known = static_cast<Index>(out_.wires_.size());
    out_.wires_.push_back({complex_.wires[w], places_.wires[w]});
    return known;
  }

  /// Of the faces along a segment those that cover something that is carried.
  Index segment(SegmentId s) {
    Index& known = segment_[s];
    if (known != kNone) return known;
    known = static_cast<Index>(out_.segments_.size());
    Segment made;
    for (const SourceId f : complex_.segment_faces[s]) {
      if (source_[f] != kNone) made.sources.push_back(source_[f]);
    }
    for (const WireId w : complex_.segment_wires[s]) made.wires.push_back(wire(w));
    out_.segments_.push_back(std::move(made));
    return known;
  }

  /// The pieces of a chain from one point that stays to the next.
  void add_edges(const SimplifiedComplex::Edge& edge) {
    const std::size_t n = edge.chain.size();
    std::size_t begin = 0;
    while (edge.closed && begin < n && dropped_[complex_.origin(edge.chain[begin])]) ++begin;
    VertexId from = complex_.origin(edge.chain[begin % n]);
    for (std::size_t k = 0; k < n; ++k) {
      const HalfEdge h = edge.chain[(begin + k) % n];
      const VertexId to = complex_.target(h);
      if (dropped_[to] && k + 1 < n) continue;
      const EdgeId e = h.edge();
      std::vector<Index> segments;
      for (const SegmentId s : complex_.edge_segments[e]) segments.push_back(segment(s));
      const auto [number, fresh] = lists_of_segments_(segments);
      if (fresh) out_.segments_of_.push_back(std::move(segments));
      const Index a = point(from), b = point(to);
      if (walked_by_[e] == kNone || slit_[e])
        soup_.add_wire(leaf_, PointId(a), PointId(b), static_cast<Index>(out_.edges_.size()));
      out_.edges_.push_back(
          {{a, b}, number, edge_origin_[e], edge_feature_[e] != 0, edge_gone_[e], edge_facets_[e]});
      listed_.push_back(from), listed_.push_back(to);
      from = to;
    }
  }

  void add_vertices() {
    sort_unique(listed_);
    std::vector<VertexId> alone;
    for (const auto& vertex : simple_.vertices) {
      if (!std::binary_search(listed_.begin(), listed_.end(), vertex.cell)) alone.push_back(vertex.cell);
    }
    for (const VertexId v : alone) soup_.add_isolated(leaf_, PointId(point(v)));
    listed_.insert(listed_.end(), alone.begin(), alone.end());
    for (const VertexId v : listed_) {
      const auto& features = group_.features.vertices;
      out_.vertices_.push_back({point(v), vertex_origin_[v],
                                std::binary_search(features.begin(), features.end(), v), gone(v),
                                list_of(complex_.isolated_leaves[v]), list_of(complex_.curve_ends[v])});
    }
  }
};

CarriedGroup::CarriedGroup(const Complex& complex, const Group& group, const LeafPlaces& places) {
  require(!complex.frame.valid(), "carried: a value with a frame");
  Maker(complex, group, places, *this).run();
}

}  // namespace cnrg
