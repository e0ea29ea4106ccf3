// Cells are taken in canonical order (kernel/selection/canonical.h); faces become loops and facets of point
// numbers, are turned so that their front is the outside, and are cut into triangles.
#include "csg/result/flat.h"

#include <algorithm>
#include <span>

#include "csg/geometry/canonical_loop.h"
#include "csg/operators/cell_sources.h"
#include "csg/result/file_numbers.h"
#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/base/parallel.h"
#include "kernel/base/per_thread.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/triangulate.h"
#include "kernel/selection/canonical.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;
using Loop = FlatComplex::Loop;

class Flattener {
 public:
  Flattener(const ResultView& view, Flattening what)
      : view_(view),
        whole_(what == Flattening::whole),
        shapes_(what == Flattening::shapes),
        drawn_(what != Flattening::cells),
        complex_(*view.complex),
        own_(view.simplified->points.empty() ? *view.simplified : SimplifiedComplex()),
        simple_(view.simplified->points.empty() ? own_ : *view.simplified),
        points_(simple_.points.empty() ? cnrg::put_in_order(complex_, own_)
                                       : CanonicalPoints(complex_, simple_.points)),
        of_group_(view.value->is_group() ? components_of(complex_, view.value->group()) : Components{}),
        value_(view.value->is_group() ? of_group_ : view.value->components()),
        sources_(complex_, value_) {
    if (view.leaves == nullptr) return;
    const std::vector<LeafId> order = in_order_of_place(*view.leaves);
    by_number_ = std::is_sorted(order.begin(), order.end());
  }

  FlatComplex run() {
    count_walks();
    number_points();
    make_regions();
    make_faces();
    make_edges();
    make_vertices();
    turn_shells();
    return std::move(flat_);
  }

 private:
  const ResultView& view_;
  const bool whole_, shapes_, drawn_;
  const Complex& complex_;
  SimplifiedComplex own_;            // what is given if that is not in order
  const SimplifiedComplex& simple_;  // in canonical order
  const CanonicalPoints points_;
  const Components of_group_;  // a group as components
  const Components& value_;
  const ComponentSources sources_;
  bool by_number_ = true;  // leaves are in the order of their numbers
  FlatComplex flat_;
  IdVector<EdgeId, Index> edge_of_;  // simplified edge that holds an edge of the complex
  IdVector<FaceId, Index> front_;    // the side of a face of the complex that is the front of the simplified one
  std::vector<unsigned> walks_;      // how often listed faces walk each simplified edge
  std::vector<char> slit_, holds_regions_;  // by simplified edge; by component
  std::vector<unsigned char> flipped_;      // faces whose front is not that of the simplified complex

  void count_walks() {
    edge_of_.assign(complex_.edge_count(), kNone);
    for (Index i = 0; i < simple_.edges.size(); ++i) {
      for (const HalfEdge h : simple_.edges[i].chain) edge_of_[h.edge()] = i;
    }
    walks_.assign(simple_.edges.size(), 0);
    slit_.assign(simple_.edges.size(), 0);
    IdVector<EdgeId, Index> walked_by(complex_.edge_count(), kNone);  // the last face
    for (Index i = 0; i < simple_.faces.size(); ++i) {
      for (const auto& loop : simple_.faces[i].loops) {
        for (const HalfEdge h : loop) {
          const Index e = edge_of_[h.edge()];
          if (e == kNone) continue;  // on the frame
          ++walks_[e];
          if (walked_by[h.edge()] == i) slit_[e] = 1;
          walked_by[h.edge()] = i;
        }
      }
    }
  }

  void number_points() {
    flat_.points = points_.points();
    for (Index i = 0; i < flat_.points.size(); ++i) {
      if (complex_.on_frame(flat_.points[i])) flat_.frame_points.push_back(i);
    }
  }

  void make_regions() {
    const auto sets = sets_of(complex_.region_count, value_.selection.regions, value_.origins.regions);
    holds_regions_.assign(value_.attributes.size() + 1, 0);
    for (const auto& region : simple_.regions) {
      holds_regions_[region.component] = 1;
      flat_.regions.push_back({region.component, region.bounded, region.shells, region.cells, {}});
      if (!drawn_) continue;
      auto& origin = flat_.regions.back().origin;
      origin = origin_of(sets, region.cells);
      finish(origin);
    }
  }

  static RegionId id_of(RegionId r) { return r; }
  static FaceId id_of(HalfFace h) { return h.face(); }
  static EdgeId id_of(HalfEdge h) { return h.edge(); }
  static VertexId id_of(VertexId v) { return v; }

  /// By cell of the complex, of those that are active.
  template <class IdT>
  static IdVector<IdT, LeafSetId> sets_of(std::size_t count, const std::vector<std::pair<IdT, Component>>& list,
                                          const std::vector<LeafSetId>& sets) {
    IdVector<IdT, LeafSetId> out(count, LeafSetId::none());
    for (std::size_t k = 0; k < list.size(); ++k) out[list[k].first] = sets[k];
    return out;
  }

  /// Of a cell of the result that unites `cells` of the complex. The cells of a region share one set of all its
  /// leaves, which may be as many as the cells: so each set is taken once, not once for each cell.
  template <class IdT, class Cells>
  FlatComplex::Provenance origin_of(const IdVector<IdT, LeafSetId>& sets, const Cells& cells) const {
    struct Lists {
      std::vector<LeafSetId> from;
      std::vector<LeafId> of;
      std::vector<LeafCell> on;
    };
    auto& [from, of, on] = PerThread<Lists>::own();
    from.clear(), of.clear(), on.clear();
    for (const auto& cell : cells) {
      const IdT id = id_of(cell);
      const LeafSetId set = sets[id];
      if (!set.valid()) continue;
      if (from.empty() || from.back() != set) from.push_back(set);
      append_leaf_cells(complex_, id, value_.origins.sets[set], on);
    }
    sort_unique(from);
    for (const LeafSetId set : from) {
      const auto leaves = value_.origins.sets[set];
      of.insert(of.end(), leaves.begin(), leaves.end());
    }
    if (from.size() > 1) sort_unique(of);
    sort_unique(on);
    return {{of.begin(), of.end()}, {on.begin(), on.end()}};
  }

  static LeafId leaf_of(LeafId leaf) { return leaf; }
  static LeafId leaf_of(const LeafCell& cell) { return cell.leaf; }
  /// Of a patch, or of what comes with one.
  static LeafId leaf_of(const auto& of) { return leaf_of(of.first); }

  /// By the places of leaves.
  template <class List>
  void put_in_order_of_place(List& list) const {
    if (by_number_) return;
    std::ranges::stable_sort(list, {}, [&](const auto& of) { return view_.place(leaf_of(of)); });
  }

  /// The last word on an origin: its lists are ascending until then.
  void finish(FlatComplex::Provenance& origin) const {
    name_makers(origin);
    put_in_order_of_place(origin.leaves), put_in_order_of_place(origin.cells);
  }

  /// What a joined leaf stands for is in its place (csg/evaluate/leaf_numbers.h).
  void name_makers(FlatComplex::Provenance& origin) const {
    if (view_.leaves == nullptr) return;
    std::vector<LeafId> named;
    for (auto it = origin.leaves.begin(); it != origin.leaves.end(); ++it) {
      const std::uint32_t makers = it->index() < view_.leaves->size() ? (*view_.leaves)[it->index()].makers : 0;
      const bool told =
          makers > 0 && std::next(it) != origin.leaves.end() && std::next(it)->value() <= it->value() + makers;
      if (told) named.push_back(*it);
    }
    if (named.empty()) return;
    const auto drop_named = [&](auto& list) {
      const auto is_named = [&](const auto& of) { return std::ranges::binary_search(named, leaf_of(of)); };
      list = {list.begin(), std::remove_if(list.begin(), list.end(), is_named)};
    };
    drop_named(origin.leaves), drop_named(origin.cells);
  }

  template <class Range>
  Loop loop_of(const Range& half_edges) const {
    Loop loop;
    for (const HalfEdge h : half_edges) {
      const Index p = points_.number(complex_.origin(h));
      if (p != kNone) loop.push_back(p);
    }
    return loop;
  }

  /// The loops and isolated points of a face or facet, as seen from the front of its cells.
  template <class Cell, class Walks, class Points>
  void set_boundary(Cell& cell, const Walks& walks, const Points& isolated) const {
    for (const auto& walk : walks) cell.loops.push_back(loop_of(walk));
    put_in_order(cell.loops);
    for (const VertexId v : isolated) {
      if (points_.number(v) != kNone) cell.isolated.push_back(points_.number(v));
    }
    std::sort(cell.isolated.begin(), cell.isolated.end());
  }

  /// So that the cell's front is seen.
  Projection projection(HalfFace cell) const {
    const Projection front = projection_of(complex_.points.exact_plane(complex_.plane(cell.face())));
    return cell.side() == 0 ? front : Projection{front.v, front.u};
  }

  void add_triangles(HalfFace cell, const std::vector<Loop>& loops, std::span<const Index> isolated,
                     ShortList<FlatComplex::Triangle, 1>& triangles) const {
    if (!drawn_) return;
    if (loops.size() == 1 && loops[0].size() == 3 && isolated.empty()) {
      triangles.push_back({loops[0][0], loops[0][1], loops[0][2]});
      return;
    }
    std::vector<std::vector<VertexId>> walks;
    for (const Loop& loop : loops) {
      auto& walk = walks.emplace_back();
      for (const Index p : loop) walk.push_back(flat_.points[p]);
    }
    std::vector<VertexId> inner;
    for (const Index p : isolated) inner.push_back(flat_.points[p]);
    std::vector<std::array<Index, 3>> here;
    for (const auto& t : triangulate(complex_.points, projection(cell), walks, inner)) {
      std::array<Index, 3> n{points_.number(t[0]), points_.number(t[1]), points_.number(t[2])};
      std::rotate(n.begin(), std::min_element(n.begin(), n.end()), n.end());
      here.push_back(n);
    }
    std::sort(here.begin(), here.end());
    triangles.append(here.begin(), here.end());
  }

  struct OrderedFacet {
    Loop points;  ///< of its loops, sorted: the same whichever side is the front
    FlatComplex::Facet facet;
    ShortList<HalfFace, 2> cells;
  };

  std::vector<OrderedFacet> ordered_facets(Index face) const {
    std::vector<OrderedFacet> out;
    for (SimplifiedFacet& from : facets_of(complex_, simple_, face)) {
      OrderedFacet& to = out.emplace_back();
      set_boundary(to.facet, from.walks, from.isolated);
      to.cells = std::move(from.cells);
      for (const Loop& loop : to.facet.loops) to.points.append(loop.begin(), loop.end());
      std::sort(to.points.begin(), to.points.end());
    }
    std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.points < b.points; });
    return out;
  }

  void make_faces() {
    const auto sets = sets_of(complex_.face_count(), value_.selection.faces, value_.origins.faces);
    flipped_.assign(simple_.faces.size(), 0);
    flat_.faces.resize(simple_.faces.size());
    for_each_index(simple_.faces.size(), [&](std::size_t i) {
      const auto& from = simple_.faces[i];
      FlatComplex::Face& face = flat_.faces[i];
      face.component = from.component;
      face.regions = from.regions;
      set_boundary(face, from.loops, from.isolated);
      const bool flat = is_flat(complex_, from);
      std::vector<OrderedFacet> facets;
      if (!flat) facets = ordered_facets(Index(i));
      const HalfFace first = flat ? from.cells[0] : facets[0].cells[0];
      flipped_[i] = must_flip(face, first);
      if (flipped_[i]) flip(face, facets);
      if (flat) add_triangles(flipped_[i] ? first.opposite() : first, face.loops, face.isolated, face.triangles);
      for (auto& [points, facet, cells] : facets) {
        const HalfFace cell = flipped_[i] ? cells[0].opposite() : cells[0];
        add_triangles(cell, facet.loops, facet.isolated, face.triangles);
        face.facets.push_back(std::move(facet));
        face.facet_ends.push_back(Index(face.triangles.size()));
      }
      face.entity = from.component != 0 && !inside_component(from.component, from.regions);
      face.own = face.entity || sources_.said(from.cells[0].face()) != nullptr;
      if (!whole_) return;
      face.origin = origin_of(sets, from.cells);
      face.origin.said = sources_.said(from.cells[0].face());
      face.patch = patch_of(from, face.origin.leaves);
      face.surface = surface_of(from, face);
      if (view_.parameters != nullptr) {
        if (face.patch) add_cells(face, facets, from);
        else if (face.surface != 0) add_cells_of_patches(face, from);
      }
      finish(face.origin);
    });
  }

  void add_cells(FlatComplex::Face& face, const std::vector<OrderedFacet>& facets,
                 const SimplifiedComplex::Face& from) const {
    if (!view_.parameters->has(face.patch->first)) return;
    if (!std::binary_search(face.origin.leaves.begin(), face.origin.leaves.end(), face.patch->first)) return;
    const auto add = [&](FaceId f, std::vector<std::vector<PatchCorner>>& list) {
      for (PlacedCell& cell : view_.parameters->cells(f, std::span(&face.patch->first, 1))) {
        if (cell.patch == face.patch->second) list.push_back(std::move(cell.corners));
      }
    };
    if (face.facets.empty()) {
      face.cells.emplace_back();
      for (const HalfFace cell : from.cells) add(cell.face(), face.cells[0]);
    } else {
      for (const OrderedFacet& facet : facets) {
        auto& list = face.cells.emplace_back();
        for (const HalfFace cell : facet.cells) add(cell.face(), list);
      }
    }
    for (auto& list : face.cells) sort_unique(list);
    if (std::ranges::all_of(face.cells, [](const auto& list) { return list.empty(); })) face.cells.clear();
  }

  /// True if the cover is of a leaf that the face came from; all are where none is.
  bool is_own(const FlatComplex::Face& face, const Cover& cover) const {
    const auto& leaves = face.origin.leaves;
    return leaves.empty() || std::binary_search(leaves.begin(), leaves.end(), complex_.sources[cover.source].leaf);
  }

  /// The surface of the patch, or else one that all cells have, that of the first patch.
  std::uint32_t surface_of(const SimplifiedComplex::Face& from, const FlatComplex::Face& face) const {
    if (complex_.surface_count == 0) return 0;
    const std::span<const Cover> covers = complex_.cover(from.cells[0].face());
    if (face.patch) {
      for (const Cover& cover : covers) {
        const Soup::Face& source = complex_.sources[cover.source];
        if (FlatComplex::Patch{source.leaf, source.patch} == *face.patch) return source.surface;
      }
    }
    const auto& all = common_of<std::uint32_t>(from, [&](const Cover& cover, const Soup::Face& source) {
      return source.surface != 0 && is_own(face, cover) ? std::optional(source.surface) : std::nullopt;
    });
    if (all.size() < 2) return all.empty() ? 0 : all[0];
    const Soup::Face* first = nullptr;
    for (const Cover& cover : covers) {
      const Soup::Face& source = complex_.sources[cover.source];
      const auto key = [&](const Soup::Face& of) { return std::pair(view_.place(of.leaf), of.patch); };
      const bool fits = is_own(face, cover) && std::binary_search(all.begin(), all.end(), source.surface);
      if (fits && (first == nullptr || key(source) < key(*first))) first = &source;
    }
    return first->surface;
  }

  void add_cells_of_patches(FlatComplex::Face& face, const SimplifiedComplex::Face& from) const {
    for (const HalfFace cell : from.cells) {
      for (const Cover& cover : complex_.cover(cell.face())) {
        const Soup::Face& source = complex_.sources[cover.source];
        if (source.surface != face.surface || !is_own(face, cover)) continue;
        for (PlacedCell& placed : view_.parameters->cells(cell.face(), std::span(&source.leaf, 1))) {
          if (placed.patch == source.patch)
            face.cells_of_patches.emplace_back(FlatComplex::Patch{source.leaf, source.patch},
                                               std::move(placed.corners));
        }
        break;
      }
    }
    sort_unique(face.cells_of_patches);
    put_in_order_of_place(face.cells_of_patches);
  }

  /// The front is the outside, else where the normal of the first cell is lexicographically positive.
  bool must_flip(const FlatComplex::Face& face, HalfFace first) const {
    const bool front = flat_.active(face.regions[0]), back = flat_.active(face.regions[1]);
    if (front != back) return front;
    for (int k = 0; k < 3; ++k) {
      const int sign = normal_sign(complex_.points, complex_.plane(first.face()), k);
      if (sign != 0) return (sign < 0) == (first.side() == 0);
    }
    return false;
  }

  static void flip(FlatComplex::Face& face, std::vector<OrderedFacet>& facets) {
    const auto reverse_all = [](std::vector<Loop>& loops) {
      for (Loop& loop : loops) std::reverse(loop.begin(), loop.end());
      put_in_order(loops);
    };
    reverse_all(face.loops);
    std::swap(face.regions[0], face.regions[1]);
    for (OrderedFacet& facet : facets) reverse_all(facet.facet.loops);
  }

  template <class Regions>
  bool inside_component(Component component, const Regions& regions) const {
    return std::ranges::all_of(regions, [&](auto region) {
      const Index r = region_index(region);
      return r != kNone && simple_.regions[r].component == component;
    });
  }

  /// Of an edge or vertex: is it more than the interior of a region of its component?
  template <class Cell, class IdT>
  void set_entity(Cell& cell, IdT id) const {
    cell.entity = cell.component != 0;
    if (cell.entity && holds_regions_[cell.component]) {
      std::vector<RegionId> regions;
      complex_.star_regions(id, regions);
      cell.entity = !inside_component(cell.component, regions);
    }
    cell.own = cell.entity || sources_.said(id) != nullptr;
  }

  static Index region_index(Index region) { return region; }
  Index region_index(RegionId region) const {
    const auto place = simple_.region_place[region.index()];
    return place.dimension == 3 && place.index < simple_.regions.size() ? place.index : kNone;
  }

  /// What `value` finds at covers of every cell of the face, ascending; until the next call in this thread.
  template <class T, class Value>
  const std::vector<T>& common_of(const SimplifiedComplex::Face& face, Value value) const {
    struct Lists {
      std::vector<T> common, here;
    };
    auto& [common, here] = PerThread<Lists>::own();
    common.clear();
    for (std::size_t i = 0; i < face.cells.size(); ++i) {
      here.clear();
      for (const Cover& cover : complex_.cover(face.cells[i].face())) {
        if (const std::optional<T> found = value(cover, complex_.sources[cover.source])) here.push_back(*found);
      }
      keep_common(common, here, i == 0);
      if (common.empty()) break;
    }
    return common;
  }

  /// The first patch of `leaves` that covers all cells of the face. Patches of other leaves made no face one, so a
  /// reader must not make one of them.
  std::optional<FlatComplex::Patch> patch_of(const SimplifiedComplex::Face& face,
                                             std::span<const LeafId> leaves) const {
    const auto& common = common_of<FlatComplex::Patch>(face, [&](const Cover&, const Soup::Face& source) {
      return source.leaf == complex_.frame ? std::nullopt
                                           : std::optional(FlatComplex::Patch{source.leaf, source.patch});
    });
    std::optional<FlatComplex::Patch> first;
    for (const FlatComplex::Patch& patch : common) {
      if (!std::binary_search(leaves.begin(), leaves.end(), patch.first)) continue;
      if (!first || view_.place(patch.first) < view_.place(first->first)) first = patch;
    }
    return first;
  }

  void make_edges() {
    const auto sets = sets_of(complex_.edge_count(), value_.selection.edges, value_.origins.edges);
    front_.assign(complex_.face_count(), 0);
    for (const auto& face : simple_.faces) {
      for (const HalfFace cell : face.cells) front_[cell.face()] = Index(cell.side());
    }
    flat_.edges.resize(simple_.edges.size());
    for_each_index(simple_.edges.size(), [&](std::size_t i) {
      const auto& from = simple_.edges[i];
      FlatComplex::Edge& edge = flat_.edges[i];
      edge.component = from.component;
      edge.wire = walks_[i] == 0;
      edge.slit = slit_[i];
      if (shapes_ && !edge.wire && !edge.slit && flat_.frame_points.empty()) return;
      edge.points = loop_of(from.chain);
      edge.closed = from.closed;
      if (edge.closed) {
        rotate_to_least(edge.points);
        if (edge.points.size() > 2 && edge.points.back() < edge.points[1]) {
          std::reverse(edge.points.begin() + 1, edge.points.end());
        }
      } else {
        const Index last = points_.number(complex_.target(from.chain.back()));
        if (last != kNone) edge.points.push_back(last);
        Loop reversed(edge.points.rbegin(), edge.points.rend());
        if (reversed < edge.points) edge.points = std::move(reversed);
      }
      const EdgeId first = from.chain[0].edge();
      set_entity(edge, first);
      if (edge.wire) edge.region = region_index(complex_.some_region(first));
      const auto& features = value_.features.edges;
      edge.feature = std::ranges::all_of(
          from.chain, [&](HalfEdge h) { return std::ranges::binary_search(features, h.edge()); });
      if (!whole_) return;
      edge.origin = origin_of(sets, from.chain);
      edge.origin.said = sources_.said(first);
      add_carriers(edge, from);
      finish(edge.origin);
    });
  }

  void add_carriers(FlatComplex::Edge& edge, const SimplifiedComplex::Edge& from) const {
    for (const FaceUse& use : complex_.edge_uses[from.chain[0].edge()]) {
      const SimplifiedComplex::Place place = simple_.face_place[use.face.index()];
      if (place.dimension != 2 || place.index >= simple_.faces.size()) continue;
      const Index side = Index(use.before().side()) ^ front_[use.face];
      edge.around.push_back(place.index * 2 + (side ^ flipped_[place.index]));
    }
    if (view_.parameters == nullptr) return;
    const auto counts = [&](LeafId leaf) {
      return leaf != complex_.frame &&
             std::binary_search(edge.origin.leaves.begin(), edge.origin.leaves.end(), leaf);
    };
    struct Lists {
      std::vector<FlatComplex::Patch> around, on, patches, curves;
    };
    auto& [around, on, patches, curves] = PerThread<Lists>::own();
    patches.clear(), curves.clear();
    for (std::size_t i = 0; i < from.chain.size(); ++i) {
      const EdgeId e = from.chain[i].edge();
      around.clear(), on.clear();
      for (const FaceUse& use : complex_.edge_uses[e]) {
        for (const Cover& cover : complex_.cover(use.face)) {
          const Soup::Face& source = complex_.sources[cover.source];
          if (counts(source.leaf)) around.push_back({source.leaf, source.patch});
        }
      }
      for (const SegmentId s : complex_.edge_segments[e]) {
        for (const WireId w : complex_.segment_wires[s]) {
          const Soup::Wire& wire = complex_.wires[w];
          if (counts(wire.leaf)) on.push_back({wire.leaf, wire.leaf_edge});
        }
      }
      keep_common(patches, around, i == 0);
      keep_common(curves, on, i == 0);
    }
    put_in_order_of_place(patches);
    put_in_order_of_place(curves);
    edge.patches = {patches.begin(), patches.end()};
    if (!curves.empty()) edge.curve = curves.front();
  }

  template <class T>
  static void keep_common(std::vector<T>& list, std::vector<T>& other, bool first) {
    sort_unique(other);
    if (first) return list.assign(other.begin(), other.end());
    std::erase_if(list, [&](const T& item) { return !std::binary_search(other.begin(), other.end(), item); });
  }

  void make_vertices() {
    std::vector<char> on_edge(flat_.points.size(), 0), in_face(flat_.points.size(), 0);
    const auto mark = [&](VertexId v) {
      if (points_.number(v) != kNone) on_edge[points_.number(v)] = 1;
    };
    for (const auto& edge : simple_.edges) {
      for (const HalfEdge h : edge.chain) mark(complex_.origin(h));
      mark(complex_.target(edge.chain.back()));
    }
    for (const auto& face : flat_.faces) {
      for (const Index p : face.isolated) in_face[p] = 1;
    }
    const auto sets = sets_of(complex_.points.size(), value_.selection.vertices, value_.origins.vertices);
    flat_.vertices.resize(simple_.vertices.size());
    for_each_index(simple_.vertices.size(), [&](std::size_t i) {
      const auto& from = simple_.vertices[i];
      FlatComplex::Vertex& vertex = flat_.vertices[i];
      vertex.point = points_.number(from.cell);
      vertex.component = from.component;
      vertex.free = !on_edge[vertex.point];
      if (shapes_ && !vertex.free) return;
      set_entity(vertex, from.cell);
      if (vertex.free && !in_face[vertex.point]) vertex.region = region_index(complex_.some_region(from.cell));
      const auto& features = value_.features.vertices;
      vertex.feature = std::binary_search(features.begin(), features.end(), from.cell);
      if (!whole_) return;
      vertex.origin = origin_of(sets, std::span(&from.cell, 1));
      vertex.origin.said = sources_.said(from.cell);
      finish(vertex.origin);
    });
  }

  /// Names the sides of faces in shells by the fronts that the faces have now.
  void turn_shells() {
    for (auto& region : flat_.regions) {
      for (auto& shell : region.shells) {
        for (std::size_t k = 0; k < shell.size(); ++k) {
          shell[k] ^= flipped_[shell[k] >> 1];
          if (k > 0 && shell[k] < shell[k - 1]) std::swap(shell[k], shell[k - 1]);  // both sides of a face
        }
      }
      std::sort(region.shells.begin(), region.shells.end());
    }
  }
};

}  // namespace

FlatComplex flatten(const ResultView& view, Flattening what) {
  require(view.complex != nullptr && view.simplified != nullptr && view.value != nullptr,
          "flatten: a result without a complex");
  return Flattener(view, what).run();
}

const RegionAttributes& attributes_of(const ResultView& view, Component component) {
  static const RegionAttributes kNothing;
  return component == 0 ? kNothing : view.value->attributes(component);
}

}  // namespace cnrg
