#include "csg/result/hot_routes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "csg/result/rounding.h"
#include "kernel/base/hypotenuse.h"
#include "kernel/base/parallel.h"
#include "kernel/base/point_hash.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/predicates.h"
#include "kernel/exact/triangulate.h"

namespace cnrg {
namespace {

using Xyz = HotCells::Xyz;
using Triangles = std::vector<std::array<VertexId, 3>>;
using Walks = std::vector<std::vector<VertexId>>;
using EdgeEnds = std::array<VertexId, 2>;
constexpr std::size_t kNoCell = ~std::size_t(0);
constexpr std::size_t kUncheckedCells = 1024;  // edges and faces between two looks at the watch

EdgeEnds ends_of(VertexId a, VertexId b) { return a < b ? EdgeEnds{a, b} : EdgeEnds{b, a}; }

class Router {
 public:
  Router(const Complex& complex, const std::vector<char>& settled, bool everywhere, double size, double grain,
         const Watch& watch)
      : complex_(complex),
        everywhere_(everywhere),
        watch_(watch),
        here_(doubles_of_points()),
        broken_(broken_places(settled, size)),
        cells_(candidates(settled, size, grain), size),
        hot_(cells_.centers().size(), 0) {
    cell_.assign(here_.size(), kNoCell);
    for (const VertexId v : complex_.vertices) {
      const Xyz& here = here_[v.index()];  // one that is not settled may be in a cell on the grain only
      if (const auto cell = cells_.cell_of(settled[v.index()] ? here : on_grain(here, grain)))
        cell_[v.index()] = *cell;
      if (!settled[v.index()]) hot_[cell_[v.index()]] = 1;
    }
  }

  HotRoutes run() {
    list_points();
    cut_edges();
    cut_faces();
    place_points();
    number_goals();
    triangulate_faces();
    return std::move(routes_);
  }

 private:
  const Complex& complex_;
  const bool everywhere_;
  const Watch& watch_;
  HotRoutes routes_;
  std::vector<Xyz> here_;          // of each point its nearest doubles
  const BoxTree broken_;           // around faces with vertices that are no doubles
  const HotCells cells_;           // near those around each vertex, and wherever edges pass near each other
  std::vector<char> hot_;          // of each cell
  std::vector<std::size_t> cell_;  // of each point, or kNoCell
  PointTable table_;               // of all points, exact
  std::vector<std::vector<VertexId>> corners_;      // new ones in the interior of each face
  std::vector<std::uint32_t> goal_;                 // of each point the number of the place where it goes
  std::vector<std::vector<std::uint32_t>> joined_;  // of each place those to which an edge will go, if one is hot

  std::vector<Xyz> doubles_of_points() const {
    std::vector<Xyz> here(complex_.points.size());
    for_each_index(here.size(), [&](std::size_t i) {
      if (i % kUncheckedCells == 0) watch_.check();
      here[i] = nearest_doubles(complex_.points, VertexId(i));
    });
    return here;
  }

  Box box_of(FaceId f) const {
    Box box;
    for (const HalfEdge h : complex_.half_edges(f)) extend(box, complex_.origin(h));
    return box;
  }
  Box box_of(EdgeId e) const {
    Box box;
    for (const VertexId v : complex_.edge_ends[e]) extend(box, v);
    return box;
  }
  void extend(Box& box, VertexId v) const { box.extend(here_[v.index()], here_[v.index()]); }

  std::vector<Box> broken_places(const std::vector<char>& settled, double size) const {
    std::vector<Box> boxes;
    const auto add = [&](Box box) {
      for (std::size_t k = 0; k < 3; ++k) box.lo[k] -= size, box.hi[k] += size;
      boxes.push_back(box);
    };
    for (const FaceId f : IdRange<FaceId>(complex_.face_count())) {
      if (is_crossed(f, settled)) add(box_of(f));
    }
    for (const VertexId v : complex_.vertices) {
      if (settled[v.index()]) continue;
      Box box;
      extend(box, v);
      add(box);
    }
    return boxes;
  }
  /// True if a vertex of the face, or in it, is not doubles.
  bool is_crossed(FaceId f, const std::vector<char>& settled) const {
    const auto isolated = complex_.face_vertices[f];
    return std::any_of(isolated.begin(), isolated.end(), [&](VertexId v) { return !settled[v.index()]; }) ||
           std::ranges::any_of(complex_.half_edges(f),
                               [&](HalfEdge h) { return !settled[complex_.origin(h).index()]; });
  }
  bool is_near_broken(const Box& box) const {
    if (everywhere_) return true;
    bool near = false;
    broken_.query([&](const Box& other) { return !near && other.meets(box); },
                  [&](std::uint32_t) { near = true; });
    return near;
  }

  std::vector<Xyz> candidates(const std::vector<char>& settled, double size, double grain) const {
    std::vector<std::array<Xyz, 2>> edges;
    for (const EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      const auto& [a, b] = complex_.edge_ends[e];
      if (is_near_broken(box_of(e))) edges.push_back({here_[a.index()], here_[b.index()]});
    }
    std::vector<Xyz> places, fresh;  // what is doubles comes first: it stays where it is
    for (const VertexId v : complex_.vertices) {
      const Xyz& here = here_[v.index()];
      Box box;
      box.extend(here, here);
      if (!settled[v.index()]) fresh.push_back(here);
      else if (is_near_broken(box)) places.push_back(here);
    }
    const std::vector<Xyz> near = where_near(edges, size * HotCells::kPass, watch_);
    fresh.insert(fresh.end(), near.begin(), near.end());
    for (const Xyz& p : fresh) places.push_back(on_grain(p, grain));
    return places;
  }
  /// Doubles near zero are dense: surfaces that nearly coincide there would cross again and again if new points
  /// were only rounded to doubles.
  static Xyz on_grain(Xyz p, double grain) {
    for (double& c : p) c = std::nearbyint(c / grain) * grain + 0.0;  // no -0
    return p;
  }

  void list_points() {
    for (std::size_t i = 0; i < here_.size(); ++i) {
      if (i % kUncheckedCells == 0) watch_.check();
      const VertexId v(i);
      if (const double* const p = complex_.points.doubles(v)) table_.add(p[0], p[1], p[2]);
      else table_.add(complex_.points.rational(v));
    }
  }

  /// A new corner in a cell, which is hot by that.
  struct Corner {
    RationalPoint at;  // exactly on the edge or face that it is for
    Xyz here;          // its nearest doubles
    std::size_t cell;
  };
  static Corner corner(const RationalPoint& at, std::size_t cell) { return {at, to_doubles(at), cell}; }
  VertexId add(const Corner& corner) {
    here_.push_back(corner.here);
    cell_.push_back(corner.cell);
    hot_[corner.cell] = 1;
    return table_.add(corner.at);
  }

  void cut_edges() {
    std::vector<std::vector<Corner>> corners(complex_.edge_count());
    for_each_index(
        corners.size(),
        [&](std::size_t e) {
          watch_.check();
          if (is_near_broken(box_of(EdgeId(e)))) corners[e] = corners_on(EdgeId(e));
        },
        64);
    routes_.chains.resize(corners.size());
    for (const EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      const auto& [a, b] = complex_.edge_ends[e];
      std::vector<VertexId>& chain = routes_.chains[e.index()];
      if (e.index() % kUncheckedCells == 0) watch_.check();
      chain.push_back(a);
      for (const Corner& corner : corners[e.index()]) chain.push_back(add(corner));
      chain.push_back(b);
      corners[e.index()] = {};  // they may be many
    }
  }

  /// The new corners on an edge, in its order.
  std::vector<Corner> corners_on(EdgeId e) const {
    const VertexId a = complex_.edge_ends[e][0], b = complex_.edge_ends[e][1];
    std::vector<HotCells::Pass> passes = cells_.along(here_[a.index()], here_[b.index()]);
    std::erase_if(passes, [&](const HotCells::Pass& pass) {
      return pass.cell == cell_[a.index()] || pass.cell == cell_[b.index()];
    });
    std::vector<Corner> corners;
    if (passes.empty()) return corners;
    const RationalPoint from = table_.rational(a), way = table_.rational(b) - from;
    for (const HotCells::Pass& pass : passes)
      corners.push_back(corner(from + from_double(pass.along) * way, pass.cell));
    return corners;
  }

  void cut_faces() {
    std::vector<std::vector<HotCells::Pass>> passes(complex_.face_count());
    routes_.triangles.resize(passes.size());
    for_each_face([&](FaceId f) {
      routes_.triangles[f.index()] = triangles_of(f, walks_of(f), isolated_in(f));
      if (is_near_broken(box_of(f))) passes[f.index()] = passes_of(routes_.triangles[f.index()]);
    });
    corners_.resize(passes.size());
    for (const FaceId f : IdRange<FaceId>(complex_.face_count())) {
      if (f.index() % kUncheckedCells == 0) watch_.check();
      corners_[f.index()] = corners_in(f, routes_.triangles[f.index()], passes[f.index()]);
    }
  }

  void place_points() {
    routes_.to = here_;
    std::vector<double> moves(here_.size(), 0);
    for_each_index(here_.size(), [&](std::size_t i) {
      if (i % kUncheckedCells == 0) watch_.check();
      if (cell_[i] != kNoCell && hot_[cell_[i]]) routes_.to[i] = cells_.center(cell_[i]);
      const VertexId v(i);
      if (i >= complex_.points.size()) moves[i] = distance_to_doubles(here_[i], routes_.to[i]);
      else if (routes_.to[i] != here_[i] || !table_.is_double(v))
        moves[i] = distance_above(table_, v, routes_.to[i]);
    });
    routes_.displacement = *std::max_element(moves.begin(), moves.end());
  }
  /// At least the distance of a point whose nearest doubles are `here`.
  static double distance_to_doubles(const Xyz& here, const Xyz& to) {
    const double rounding = std::abs(here[0]) + std::abs(here[1]) + std::abs(here[2]);
    return hypotenuse(to[0] - here[0], to[1] - here[1], to[2] - here[2]) * (1 + 0x1p-50) + 0x1p-52 * rounding;
  }
  bool is_hot(VertexId v) const { return cell_[v.index()] != kNoCell && hot_[cell_[v.index()]]; }

  /// What goes to one place is one corner there; edges are between these.
  void number_goals() {
    std::unordered_map<Xyz, std::uint32_t, HashPoint> number;
    for (const Xyz& p : routes_.to)
      goal_.push_back(number.try_emplace(p, std::uint32_t(number.size())).first->second);
    joined_.resize(number.size());
    for (const auto& chain : routes_.chains) {
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        const std::size_t a = chain[k].index(), b = chain[k + 1].index();
        if ((!is_hot(chain[k]) && !is_hot(chain[k + 1])) || goal_[a] == goal_[b]) continue;
        joined_[goal_[a]].push_back(goal_[b]);
        joined_[goal_[b]].push_back(goal_[a]);
      }
    }
    for (auto& list : joined_) sort_unique(list);
  }

  void triangulate_faces() {
    for_each_face([&](FaceId f) {
      Walks walks = walks_of(f);
      std::vector<VertexId> isolated = isolated_in(f);
      isolated.insert(isolated.end(), corners_[f.index()].begin(), corners_[f.index()].end());
      const auto imprinted = edges_across(f, walks, isolated);
      for (const auto& [a, b] : imprinted) {
        walks.push_back({a, b});
        std::erase(isolated, a);
        std::erase(isolated, b);
      }
      Triangles& triangles = routes_.triangles[f.index()];
      if (!imprinted.empty() || !corners_[f.index()].empty()) triangles = triangles_of(f, walks, isolated);
      else if (!is_near_broken(box_of(f))) return;
      flip_edges(triangles, walks, [this, axes = axes(f)](VertexId p, VertexId a, VertexId q, VertexId b) {
        return is_better_there(axes, p, a, q, b);
      });
    });
  }

  /// Whether triangles (p, a, b) and (q, b, a) had better meet in pq. That depends on where the corners go only,
  /// as far as their face has room: all faces with these four have the same diagonal then, and none that passes by
  /// a corner that has come to lie between its ends. It is the Delaunay one, as angles tell it: of two that are as
  /// good that of the place with the least number.
  bool is_better_there(Projection axes, VertexId p, VertexId a, VertexId q, VertexId b) const {
    constexpr double kTie = 1e-9;
    if (orient2d(table_, axes, p, a, q) <= 0 || orient2d(table_, axes, q, b, p) <= 0) return false;
    const auto angle_at = [&](VertexId v) {  // its cosine and sine, times the lengths of the sides
      const auto from = [&](VertexId end) { return minus(routes_.to[end.index()], routes_.to[v.index()]); };
      const Xyz u = from(a), w = from(b), normal = accurate_cross(u, w);
      return std::array<double, 2>{dot(u, w), hypotenuse(normal[0], normal[1], normal[2])};
    };
    const auto [cos_p, sin_p] = angle_at(p);
    const auto [cos_q, sin_q] = angle_at(q);
    const double sum = sin_p * cos_q + cos_p * sin_q;  // the sine of both angles together
    if (std::abs(sum) > kTie * (sin_p * std::abs(cos_q) + std::abs(cos_p) * sin_q)) return sum < 0;
    const auto goal = [&](VertexId v) { return goal_[v.index()]; };
    return std::min(goal(p), goal(q)) < std::min(goal(a), goal(b));
  }

  template <class Body>
  void for_each_face(const Body& body) const {
    for_each_index(
        complex_.face_count(),
        [&](std::size_t f) {
          watch_.check();
          body(FaceId(f));
        },
        64);
  }

  /// What the face is to have besides its boundary. Chords between corners that go to one place come first: a
  /// narrow face, or a narrow part of one, is closed there, and no diagonal passes by. Then the edges of the
  /// drawing that will run along the face, from corner to corner of it, or it would cross them. Of those that
  /// cross here some are left to a later round.
  std::vector<EdgeEnds> edges_across(FaceId f, const Walks& walks, const std::vector<VertexId>& isolated) const {
    std::map<std::uint32_t, std::vector<VertexId>> at;  // corners by goals
    std::vector<EdgeEnds> all, across;
    const auto wish = [&](VertexId v, VertexId w) { across.push_back(ends_of(v, w)); };
    const auto take_fresh = [&] {
      sort_unique(across);
      std::erase_if(across, [&](const EdgeEnds& e) { return std::binary_search(all.begin(), all.end(), e); });
      return std::exchange(across, {});
    };
    for (const auto& walk : walks) {
      for (std::size_t k = 0; k < walk.size(); ++k) {
        at[goal_[walk[k].index()]].push_back(walk[k]);
        all.push_back(ends_of(walk[k], walk[(k + 1) % walk.size()]));
      }
    }
    for (const VertexId v : isolated) {
      at[goal_[v.index()]].push_back(v);
      all.push_back({v, v});
    }
    sort_unique(all);
    for (auto& [goal, corners] : at) {
      std::sort(corners.begin(), corners.end(), [&](auto v, auto w) { return compare_lex(table_, v, w) < 0; });
      corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
      for (std::size_t k = 0; k + 1 < corners.size(); ++k) wish(corners[k], corners[k + 1]);
    }
    const std::vector<EdgeEnds> chords = take_fresh();
    for (const auto& [goal, corners] : at) {
      if (!is_hot(corners[0])) continue;
      for (const std::uint32_t other : joined_[goal]) {
        if (const auto found = at.find(other); found != at.end()) wish(corners[0], found->second[0]);
      }
    }
    const std::vector<EdgeEnds> edges = take_fresh();
    if (chords.empty() && edges.empty()) return {};
    const std::size_t given = all.size();
    all.insert(all.end(), chords.begin(), chords.end());
    all.insert(all.end(), edges.begin(), edges.end());
    std::vector<Box> boxes;
    for (const EdgeEnds& ends : all) boxes.push_back(box(ends));
    const BoxTree tree(boxes);
    std::vector<char> taken(all.size(), 0);
    std::fill_n(taken.begin(), given, 1);
    std::vector<EdgeEnds> imprinted;
    for (std::size_t i = given; i < all.size(); ++i) {
      bool free = true;
      tree.query(
          [&](const Box& other) { return free && other.meets(boxes[i]); },
          [&](std::uint32_t other) { free = free && !(taken[other] && crosses(axes(f), all[i], all[other])); });
      if (!free) continue;
      taken[i] = 1;
      imprinted.push_back(all[i]);
    }
    return imprinted;
  }

  Box box(const EdgeEnds& ends) const {
    Box box;
    for (const VertexId v : ends) {
      const PointView p = table_.view(v);
      box.extend(p.lo, p.hi);
    }
    return box;
  }

  /// True if two segments of a face have a point in common that is no end of both. The second may be a point.
  bool crosses(Projection axes, const EdgeEnds& s, const EdgeEnds& t) const {
    const auto side = [&](const EdgeEnds& line, VertexId v) {
      return orient2d(table_, axes, line[0], line[1], v);
    };
    const auto holds = [&](const EdgeEnds& line, VertexId v) {  // in its interior
      if (v == line[0] || v == line[1] || line[0] == line[1] || side(line, v) != 0) return false;
      const int from = compare_lex(table_, line[0], v), to = compare_lex(table_, v, line[1]);
      return from == to;
    };
    if (holds(s, t[0]) || holds(s, t[1]) || holds(t, s[0]) || holds(t, s[1])) return true;
    if (t[0] == t[1]) return false;
    return side(s, t[0]) * side(s, t[1]) < 0 && side(t, s[0]) * side(t, s[1]) < 0;
  }

  Projection axes(FaceId f) const { return complex_.sheet_projection[complex_.face_sheet[f]]; }

  Walks walks_of(FaceId f) const {
    Walks walks;
    for (const LoopId l : complex_.face_loops[f]) {
      auto& walk = walks.emplace_back();
      for (const HalfEdge h : complex_.loop[l]) {
        const auto& chain = routes_.chains[h.edge().index()];
        if (h.direction() == 0) walk.insert(walk.end(), chain.begin(), chain.end() - 1);
        else walk.insert(walk.end(), chain.rbegin(), chain.rend() - 1);
      }
    }
    return walks;
  }
  std::vector<VertexId> isolated_in(FaceId f) const {
    const auto isolated = complex_.face_vertices[f];
    return {isolated.begin(), isolated.end()};
  }
  Triangles triangles_of(FaceId f, const Walks& walks, const std::vector<VertexId>& isolated) const {
    if (walks.size() == 1 && walks[0].size() == 3 && isolated.empty())
      return {{walks[0][0], walks[0][1], walks[0][2]}};
    return triangulate(table_, axes(f), walks, isolated);
  }

  /// The cells that a face passes through and nothing of its boundary does.
  std::vector<HotCells::Pass> passes_of(const Triangles& triangles) const {
    std::vector<HotCells::Pass> passes;
    for (const auto& [a, b, c] : triangles) {
      const auto found = cells_.across(here_[a.index()], here_[b.index()], here_[c.index()]);
      passes.insert(passes.end(), found.begin(), found.end());
    }
    if (passes.empty()) return passes;
    std::stable_sort(passes.begin(), passes.end(), [](const auto& p, const auto& q) { return p.cell < q.cell; });
    std::vector<std::size_t> known;
    for (const auto& t : triangles)
      for (const VertexId v : t) known.push_back(cell_[v.index()]);
    sort_unique(known);
    std::erase_if(passes, [&](const HotCells::Pass& pass) {
      return std::binary_search(known.begin(), known.end(), pass.cell);
    });
    return passes;
  }

  /// The new corners in the interior of a face.
  std::vector<VertexId> corners_in(FaceId f, const Triangles& triangles,
                                   const std::vector<HotCells::Pass>& passes) {
    const auto [u, v] = axes(f);
    std::set<std::array<Rational, 2>> places;  // as the projection shows them
    std::vector<VertexId> corners;
    std::size_t done = kNoCell;
    for (const HotCells::Pass& pass : passes) {  // ascending by cells
      if (pass.cell == done) continue;           // the triangles of a face have nearly the same foot there
      const std::array<Rational, 2> place{from_double(pass.foot[u]), from_double(pass.foot[v])};
      const RationalPoint at = on_plane(f, place);
      if (!is_inside(f, triangles, at)) continue;
      done = pass.cell;
      if (places.insert(place).second) corners.push_back(add(corner(at, pass.cell)));
    }
    return corners;
  }

  /// The point of the face's plane that the projection shows in a place.
  RationalPoint on_plane(FaceId f, const std::array<Rational, 2>& place) const {
    const auto [u, v] = axes(f);
    const ExactPlane& plane = complex_.points.exact_plane(complex_.sheet_plane[complex_.face_sheet[f]]);
    const std::array<const Integer*, 3> normal{&plane.a, &plane.b, &plane.c};
    const std::size_t w = 3u - u - v;
    RationalPoint at;
    at[u] = place[0], at[v] = place[1];
    at[w] =
        -(Rational(*normal[u]) * at[u] + Rational(*normal[v]) * at[v] + Rational(plane.d)) / Rational(*normal[w]);
    return at;
  }

  bool is_inside(FaceId f, const Triangles& triangles, const RationalPoint& at) const {
    const ExactPoint exact = ExactPoint::from(at);
    const PointView point = view_of(exact);
    int sides = 0;  // of triangles that the point is on
    for (const auto& t : triangles) {
      bool inside = true;
      int zeros = 0;
      for (std::size_t k = 0; k < 3 && inside; ++k) {
        const int side = orient2d(axes(f), table_.view(t[k]), table_.view(t[(k + 1) % 3]), point);
        inside = side >= 0;
        zeros += side == 0;
      }
      if (!inside) continue;
      if (zeros == 0) return true;
      sides += zeros == 1;
    }
    return sides == 2;  // between two of them
  }
};

}  // namespace

HotRoutes route(const Complex& complex, const std::vector<char>& settled, bool everywhere, double size,
                double grain, const Watch& watch) {
  return Router(complex, settled, everywhere, size, grain, watch).run();
}

}  // namespace cnrg
