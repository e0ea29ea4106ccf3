// The map is a complex of the kernel in the plane z = 0: its faces are the cells of the picture, and what covers
// each of them are facets.
#include "csg/picture/visibility.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "csg/picture/depth.h"
#include "csg/picture/loops.h"
#include "kernel/base/limits.h"

namespace cnrg {
namespace {

using Index = Scene::Index;

/// Compares what does not cross over one cell of the map. Nowhere in the cell's closure the sign of the difference
/// is the opposite one: so bounds at any of its corners decide, unless both meet there; then an exact point inside
/// does.
class PlaceIn {
 public:
  PlaceIn(const Complex& complex, FaceId f) : complex_(complex), face_(f) {
    for (const HalfEdge h : complex.loop[complex.face_loops[f].front()]) {
      if (corners_.size() < 8) add(complex.origin(h));
    }
  }
  PlaceIn(const Complex& complex, EdgeId e) : complex_(complex), edge_(e) {
    for (const VertexId v : complex.edge_ends[e]) add(v);
  }
  PlaceIn(const Complex& complex, VertexId v) : complex_(complex), inside_(complex.points.exact(v)) { add(v); }

  int compare(const Depth& a, const Depth& b) {
    for (const auto& corner : corners_) {
      if (const int nearer = a.compare(b, corner)) return nearer;
    }
    if (!inside_) inside_ = face_.valid() ? interior_point(complex_, face_) : interior_point(complex_, edge_);
    return a.compare(b, *inside_);
  }

 private:
  const Complex& complex_;
  FaceId face_;
  EdgeId edge_;
  std::vector<std::array<Depth::Bounds, 2>> corners_;
  std::optional<ExactPoint> inside_;

  void add(VertexId v) {
    const PointView p = complex_.points.view(v);
    corners_.push_back({Depth::Bounds{p.lo[0], p.hi[0]}, Depth::Bounds{p.lo[1], p.hi[1]}});
  }
};

/// How well something is seen at a place.
enum class Sight : std::uint8_t { seen, hidden, gone };

class Map {
 public:
  Map(const Scene& scene, int threads) : scene_(scene) {
    lay_flat();
    complex_ = build_complex(soup_, {threads});
    stack_facets();
  }

  SeenScene run() {
    add_strokes();
    add_areas();
    add_dots();
    return std::move(out_);
  }

 private:
  const Scene& scene_;
  Soup soup_;
  LeafId rim_leaf_;
  std::vector<std::optional<Depth>> facet_depth_;  // none: not laid down
  std::vector<char> faces_front_;
  std::vector<std::optional<Depth>> segment_depth_;
  // Edges of facets by their ends, and the facets that were laid down along each. Where two facets meet in such an
  // edge they are equally near: that is known without any arithmetic.
  std::map<std::array<Index, 2>, Index> rim_numbers_;
  std::vector<std::vector<Index>> rims_;
  std::shared_ptr<const Complex> complex_;
  std::vector<std::vector<Index>> stacks_;  // different lists of facets, front to back; the first is empty
  IdVector<FaceId, Index> stack_of_;
  SeenScene out_;

  // --- the map

  void lay_flat() {
    const LeafId leaf = soup_.add_leaf(Fill::none);
    rim_leaf_ = soup_.add_leaf(Fill::none);
    std::vector<PointId> flat(scene_.points.size());
    const auto point = [&](Index i) {
      if (!flat[i].valid()) flat[i] = soup_.add_point({scene_.points[i][0], scene_.points[i][1], Rational(0)});
      return flat[i];
    };
    facet_depth_.resize(scene_.facets.size());
    faces_front_.resize(scene_.facets.size());
    for (Index i = 0; i < scene_.facets.size(); ++i) {
      const Scene::Facet& facet = scene_.facets[i];
      Depth::Facing facing{};
      std::optional<Depth> depth = Depth::of_facet(scene_, facet, facing);
      if (!depth || (facing == Depth::Facing::back && !scene_.surfaces[facet.surface].two_sided)) continue;
      facet_depth_[i] = std::move(depth);
      faces_front_[i] = facing == Depth::Facing::front ? 1 : 0;
      for (const Scene::Loop& loop : facet.loops) {
        for (std::size_t k = 0; k < loop.size(); ++k) {
          const std::array<Index, 2> ends = ordered(loop[k], loop[(k + 1) % loop.size()]);
          const auto [rim, fresh] = rim_numbers_.try_emplace(ends, static_cast<Index>(rims_.size()));
          if (fresh) {
            rims_.emplace_back();
            soup_.add_wire(rim_leaf_, point(ends[0]), point(ends[1]), rim->second);
          }
          rims_[rim->second].push_back(i);
        }
      }
      soup_.add_face(leaf, soup_loops(facet.loops, point), i, i);
    }
    segment_depth_.resize(scene_.segments.size());
    for (Index i = 0; i < scene_.segments.size(); ++i) {
      const auto& [a, b] = scene_.segments[i].ends;
      segment_depth_[i] = Depth::of_segment(scene_, scene_.segments[i]);
      if (!segment_depth_[i]) continue;
      soup_.add_wire(leaf, point(a), point(b), i);
    }
    for (const Scene::Dot& dot : scene_.dots) soup_.add_isolated(leaf, point(dot.point));
  }

  static std::array<Index, 2> ordered(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }
  const Scene::Surface& surface(Index facet) const { return scene_.surfaces[scene_.facets[facet].surface]; }

  /// The facets over each face of the map.
  void stack_facets() {
    std::map<std::vector<Index>, Index> known{{{}, 0}};
    stacks_.emplace_back();
    stack_of_.assign(complex_->face_count(), 0);
    std::vector<Index> stack;
    for (const FaceId f : IdRange<FaceId>(complex_->face_count())) {
      stack.clear();
      for (const Cover& cover : complex_->cover(f)) stack.push_back(complex_->sources[cover.source].leaf_face);
      std::sort(stack.begin(), stack.end());
      if (stack.size() > 1) {
        PlaceIn at(*complex_, f);
        std::stable_sort(stack.begin(), stack.end(), [&](Index a, Index b) {
          const int nearer = at.compare(*facet_depth_[a], *facet_depth_[b]);
          return nearer != 0 ? nearer > 0 : faces_front_[a] > faces_front_[b];
        });
      }
      const auto last = std::find_if(stack.begin(), stack.end(), [&](Index i) { return surface(i).opacity >= 1; });
      if (last != stack.end()) stack.erase(last + 1, stack.end());
      const auto [entry, fresh] = known.try_emplace(stack, static_cast<Index>(stacks_.size()));
      if (fresh) stacks_.push_back(stack);
      stack_of_[f] = entry->second;
    }
  }

  /// What is seen on the two sides of an edge of the map.
  std::array<Index, 2> sides(EdgeId e) const {
    std::array<Index, 2> out{0, 0};
    const auto uses = complex_->edge_uses[e];
    for (std::size_t k = 0; k < uses.size(); ++k) out[k] = stack_of_[uses[k].face];
    return out;
  }

  /// How well something of this depth is seen through a stack. `meets` is true for facets that it is known to lie
  /// on.
  template <class Meets>
  Sight sight(const Depth& depth, const std::vector<Index>& stack, PlaceIn& at, Meets meets) const {
    Sight out = Sight::seen;
    for (const Index facet : stack) {
      if (meets(facet) || at.compare(*facet_depth_[facet], depth) <= 0) break;
      if (surface(facet).ghost) continue;
      if (surface(facet).opacity >= 1) return Sight::gone;
      out = Sight::hidden;
    }
    return out;
  }

  // --- lines

  /// What is drawn along an edge of the map; pieces of equal looks are joined.
  struct Look {
    Index line = kNone, surface = kNone;
    bool hidden = false, outline = false;
    friend auto operator<=>(const Look&, const Look&) = default;
  };

  /// What lies along an edge of the map.
  struct Along {
    std::vector<Index> segments, rims;
  };
  Along along(EdgeId e) const {
    Along out;
    for (const SegmentId s : complex_->edge_segments[e]) {
      for (const WireId w : complex_->segment_wires[s]) {
        const Soup::Wire& wire = complex_->wires[w];
        (wire.leaf == rim_leaf_ ? out.rims : out.segments).push_back(wire.leaf_edge);
      }
    }
    return out;
  }
  static bool contains(const std::vector<Index>& list, Index i) {
    return std::find(list.begin(), list.end(), i) != list.end();
  }

  /// The nearest line along the edge, as well as it is seen.
  std::pair<Index, Sight> line_along(const Along& along, const std::array<Index, 2>& seen, PlaceIn& at) const {
    Index best = kNone;
    for (const Index i : along.segments) {
      const bool same = best != kNone && ordered(scene_.segments[i].ends[0], scene_.segments[i].ends[1]) ==
                                             ordered(scene_.segments[best].ends[0], scene_.segments[best].ends[1]);
      const int nearer = best == kNone ? 1 : same ? 0 : at.compare(*segment_depth_[i], *segment_depth_[best]);
      if (nearer > 0 || (nearer == 0 && i < best)) best = i;
    }
    if (best == kNone) return {kNone, Sight::gone};
    const auto& [a, b] = scene_.segments[best].ends;
    const auto rim = rim_numbers_.find(ordered(a, b));
    const auto meets = [&](Index facet) {
      return rim != rim_numbers_.end() && contains(rims_[rim->second], facet);
    };
    const Depth& depth = *segment_depth_[best];
    return {scene_.segments[best].line,
            std::min(sight(depth, stacks_[seen[0]], at, meets), sight(depth, stacks_[seen[1]], at, meets))};
  }

  /// True if both facets have an edge in common that lies along the edge of the map.
  bool meet(Index f, Index g, const Along& along) const {
    return f == g || std::any_of(along.rims.begin(), along.rims.end(),
                                 [&](Index rim) { return contains(rims_[rim], f) && contains(rims_[rim], g); });
  }

  /// The nearest surface that ends or breaks off at the edge.
  std::pair<Index, Sight> outline_along(const Along& along, const std::array<Index, 2>& seen, PlaceIn& at) const {
    Index best = kNone;
    Sight best_sight = Sight::gone;
    for (const std::size_t side : {0U, 1U}) {
      const std::vector<Index>&here = stacks_[seen[side]], &there = stacks_[seen[1 - side]];
      for (const Index facet : here) {
        const auto meets = [&](Index other) { return meet(facet, other, along); };
        const bool goes_on = std::any_of(there.begin(), there.end(), [&](Index other) {
          return scene_.facets[other].surface == scene_.facets[facet].surface && meets(other);
        });
        if (goes_on) continue;
        const Depth& depth = *facet_depth_[facet];
        const Sight s = std::max(sight(depth, here, at, meets), sight(depth, there, at, meets));
        if (s == Sight::gone) break;
        if (best == kNone || s < best_sight ||
            (s == best_sight && !meets(best) && at.compare(*facet_depth_[best], depth) < 0)) {
          best = facet;
          best_sight = s;
        }
        break;  // what follows is behind it
      }
    }
    return {best == kNone ? kNone : scene_.facets[best].surface, best_sight};
  }

  bool only_ghosts(const std::vector<Index>& stack) const {
    return std::all_of(stack.begin(), stack.end(), [&](Index facet) { return surface(facet).ghost; });
  }

  std::optional<Look> look_of(EdgeId e) const {
    const std::array<Index, 2> seen = sides(e);
    const Along here = along(e);
    if (here.segments.empty() && seen[0] == seen[1]) return std::nullopt;
    PlaceIn at(*complex_, e);
    const auto [line, line_sight] = line_along(here, seen, at);
    const auto [surface, outline_sight] = outline_along(here, seen, at);
    const Sight best = std::min(line_sight, outline_sight);
    if (best == Sight::gone) return std::nullopt;
    Look look;
    look.hidden = best == Sight::hidden;
    look.outline = !look.hidden && (only_ghosts(stacks_[seen[0]]) || only_ghosts(stacks_[seen[1]]));
    (line_sight == best ? look.line : look.surface) = line_sight == best ? line : surface;
    return look;
  }

  void add_strokes() {
    std::map<Look, std::vector<EdgeId>> pieces;
    for (const EdgeId e : IdRange<EdgeId>(complex_->edge_count())) {
      if (const std::optional<Look> look = look_of(e)) pieces[*look].push_back(e);
    }
    for (const auto& [look, edges] : pieces) {
      for (auto& [points, closed] : chains(edges, false)) {
        out_.strokes.push_back({look.line, look.surface, look.hidden, look.outline, std::move(points), closed});
      }
    }
  }

  // --- areas

  void add_areas() {
    // Stacks that look alike are one area.
    std::map<std::vector<std::pair<Index, int>>, Index> known;
    std::vector<Index> area_of(stacks_.size());
    std::vector<std::vector<std::pair<Index, int>>> looks(stacks_.size());
    for (std::size_t i = 0; i < stacks_.size(); ++i) {
      for (const Index f : stacks_[i]) looks[i].emplace_back(scene_.facets[f].surface, scene_.facets[f].light);
      known.try_emplace(looks[i], static_cast<Index>(i));
    }
    Index number = 0;
    for (auto& [look, area] : known) {
      out_.areas.push_back({stacks_[area], {}});
      area = number++;
    }
    for (std::size_t i = 0; i < stacks_.size(); ++i) area_of[i] = known.at(looks[i]);
    std::vector<std::vector<EdgeId>> borders(out_.areas.size());
    for (const EdgeId e : IdRange<EdgeId>(complex_->edge_count())) {
      const std::array<Index, 2> seen = sides(e);
      const Index one = area_of[seen[0]], other = area_of[seen[1]];
      if (one == other) continue;
      borders[one].push_back(e);
      borders[other].push_back(e);
    }
    for (std::size_t i = 0; i < borders.size(); ++i) {
      for (auto& [points, closed] : chains(borders[i], true)) out_.areas[i].loops.push_back(std::move(points));
    }
    out_.areas.erase(out_.areas.begin());  // where nothing is
  }

  /// Edges joined end to end, straight ones into one piece. With `through`, chains pass every vertex at which an
  /// even number of edges end, in any pairs; otherwise only those where two end.
  std::vector<std::pair<std::vector<Point2>, bool>> chains(const std::vector<EdgeId>& edges, bool through) const {
    std::vector<std::pair<VertexId, std::uint32_t>> ends;
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      for (const VertexId v : complex_->edge_ends[edges[i]]) ends.emplace_back(v, i);
    }
    std::sort(ends.begin(), ends.end());
    const auto at = [&](VertexId v) {
      return std::equal_range(ends.begin(), ends.end(), std::pair(v, 0U),
                              [](const auto& a, const auto& b) { return a.first < b.first; });
    };
    std::vector<char> used(edges.size(), 0);
    /// The edge by which a chain that comes along `edge` leaves v.
    const auto next = [&](VertexId v, std::uint32_t edge) {
      const auto [first, last] = at(v);
      if (!through && last - first != 2) return kNone;
      for (auto it = first; it != last; ++it) {
        if (it->second != edge && !used[it->second]) return it->second;
      }
      return kNone;
    };
    std::vector<std::pair<std::vector<Point2>, bool>> out;
    const auto walk = [&](std::uint32_t i, VertexId from) {
      const VertexId start = from;
      std::vector<VertexId> corners{from};
      std::vector<EdgeId> along;
      while (i != kNone) {
        used[i] = 1;
        const EdgeId e = edges[i];
        from = complex_->edge_ends[e][complex_->edge_ends[e][0] == from ? 1 : 0];
        corners.push_back(from);
        along.push_back(e);
        i = from == start && (through || at(from).second - at(from).first == 2) ? kNone : next(from, i);
      }
      const bool closed = along.size() > 1 && from == start;
      out.emplace_back(simplified(corners, along, closed), closed);
    };
    for (std::uint32_t i = 0; i < edges.size(); ++i) {  // open chains first, from their ends
      const EdgeId e = edges[i];
      for (const VertexId v : complex_->edge_ends[e]) {
        if (!through && !used[i] && at(v).second - at(v).first != 2) walk(i, v);
      }
    }
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      if (!used[i]) walk(i, complex_->edge_ends[edges[i]][0]);
    }
    put_in_order(out);
    return out;
  }

  /// In an order, and from ends, that follow from the places alone: so a picture does not depend on numbers of
  /// cells.
  static void put_in_order(std::vector<std::pair<std::vector<Point2>, bool>>& chains) {
    for (auto& [points, closed] : chains) {
      if (closed) {
        std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
        if (points.size() > 2 && points.back() < points[1]) std::reverse(points.begin() + 1, points.end());
      } else if (points.back() < points.front()) {
        std::reverse(points.begin(), points.end());
      }
    }
    std::sort(chains.begin(), chains.end());
  }

  /// True if both lie on one input segment.
  bool straight(EdgeId a, EdgeId b) const {
    const auto of_a = complex_->edge_segments[a], of_b = complex_->edge_segments[b];
    return std::any_of(of_a.begin(), of_a.end(),
                       [&](SegmentId s) { return std::find(of_b.begin(), of_b.end(), s) != of_b.end(); });
  }

  Point2 place(VertexId v) const {
    const auto p = complex_->points.approx(v);
    return {p[0], p[1]};
  }

  std::vector<Point2> simplified(const std::vector<VertexId>& corners, const std::vector<EdgeId>& along,
                                 bool closed) const {
    std::vector<Point2> out;
    for (std::size_t i = 0; i < along.size() + (closed ? 0 : 1); ++i) {
      const bool inner = closed || (i > 0 && i < along.size());
      if (inner && straight(along[(i + along.size() - 1) % along.size()], along[i % along.size()])) continue;
      out.push_back(place(corners[i]));
    }
    return out;
  }

  // --- dots

  void add_dots() {
    std::map<std::pair<Rational, Rational>, VertexId> vertices;
    for (const VertexId v : complex_->vertices) {
      if (complex_->isolated_leaves[v].empty()) continue;
      const RationalPoint p = complex_->points.rational(v);
      vertices.emplace(std::pair(p[0], p[1]), v);
    }
    std::vector<FaceId> star;
    for (Index i = 0; i < scene_.dots.size(); ++i) {
      const RationalPoint& p = scene_.points[scene_.dots[i].point];
      const VertexId v = vertices.at({p[0], p[1]});
      PlaceIn at(*complex_, v);
      const Depth depth(scene_, scene_.dots[i].point);
      complex_->star_faces(v, star);
      bool open = star.empty();
      for (const EdgeId e : complex_->vertex_edges[v]) open |= complex_->edge_uses[e].size() < 2;
      Sight best = open ? Sight::seen : Sight::gone;
      for (const FaceId f : star)
        best = std::min(best, sight(depth, stacks_[stack_of_[f]], at, [](Index) { return false; }));
      if (best != Sight::gone) out_.dots.push_back({i, best == Sight::hidden, place(v)});
    }
  }
};

}  // namespace

SeenScene see(const Scene& scene, int threads) { return Map(scene, threads).run(); }

}  // namespace cnrg
