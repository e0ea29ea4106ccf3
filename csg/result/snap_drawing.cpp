// Rounds on a *state*: points in doubles, triangles and pieces of edges by numbers of points, each with the list
// of the faces or edges of the drawing that lie on it. Refining a state shows its crossings; moving it, cell by
// cell, makes the next state.
#include "csg/result/snap_drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>
#include <unordered_set>

#include "csg/result/hot_routes.h"
#include "csg/result/rounding.h"
#include "csg/text/digits.h"
#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/base/parallel.h"
#include "kernel/base/part_watch.h"
#include "kernel/base/point_hash.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/predicates.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;
using Xyz = std::array<double, 3>;
constexpr std::size_t kManyCrossings = 100;        // one of so many triangles
constexpr std::size_t kUncheckedTriangles = 4096;  // points and triangles between two looks at the watch

/// Lists of numbers, each stored once.
class Lists {
 public:
  Index intern(std::vector<Index> list) {
    const auto [it, fresh] = known_.try_emplace(std::move(list), Index(lists_.size()));
    if (fresh) lists_.push_back(&it->first);
    return it->second;
  }
  const std::vector<Index>& operator[](Index i) const { return *lists_[i]; }
  Index unite(Index a, Index b) {
    if (a == b) return a;
    std::vector<Index> both = (*this)[a];
    both.insert(both.end(), (*this)[b].begin(), (*this)[b].end());
    sort_unique(both);
    return intern(std::move(both));
  }

 private:
  std::map<std::vector<Index>, Index> known_;
  std::vector<const std::vector<Index>*> lists_;
};

bool has_doubles(const PointTable& table, VertexId v) {
  if (table.is_double(v)) return true;
  const RationalPoint p = table.rational(v);
  return is_double(p[0]) && is_double(p[1]) && is_double(p[2]);
}

class Snapper {
 public:
  Snapper(const PointTable& table, const NumberedDrawing& drawing, const Watch& asked)
      : asked_(asked), drawing_(drawing) {
    begin_round(1);
    const std::size_t n = drawing.points.size();
    std::vector<Xyz> rounded(n);
    std::vector<double> moves(n, 0);
    for_each_index(n, [&](std::size_t p) {
      if (p % kUncheckedTriangles == 0) watch_.check();
      const VertexId v = drawing.points[p];
      rounded[p] = nearest_doubles(table, v);
      if (!table.is_double(v)) moves[p] = distance_above(table, v, rounded[p]);
    });
    double largest = 0;
    Numbering numbers(start_.xyz);
    for (std::size_t p = 0; p < n; ++p) {
      for (const double c : rounded[p]) largest = std::max(largest, std::abs(c));
      start_.displacement = std::max(start_.displacement, moves[p]);
      start_.at.push_back(numbers(rounded[p]));
    }
    if (largest > 0) unit_ = std::ldexp(1.0, std::max(std::ilogb(largest) - 52, -1074));
    for (const auto& t : drawing.triangles) {
      const auto& [a, b, c] = t.points;
      start_.triangles.push_back({{start_.at[a], start_.at[b], start_.at[c]}, lists_.intern({2 * t.face})});
    }
    for (const auto& [ends, edge] : drawing.pieces) {
      add_piece(start_, start_.at[ends[0]], start_.at[ends[1]], lists_.intern({edge}));
    }
  }

  MovedDrawing run() {
    Refined first = refine(start_);
    int rounds = 1;
    if (first.crossings == 0) return finish(start_, first, rounds);
    // Where surfaces nearly coincide crossings are many, and what is near them is nearly all.
    const bool many = kManyCrossings * first.crossings > start_.triangles.size();
    double cell = unit_ * kSnapFirstCell;
    for (int start = 0; start < kSnapStarts; ++start, cell *= kSnapGrowth) {
      SnappedTriangles state = routed(start_, first, many || start > 0, cell);
      std::size_t fewest = std::numeric_limits<std::size_t>::max();
      for (int tries = 0;;) {
        begin_round(++rounds);
        Refined refined = refine(state);
        const std::size_t now = refined.crossings;
        if (now == 0) return finish(state, refined, rounds);
        tries = 2 * now <= fewest ? 0 : tries + 1;
        fewest = std::min(fewest, now);
        if (tries >= (now > kSnapFewCrossings ? kSnapPatience : kSnapFewPatience)) break;
        if (now > 2 * fewest + kSnapFewCrossings) break;
        state = routed(state, refined, false, cell);
      }
    }
    throw InputError("rounding to doubles makes facets cross, and drawing together what lies within " +
                     double_text(cell / kSnapGrowth) +
                     " still does; join what nearly touches by --join, move the model nearer to the origin, write "
                     ".json, which is exact, or give --no-snap");
  }

 private:
  struct Triangle {
    std::array<Index, 3> points;
    Index faces;  // a list of faces and turns
  };
  struct SnappedTriangles {
    std::vector<Xyz> xyz;
    std::vector<Triangle> triangles;
    std::map<std::array<Index, 2>, Index> pieces;  // between two points: a list of edges
    std::vector<Index> at;                         // of each point of the drawing, or kNone
    double displacement = 0;
  };
  struct Refined {
    ComplexDraft complex;       // its first vertices are the points of the state
    std::vector<char> settled;  // vertices that are doubles
    std::size_t crossings = 0;  // vertices that are not
  };
  /// Points by their coordinates.
  class Numbering {
   public:
    explicit Numbering(std::vector<Xyz>& xyz) : xyz_(xyz) {}
    Index operator()(const Xyz& p) {
      const auto [it, fresh] = number_.try_emplace(p, Index(xyz_.size()));
      if (fresh) xyz_.push_back(p);
      return it->second;
    }

   private:
    std::vector<Xyz>& xyz_;
    std::unordered_map<Xyz, Index, HashPoint> number_;
  };

  const Watch& asked_;
  Watch watch_;  // of the round
  const NumberedDrawing& drawing_;
  Lists lists_;
  SnappedTriangles start_;  // each point rounded by itself
  double unit_ = 1;         // one unit in the last place of the largest coordinate

  void begin_round(int number) { watch_ = part_of(asked_, "snap, round " + std::to_string(number)); }

  void add_piece(SnappedTriangles& state, Index a, Index b, Index edges) {
    if (a == b) return;
    const auto [it, fresh] = state.pieces.try_emplace({std::min(a, b), std::max(a, b)}, edges);
    if (!fresh) it->second = lists_.unite(it->second, edges);
  }

  Refined refine(SnappedTriangles& state) const {
    drop_flat_triangles(state);
    keep_used_points(state);
    Refined refined{complex_of(state), {}, 0};
    const Complex& complex = *refined.complex;
    refined.settled.assign(complex.points.size(), 1);
    for_each_of(complex.vertices,
                [&](VertexId v) { refined.settled[v.index()] = has_doubles(complex.points, v); });
    refined.crossings = std::size_t(std::count(refined.settled.begin(), refined.settled.end(), 0));
    return refined;
  }

  void drop_flat_triangles(SnappedTriangles& state) const {
    PointTable table;
    for (const Xyz& p : state.xyz) table.add(p[0], p[1], p[2]);
    std::vector<char> flat(state.triangles.size(), 0);
    for_each_index(flat.size(), [&](std::size_t i) {
      if (i % kUncheckedTriangles == 0) watch_.check();
      const auto& [a, b, c] = state.triangles[i].points;
      flat[i] = a == b || b == c || c == a || collinear(table, VertexId(a), VertexId(b), VertexId(c));
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < flat.size(); ++i) {
      if (!flat[i]) state.triangles[kept++] = state.triangles[i];
    }
    state.triangles.resize(kept);
  }

  /// Numbers the points again: those that something has, so that a point of the soup is the vertex of its number.
  void keep_used_points(SnappedTriangles& state) const {
    std::vector<Index> number(state.xyz.size(), kNone);
    for (const auto& t : state.triangles)
      for (const Index p : t.points) number[p] = 0;
    for (const auto& [ends, edges] : state.pieces)
      for (const Index p : ends) number[p] = 0;
    for (const Index p : drawing_.isolated) number[state.at[p]] = 0;
    Index n = 0;
    for (Index p = 0; p < number.size(); ++p) {
      if (number[p] == kNone) continue;
      state.xyz[n] = state.xyz[p];
      number[p] = n++;
    }
    state.xyz.resize(n);
    for (auto& t : state.triangles)
      for (Index& p : t.points) p = number[p];
    std::map<std::array<Index, 2>, Index> pieces;
    for (const auto& [ends, edges] : state.pieces) pieces[{number[ends[0]], number[ends[1]]}] = edges;
    state.pieces = std::move(pieces);
    for (Index& p : state.at) p = p == kNone ? kNone : number[p];
  }

  /// Source i is triangle i.
  ComplexDraft complex_of(const SnappedTriangles& state) const {
    Soup soup;
    const LeafId leaf = soup.add_leaf(Fill::none);
    for (const Xyz& p : state.xyz) soup.add_point(p[0], p[1], p[2]);
    std::unordered_set<std::uint64_t> sides;
    std::vector<char> held(state.xyz.size(), 0);
    Index number = 0;
    for (const auto& t : state.triangles) {
      const auto& [a, b, c] = t.points;
      soup.add_triangle(leaf, PointId(a), PointId(b), PointId(c), number, number);
      ++number;
      sides.insert({edge_key(a, b), edge_key(b, c), edge_key(c, a)});
      held[a] = held[b] = held[c] = 1;
    }
    for (const auto& [ends, edges] : state.pieces) {
      if (sides.contains(edge_key(ends[0], ends[1]))) continue;
      soup.add_wire(leaf, PointId(ends[0]), PointId(ends[1]), number++);
      held[ends[0]] = held[ends[1]] = 1;
    }
    for (const Index p : drawing_.isolated) {
      if (!held[state.at[p]]) soup.add_isolated(leaf, PointId(state.at[p]));
    }
    RefineOptions options;
    options.watch = watch_;
    return ComplexDraft(soup, options);
  }

  /// The refinement of a drawing that has not been cut yet is that drawing.
  bool is_plain(const SnappedTriangles& state, const Complex& complex) const {
    return state.xyz.size() == drawing_.points.size() && state.triangles.size() == drawing_.triangles.size() &&
           state.pieces.size() == drawing_.pieces.size() &&
           is_as_drawn(complex, state.xyz.size(), state.triangles.size());
  }

  /// The faces of the drawing on a face of the complex.
  Index faces_on(const SnappedTriangles& state, const Complex& complex, FaceId f) {
    const auto covers = complex.cover(f);
    std::vector<Index> all;
    for (const Cover& cover : covers) {
      if (cover.source.index() >= state.triangles.size()) continue;
      for (const Index code : lists_[state.triangles[cover.source.index()].faces]) {
        all.push_back(code ^ (cover.same ? 0u : 1u));
      }
    }
    std::sort(all.begin(), all.end());
    return lists_.intern(std::move(all));
  }

  /// The edges of the drawing on an edge of the complex.
  Index edges_on(const SnappedTriangles& state, const Complex& complex, EdgeId e) {
    Index edges = lists_.intern({});
    for (const SegmentId s : complex.edge_segments[e]) {
      const auto& [a, b] = complex.segment_ends[s];
      const auto piece = state.pieces.find({std::min(a, b).value(), std::max(a, b).value()});
      if (piece != state.pieces.end()) edges = lists_.unite(edges, piece->second);
    }
    return edges;
  }

  /// The drawing with all that passes through a hot cell drawn to its center.
  SnappedTriangles routed(const SnappedTriangles& state, const Refined& refined, bool everywhere, double size) {
    const Complex& complex = *refined.complex;
    std::vector<Index> faces, edges;
    for (const FaceId f : IdRange<FaceId>(complex.face_count())) faces.push_back(faces_on(state, complex, f));
    for (const EdgeId e : IdRange<EdgeId>(complex.edge_count())) edges.push_back(edges_on(state, complex, e));
    const HotRoutes routes = route(complex, refined.settled, everywhere, size, unit_, watch_);

    SnappedTriangles next;
    next.displacement = state.displacement + routes.displacement;
    Numbering numbers(next.xyz);
    std::vector<Index> to;
    for (const Xyz& p : routes.to) to.push_back(numbers(p));
    for (std::size_t f = 0; f < faces.size(); ++f) {
      for (const auto& [a, b, c] : routes.triangles[f]) {
        next.triangles.push_back({{to[a.index()], to[b.index()], to[c.index()]}, faces[f]});
      }
    }
    for (const EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
      if (lists_[edges[e.index()]].empty()) continue;
      const std::vector<VertexId>& chain = routes.chains[e.index()];
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        add_piece(next, to[chain[k].index()], to[chain[k + 1].index()], edges[e.index()]);
      }
    }
    for (const Index p : state.at) next.at.push_back(p == kNone ? kNone : to[p]);
    return next;
  }

  MovedDrawing finish(const SnappedTriangles& state, Refined& refined, int rounds) {
    MovedDrawing result{std::move(refined.complex), {}, {}, {}, 0, false, 0};
    const Complex& complex = *result.complex;
    for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
      if (f.index() % kUncheckedTriangles == 0) watch_.check();
      result.faces.push_back(lists_[faces_on(state, complex, f)]);
    }
    watch_.check();
    for (const EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
      result.edges.push_back(lists_[edges_on(state, complex, e)]);
    }
    for (const Index p : state.at) result.points.push_back(p == kNone ? VertexId::none() : VertexId(p));
    result.rounds = rounds;
    result.plain = rounds == 1 && is_plain(state, complex);
    result.displacement = state.displacement;
    return result;
  }
};

}  // namespace

MovedDrawing snap(const PointTable& points, const NumberedDrawing& drawing, const Watch& watch) {
  return Snapper(points, drawing, watch).run();
}

}  // namespace cnrg
