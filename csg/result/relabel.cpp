// By the rules in the header: first the regions of 3-cells, by what the sides of faces say; then which faces,
// edges and vertices remain and what they are; then their leaves and patches.
#include "csg/result/relabel.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "csg/operators/cell_sources.h"
#include "csg/result/result_data.h"
#include "csg/result/sizes.h"
#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/selection/canonical.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;

/// What cells of the result a new cell comes from.
struct Sources {
  std::vector<LeafId> leaves;
  SaidPointer said;
  void clear() {
    leaves.clear();
    said.reset();
  }
};

class Labeller {
 public:
  Labeller(const ResultView& view, const FlatComplex& flat, MovedDrawing drawing)
      : exact_(*view.complex),
        flat_(flat),
        moved_(std::move(drawing)),
        complex_(*moved_.complex),
        exact_value_(view.value->is_group() ? components_of(exact_, view.value->group())
                                            : view.value->components()),
        simplified_(*view.simplified) {
    put_in_order(exact_, simplified_);  // so that its cells have the numbers of `flat`
  }

  /// False if moving changed nothing but digits.
  bool run(const Watch& watch) {
    find_sides();
    watch.check();
    name_regions();
    watch.check();
    if (moved_.plain && is_faithful()) return false;
    using Step = void (Labeller::*)();
    for (const Step step : {&Labeller::decide_faces, &Labeller::decide_edges, &Labeller::decide_vertices,
                            &Labeller::list_regions, &Labeller::take_covers, &Labeller::take_curves}) {
      (this->*step)();
      watch.check();
    }
    sources_.leaf_count = exact_.leaf_count + 1;
    value_.attributes = exact_value_.attributes;
    return true;
  }

  Components value() { return std::move(value_); }
  std::shared_ptr<const Complex> complex() {
    moved_.complex.set_sources(std::move(sources_));
    return moved_.complex.finish();
  }
  /// What the region that each 3-cell is of was made of; empty if nobody says sizes.
  std::vector<LeafParts> parts(const std::vector<LeafParts>& of_regions) const {
    std::vector<LeafParts> parts;
    if (of_regions.empty()) return parts;
    for (const Index r : region_) parts.push_back(r == kNone ? LeafParts() : of_regions[r]);
    return parts;
  }
  /// The edges and vertices of the result, where they still are.
  Features kept() const { return kept_; }

  /// Fills what is told of the move.
  void tell(Relabelled& out) const {
    SnapReport& report = out.report;
    report.rounds = moved_.rounds;
    report.displacement = moved_.displacement;
    report.points = flat_.points.size();
    std::vector<char> old(complex_.points.size(), 0);
    for (Index p = 0; p < flat_.points.size(); ++p) {
      const VertexId v = moved_.points[p];
      report.moved += !v.valid() || complex_.points.rational(v) != exact_.points.rational(flat_.points[p]);
      if (v.valid()) old[v.index()] = 1;
    }
    for (const VertexId v : complex_.vertices) report.added += !old[v.index()];
    std::vector<char> faces(flat_.faces.size(), 0), regions(flat_.regions.size(), 0);
    for (const FaceId f : IdRange<FaceId>(complex_.face_count())) {
      if (!remains_[f]) continue;
      for (const Index code : moved_.faces[f]) faces[code >> 1] = 1;
    }
    for (const Index r : region_) {
      if (r != kNone) regions[r] = 1;
    }
    std::vector<char> edges(flat_.edges.size(), 0);
    for (const Index i : moved_.edges.values()) edges[i] = 1;
    for (Index i = 0; i < faces.size(); ++i) {
      if (!faces[i]) out.lost_faces.push_back(i);
    }
    for (Index i = 0; i < regions.size(); ++i) {
      if (flat_.active(i) && !regions[i]) out.lost_regions.push_back(i);
    }
    for (Index i = 0; i < edges.size(); ++i) {
      if (flat_.edges[i].wire && !edges[i]) out.lost_wires.push_back(i);
    }
    report.faces = out.lost_faces.size();
    report.regions = out.lost_regions.size();
    report.wires = out.lost_wires.size();
  }

 private:
  const Complex& exact_;
  const FlatComplex& flat_;
  MovedDrawing moved_;
  const Complex& complex_;
  const Components exact_value_;
  SimplifiedComplex simplified_;
  Components value_;
  std::map<std::pair<const Attributes*, int>, SaidPointer> said_;  // by what the result says, and dimension
  Features kept_;
  /// Of the new complex. It names no regions of leaves: the result's region holds several of each, and a wall
  /// of one leaf may lie where another one has its own.
  ComplexSources sources_;
  /// The regions that each face names on its front and back.
  IdVector<FaceId, std::array<std::vector<Index>, 2>> sides_;
  IdVector<RegionId, Index> region_;  // region of the result
  bool contradicted_ = false;         // the sides of a 3-cell name several regions
  IdVector<FaceId, char> remains_;    // it did not vanish
  IdVector<EdgeId, char> edge_remains_;
  IdVector<FaceId, Component> face_state_;
  IdVector<EdgeId, Component> edge_state_;

  /// Several faces of the result may have fallen onto one face. On its front are then the regions on their fronts
  /// except those that are on their backs, too; and the other way round.
  void find_sides() {
    sides_.resize(complex_.face_count());
    for (const FaceId f : IdRange<FaceId>(complex_.face_count())) {
      std::vector<Index> named[2];
      for (const Index code : moved_.faces[f]) {
        for (Index side = 0; side < 2; ++side) {
          named[side].push_back(flat_.faces[code >> 1].regions[side ^ (code & 1)]);
        }
      }
      if (named[0].size() == 1) {
        sides_[f] = {named[0], named[1]};
        continue;
      }
      for (auto& list : named) std::sort(list.begin(), list.end());
      // What is in one list more often than in the other, as many times as it is more.
      sides_[f] = {in_first_alone(named[0], named[1]), in_first_alone(named[1], named[0])};
    }
  }

  /// A 3-cell is the region that the sides of its faces name. A face that names none has one region on both sides,
  /// so the name of the 3-cell on one side is that of the other.
  void name_regions() {
    region_.assign(complex_.region_count, kNone);
    std::vector<char> named(complex_.region_count, 0);
    std::vector<RegionId> ready;
    for (const RegionId r : IdRange<RegionId>(complex_.region_count)) {
      std::map<Index, double> area;
      for (const HalfFace h : complex_.region_faces[r]) {
        for (const Index region : sides_[h.face()][h.side()]) area[region] = 0;
      }
      if (area.empty()) continue;
      contradicted_ = contradicted_ || area.size() > 1;
      region_[r] = area.size() == 1 ? area.begin()->first : largest(r, area);
      named[r.index()] = 1;
      ready.push_back(r);
    }
    for (std::size_t i = 0; i < ready.size(); ++i) {
      for (const HalfFace h : complex_.region_faces[ready[i]]) {
        const RegionId other = complex_.region(h.opposite());
        if (named[other.index()] || !sides_[h.face()][0].empty()) continue;
        named[other.index()] = 1;
        region_[other] = region_[ready[i]];
        ready.push_back(other);
      }
    }
    if (ready.size() == complex_.region_count) return;
    // All faces have fallen together with others, or there are none: what is left is the outside.
    require(ready.empty(), "relabel: a region next to no face that names it");
    const auto outside = std::find_if(flat_.regions.begin(), flat_.regions.end(),
                                      [](const auto& region) { return !region.bounded; });
    for (Index& r : region_) r = outside == flat_.regions.end() ? kNone : Index(outside - flat_.regions.begin());
  }

  Index largest(RegionId r, std::map<Index, double>& area) const {
    for (const HalfFace h : complex_.region_faces[r]) {
      const auto& named = sides_[h.face()][h.side()];
      if (named.empty()) continue;
      const double size = rounded_area(h.face()) / double(named.size());
      for (const Index region : named) area[region] += size;
    }
    return std::max_element(area.begin(), area.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
  }

  /// Exact areas of crossed slivers would take more time than all else, and nobody asks for their digits.
  double rounded_area(FaceId f) const {
    DoubleVector sum{};
    for (const LoopId l : complex_.face_loops[f]) {
      const auto loop = complex_.loop[l];
      const RationalPoint origin = complex_.points.rational(complex_.origin(loop[0]));
      DoubleVector last{};
      for (std::size_t k = 1; k < loop.size(); ++k) {
        const DoubleVector next = to_doubles(complex_.points.rational(complex_.origin(loop[k])) - origin);
        const DoubleVector piece = cross(last, next);
        for (std::size_t i = 0; i < 3; ++i) sum[i] += piece[i];
        last = next;
      }
    }
    return std::sqrt(dot(sum, sum)) / 2;
  }

  bool is_faithful() const {
    if (contradicted_) return false;
    std::vector<Index> used(region_.begin(), region_.end());
    sort_unique(used);
    if (used.size() != complex_.region_count) return false;
    const Index outside = region_[RegionId(0)];
    if (outside != kNone && flat_.regions[outside].bounded) return false;
    for (const EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      const auto edges = moved_.edges[e];
      if (!complex_.edge_uses[e].empty() || edges.empty()) continue;
      if (region_[complex_.some_region(e)] != flat_.edges[edges[0]].region) return false;
    }
    return std::all_of(flat_.vertices.begin(), flat_.vertices.end(), [&](const auto& v) {
      return v.region == kNone || region_[complex_.some_region(moved_.points[v.point])] == v.region;
    });
  }

  Component component(Index region) const { return flat_.active(region) ? flat_.regions[region].component : 0; }
  Component component(RegionId region) const { return component(region_[region]); }

  /// The least number of an active component; 0 if there is none.
  static void prefer(Component& best, Component other) {
    if (best == 0 || (other != 0 && other < best)) best = other;
  }

  void decide_faces() {
    remains_.assign(complex_.face_count(), 0);
    face_state_.assign(complex_.face_count(), 0);
    Sources from;
    for (const FaceId f : IdRange<FaceId>(complex_.face_count())) {
      const auto& [front, back] = complex_.face_regions[f];
      const bool wall = region_[front] != region_[back];
      Component state = 0;
      from.clear();
      for (const Index code : moved_.faces[f]) {
        const FlatComplex::Face& face = flat_.faces[code >> 1];
        if (!wall && face.regions[0] != face.regions[1]) continue;
        remains_[f] = 1;
        prefer(state, face.component);
        add(from, face, 2);
      }
      if (!remains_[f]) state = absorb(complex_.some_region(f), from);
      face_state_[f] = state;
      list(value_.selection.faces, value_.origins.faces, f, state, from);
    }
  }

  void decide_edges() {
    edge_remains_.assign(complex_.edge_count(), 0);
    edge_state_.assign(complex_.edge_count(), 0);
    Sources from;
    for (const EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      const auto edges = moved_.edges[e];
      Component state = 0;
      from.clear();
      bool feature = false;
      for (const FaceUse& use : complex_.edge_uses[e]) {
        if (!remains_[use.face]) continue;
        edge_remains_[e] = 1;
        if (edges.empty()) prefer(state, face_state_[use.face]);
        add_face(use.face, from);
      }
      for (const Index i : edges) edge_remains_[e] = edge_remains_[e] || flat_.edges[i].wire;
      if (edge_remains_[e]) {
        for (const Index i : edges) {
          prefer(state, flat_.edges[i].component);
          add(from, flat_.edges[i], 1);
          feature = feature || flat_.edges[i].feature;
        }
        if (!edges.empty()) kept_.edges.push_back(e);
        if (feature && state != 0) value_.features.edges.push_back(e);
      } else {
        state = absorb(complex_.some_region(e), from);
      }
      edge_state_[e] = state;
      list(value_.selection.edges, value_.origins.edges, e, state, from);
    }
  }

  void decide_vertices() {
    IdVector<VertexId, std::vector<Index>> here(complex_.points.size());
    for (Index i = 0; i < flat_.vertices.size(); ++i) {
      const VertexId v = moved_.points[flat_.vertices[i].point];
      if (v.valid()) here[v].push_back(i);
    }
    Sources from;
    for (const VertexId v : complex_.vertices) {
      Component around = 0, state = 0;
      from.clear();
      bool remains = false, feature = false;
      for (const EdgeId e : complex_.vertex_edges[v]) {
        if (!edge_remains_[e]) continue;
        remains = true;
        prefer(around, edge_state_[e]);
      }
      for (const FaceId f : complex_.vertex_faces[v]) {
        if (!remains_[f]) continue;
        remains = true;
        prefer(around, face_state_[f]);
      }
      for (const Index i : here[v]) remains = remains || flat_.vertices[i].free;
      if (!remains) {
        state = absorb(complex_.some_region(v), from);
      } else if (here[v].empty()) {
        state = around;
        add_around(v, from);
      } else {
        add_around(v, from);
        for (const Index i : here[v]) {
          const FlatComplex::Vertex& vertex = flat_.vertices[i];
          prefer(state, vertex.component);
          add(from, vertex, 0);
          feature = feature || vertex.feature;
          for (const LeafCell& cell : vertex.origin.cells) {
            if (cell.dimension == 0) sources_.isolated_leaves.emplace_back(v, cell.leaf);
          }
        }
        kept_.vertices.push_back(v);
        if (feature && state != 0) value_.features.vertices.push_back(v);
      }
      list(value_.selection.vertices, value_.origins.vertices, v, state, from);
    }
  }

  /// What meets in a vertex, or came to it by the move.
  void add_around(VertexId v, Sources& from) const {
    for (const EdgeId e : complex_.vertex_edges[v]) {
      for (const Index i : moved_.edges[e]) add(from, flat_.edges[i]);
      for (const FaceUse& use : complex_.edge_uses[e]) add_face(use.face, from);
    }
    for (const FaceId f : complex_.vertex_faces[v]) add_face(f, from);
  }
  void add_face(FaceId f, Sources& from) const {
    if (!remains_[f]) return;
    for (const Index code : moved_.faces[f]) add(from, flat_.faces[code >> 1]);
  }

  void list_regions() {
    Sources from;
    for (const RegionId r : IdRange<RegionId>(complex_.region_count)) {
      from.clear();
      const Component state = absorb(r, from);
      list(value_.selection.regions, value_.origins.regions, r, state, from);
    }
  }

  /// A cell inside of a region: its component and leaves.
  Component absorb(RegionId r, Sources& from) const {
    const Component state = component(r);
    if (state != 0) add(from, flat_.regions[region_[r]]);
    return state;
  }
  template <class Cell>
  static void add(Sources& from, const Cell& cell) {
    from.leaves.insert(from.leaves.end(), cell.origin.leaves.begin(), cell.origin.leaves.end());
  }
  /// The same for a cell of the result that has the new one as a piece: the piece inherits its attributes.
  template <class Cell>
  void add(Sources& from, const Cell& cell, int dimension) {
    add(from, cell);
    if (cell.origin.said == nullptr) return;
    SaidPointer& said = said_[{cell.origin.said, dimension}];
    if (said == nullptr) said = std::make_shared<const Said>(Said{*cell.origin.said, dimension});
    from.said = merged(from.said, said, Dominance::equal);
  }
  template <class IdT>
  void list(std::vector<std::pair<IdT, Component>>& cells, std::vector<LeafSetId>& origins, IdT id,
            Component state, Sources& from) {
    if (state == 0) return;
    sort_unique(from.leaves);
    cells.emplace_back(id, state);
    origins.push_back(value_.origins.sets.intern(from.leaves, from.said));
  }

  /// Faces of the result that lie in several planes now. Each is a curved surface of its own from here on.
  std::vector<char> find_bent() const {
    std::vector<char> bent(flat_.faces.size(), 0);
    std::vector<SheetId> sheet(flat_.faces.size());
    for (const FaceId f : IdRange<FaceId>(complex_.face_count())) {
      for (const Index code : moved_.faces[f]) {
        SheetId& known = sheet[code >> 1];
        if (!known.valid()) known = complex_.face_sheet[f];
        if (known != complex_.face_sheet[f]) bent[code >> 1] = 1;
      }
    }
    return bent;
  }

  /// Faces of the new complex lie on the leaf faces that the result's faces lie on, and their fronts are where
  /// those are. One more leaf has the faces of the result as its patches: facets of one face stay together.
  void take_covers() {
    const LeafId result(exact_.leaf_count);
    sources_.leaf_regions = exact_.leaf_regions;
    std::vector<std::vector<std::pair<SourceId, bool>>> of_face;  // on the front of the face of the result, or not
    const std::vector<char> bent = find_bent();
    for (Index i = 0; i < flat_.faces.size(); ++i) {
      // With the same on both sides a face tells no side, and then it does not matter which one is its front.
      const bool flipped = flat_.faces[i].regions[0] != simplified_.faces[i].regions[0];
      std::map<std::tuple<LeafId, Index, Index, bool>, std::uint32_t> on;  // with the number of the surface
      for (const HalfFace cell : simplified_.faces[i].cells) {
        for (const Cover& cover : exact_.cover(cell.face())) {
          const Soup::Face& source = exact_.sources[cover.source];
          const bool same = (cover.same == (cell.side() == 0)) != flipped;
          if (source.leaf != exact_.frame)
            on[{source.leaf, source.leaf_face, source.patch, same}] = source.surface;
        }
      }
      auto& numbers = of_face.emplace_back();
      const auto add = [&](const Soup::Face& face, bool same) {
        numbers.emplace_back(sources_.sources.push_back(face), same);
      };
      for (const auto& [key, surface] : on) {
        const auto& [leaf, leaf_face, patch, same] = key;
        add({leaf, leaf_face, patch, 0, 0, surface}, same);
      }
      add({result, i, i, 0, 0, bent[i] ? exact_.surface_count + 1 + i : 0}, true);
    }
    DistinctLists<SourceSetId, Cover> covers;
    for (const FaceId f : IdRange<FaceId>(complex_.face_count())) {
      std::vector<Cover> list;
      for (const Index code : moved_.faces[f]) {
        for (const LeafCell& cell : flat_.faces[code >> 1].origin.cells) {
          if (cell.dimension == 2 && !has_cover(of_face[code >> 1], cell))
            sources_.held.faces.emplace_back(f, cell);
        }
        for (const auto& [source, same] : of_face[code >> 1]) list.push_back({source, same == ((code & 1) == 0)});
      }
      sources_.face_cover.push_back(covers(std::move(list)));
    }
    sources_.covers = covers.take();
  }
  bool has_cover(const std::vector<std::pair<SourceId, bool>>& list, const LeafCell& cell) const {
    return std::any_of(list.begin(), list.end(), [&](const auto& entry) {
      const Soup::Face& source = sources_.sources[entry.first];
      return source.leaf == cell.leaf && source.leaf_face == cell.number;
    });
  }

  /// Every edge is a segment. Its wires are those of leaves, and the edges of the result as curves of their own:
  /// what was a line stays one edge.
  void take_curves() {
    const LeafId result(exact_.leaf_count);
    std::vector<std::vector<WireId>> of_edge;
    for (Index i = 0; i < flat_.edges.size(); ++i) {
      auto& numbers = of_edge.emplace_back();
      for (const LeafCell& cell : flat_.edges[i].origin.cells) {
        if (cell.dimension == 1) numbers.push_back(sources_.wires.push_back({cell.leaf, cell.number, {}, {}}));
      }
      numbers.push_back(sources_.wires.push_back({result, i, {}, {}}));
    }
    std::vector<WireId> on;
    for (const EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      on.clear();
      for (const Index i : moved_.edges[e]) on.insert(on.end(), of_edge[i].begin(), of_edge[i].end());
      sources_.edge_segments.push_back(std::array{sources_.add_segment(complex_.edge_ends[e], {}, on)});
    }
  }
};

/// What is said of cells tells them apart; where they came from does not: all are of the result, which is one of
/// the leaves, with its faces as patches.
class FromAllLeaves : public ComponentSources {
 public:
  FromAllLeaves(const Complex& complex, const Components& x) : ComponentSources(complex, x) {
    for (const LeafId leaf : IdRange<LeafId>(complex.leaf_count)) all_.push_back(leaf);
  }
  void leaves_of(FaceId, std::vector<LeafId>& out) const override { out = all_; }
  void leaves_of(EdgeId, std::vector<LeafId>& out) const override { out = all_; }

 private:
  std::vector<LeafId> all_;
};

}  // namespace

ResultView Relabelled::shown(ResultView view) const {
  view.complex = complex.get();
  view.value = &value;
  view.simplified = &simplified;
  view.of_group = of_group;
  view.region_parts = &region_parts;
  view.parameters = nullptr;  // they are of points of the complex that it came from
  return view;
}

SimplifiedComplex simplify_relabelled(const Complex& complex, const Components& components,
                                      const Features& features, SimplifyMode mode) {
  const FromAllLeaves sources(complex, components);
  return simplify(complex, components.selection, features, mode, &sources);
}

std::optional<Relabelled> relabel(const ResultView& view, const FlatComplex& flat, MovedDrawing drawing, bool raw,
                                  const Watch& watch) {
  Labeller labeller(view, flat, std::move(drawing));
  watch.check();
  if (!labeller.run(watch)) return {};
  Relabelled out;
  labeller.tell(out);
  watch.check();
  out.value = NodeValue(labeller.value());
  out.of_group = view.value->is_group() || view.of_group;
  out.region_parts = labeller.parts(region_parts(view, flat));
  const Features kept = labeller.kept();
  out.complex = labeller.complex();
  watch.check();
  out.simplified = simplify_relabelled(*out.complex, out.value.components(), kept,
                                       raw ? SimplifyMode::raw : SimplifyMode::features);
  return out;
}

Result::Data relabelled(Result::Data data, const std::shared_ptr<const Relabelled>& made) {
  data.complex = made->complex;
  data.value = std::shared_ptr<const NodeValue>(made, &made->value);
  data.simplified = std::shared_ptr<const SimplifiedComplex>(made, &made->simplified);
  data.parameters = nullptr;  // they are of points of the complex that it came from
  data.of_group = made->of_group;
  data.region_parts = std::shared_ptr<const std::vector<LeafParts>>(made, &made->region_parts);
  return data;
}

}  // namespace cnrg
