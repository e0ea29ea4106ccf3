// Which surfaces a point lies on, where it goes, and what goes back; see the header.
#include "csg/mesh/curved_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "csg/curves/surface_placed.h"
#include "csg/mesh/exact_volume.h"
#include "csg/mesh/second_order.h"
#include "csg/mesh/straight_order.h"
#include "csg/result/flat.h"
#include "kernel/base/counts.h"
#include "kernel/base/error.h"
#include "kernel/base/parallel.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {
namespace {

using namespace surface_math;
using Index = Mesh::Index;
using Point = Vector3<double>;

Point middle_of(const Point& a, const Point& b) {
  return {a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2, a[2] / 2 + b[2] / 2};
}

/// A true surface, as the patches on it describe it, and places to begin a search at: the middles of their cells.
class SurfaceChart {
 public:
  /// `patch` outlives the chart.
  void add_cell(const PlacedSurface& patch, const std::vector<PatchCorner>& cell) {
    Start start{&patch};
    Point at{0, 0, 0};
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (const PatchCorner& corner : cell) {
      for (std::size_t k = 0; k < 3; ++k) at[k] += to_double(corner.point[k]) / static_cast<double>(cell.size());
      for (std::size_t d = 0; d < 2; ++d) {
        const double x = to_double(corner.at[d]);
        start.at[d] += x / static_cast<double>(cell.size());
        low[d] = std::min(low[d], x), high[d] = std::max(high[d], x);
      }
    }
    for (std::size_t d = 0; d < 2; ++d) start.reach[d] = 4 * (high[d] - low[d]);  // more at poles
    places_.emplace_back().extend(at, at);
    starts_.push_back(start);
  }
  void settle() { tree_.emplace(places_); }

  /// Up to `count` sites to begin at for a point, the nearest first.
  std::vector<SurfaceSite> sites(const Point& p, unsigned count) const {
    const auto square = [&](const Box& box) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double off = std::max({box.lo[k] - p[k], p[k] - box.hi[k], 0.0});
        sum += off * off;
      }
      return sum;
    };
    std::set<std::pair<double, std::size_t>> found;  // squares of distances
    tree_->query([&](const Box& box) { return found.size() < count || square(box) <= found.rbegin()->first; },
                 [&](std::uint32_t i) {
                   found.emplace(square(places_[i]), i);
                   if (found.size() > count) found.erase(std::prev(found.end()));
                 });
    std::vector<SurfaceSite> result;
    result.reserve(found.size());
    for (const auto& [distance, i] : found) {
      const Start& start = starts_[i];
      result.push_back({start.patch, start.at, start.reach, {}, {}});
    }
    return result;
  }

 private:
  struct Start {
    const PlacedSurface* patch;
    std::array<double, 2> at{0, 0}, reach{0, 0};
  };
  std::vector<Start> starts_;
  std::vector<Box> places_;  // of no size
  std::optional<BoxTree> tree_;
};

/// What a face of the result lies on: a surface, or a plane, or nothing that is known.
struct Carrier {
  const SurfaceChart* chart = nullptr;
  bool plane = false;
  Point point{}, normal{};
};

class Bender {
 public:
  Bender(const ResultView& view, TetrahedralMesh& made, const Watch& watch)
      : watch_(watch), made_(made), mesh_(made.mesh), flat_(flatten(view)) {
    watch_.begin("bend: surfaces");
    find_carriers(view);
    original_ = mesh_.points;
    const auto add = [&](std::vector<Index>& list, Index face) {
      if (std::find(list.begin(), list.end(), face) == list.end()) list.push_back(face);
    };
    point_faces_.resize(mesh_.points.size());
    for (const auto& t : mesh_.triangles) {
      const Index number = Index(&t - mesh_.triangles.data());
      if (carriers_[t.entity].chart != nullptr) curved_sides_[sorted(t.points)] = number;
      for (std::size_t k = 0; k < 3; ++k) {
        add(point_faces_[t.points[k]], t.entity);
        add(edge_faces_[key(t.points[k], t.points[(k + 1) % 3])], t.entity);
      }
    }
    wired_.resize(mesh_.points.size());
    for (const auto& s : mesh_.segments) {
      if (!mesh_.entities[1][s.entity].wire) continue;
      for (const Index p : s.points) wired_[p] = 1;
    }
    for (const auto& s : mesh_.segments) on_edges_.insert(key(s.points[0], s.points[1]));
    watch_.check();
    for (const Edge& edge : edges_of(mesh_)) edges_.insert(edges_.end(), edge);
    watch_.check();
  }

  CurvedReport run() {
    move_points();
    bend_edges();
    undo_folds();
    finish();
    return report_;
  }

 private:
  using Edge = std::array<Index, 2>;
  static constexpr Index kDropped = FlatComplex::kNone;  // as the entity of a tetrahedron that is left out
  static Edge key(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

  void find_carriers(const ResultView& view) {
    require(view.parameters != nullptr, "curved meshes need the parameters of the result");
    for (const FlatComplex::Face& face : flat_.faces) {
      watch_.check();
      Carrier carrier;
      const auto add = [&](const FlatComplex::Patch& patch, const std::vector<PatchCorner>& cell) {
        const PlacedSurface& surface = patch_surface(view, patch);
        if (surface.flat()) return;
        SurfaceChart& chart = charts_[{face.surface, face.surface == 0 ? patch : FlatComplex::Patch()}];
        chart.add_cell(surface, cell);
        carrier.chart = &chart;
      };
      for (const auto& facet : face.cells) {
        for (const auto& cell : facet) add(*face.patch, cell);
      }
      for (const auto& [patch, cell] : face.cells_of_patches) add(patch, cell);
      if (carrier.chart != nullptr) {
        carriers_.push_back(carrier);
        continue;
      }
      if (face.facets.empty()) {
        carrier.plane = true;
        double most = -1;
        for (const auto& t : face.triangles) {
          std::array<Point, 3> p;
          for (std::size_t k = 0; k < 3; ++k) p[k] = view.complex->points.approx(flat_.points[t[k]]);
          const Point n = cross(difference(p[1], p[0]), difference(p[2], p[0]));
          if (dot(n, n) > most) most = dot(n, n), carrier.point = p[0], carrier.normal = n;
        }
      }
      carriers_.push_back(carrier);
    }
    for (auto& [surface, chart] : charts_) chart.settle();
  }

  const PlacedSurface& patch_surface(const ResultView& view, const FlatComplex::Patch& patch) {
    return surfaces_
        .try_emplace(patch, view.parameters->surfaces(patch.first), patch.second,
                     view.parameters->transform(patch.first))
        .first->second;
  }

  /// True if one of the faces is curved.
  bool curved(const std::vector<Index>& faces) const {
    return std::any_of(faces.begin(), faces.end(), [&](Index f) { return carriers_[f].chart != nullptr; });
  }

  /// The point on all surfaces of the faces that is near to p.
  std::optional<Point> on_surfaces(const std::vector<Index>& faces, const Point& p) const {
    std::set<const SurfaceChart*> charts;
    std::vector<SurfaceSite> planes;
    for (const Index f : faces) {
      const Carrier& carrier = carriers_[f];
      if (carrier.chart != nullptr) charts.insert(carrier.chart);
      else if (carrier.plane) planes.push_back({nullptr, {}, {}, carrier.point, carrier.normal});
      else return std::nullopt;
    }
    constexpr unsigned kStarts = 4;
    std::vector<std::vector<SurfaceSite>> starts;
    for (const Index f : faces) {  // in the order of the faces, each chart once
      if (carriers_[f].chart != nullptr && charts.erase(carriers_[f].chart) == 1)
        starts.push_back(carriers_[f].chart->sites(p, kStarts));
    }
    for (unsigned k = 0; k < kStarts; ++k) {
      std::vector<SurfaceSite> sites = planes;
      for (const auto& of : starts) sites.push_back(of[std::min<std::size_t>(k, of.size() - 1)]);
      if (const auto found = find_common(sites, p)) return found;
    }
    return std::nullopt;
  }

  void move_points() {
    std::vector<std::optional<Point>> target(mesh_.points.size());
    const auto stays = [&](std::size_t p) { return wired_[p] || !curved(point_faces_[p]); };
    Steps steps(watch_, "bend: points", target.size());
    for_each_index(
        target.size(),
        [&](std::size_t p) {
          if (!stays(p)) target[p] = on_surfaces(point_faces_[p], original_[p]);
          steps.step();
        },
        64);
    std::vector<double> longest(mesh_.points.size(), 0);  // of the edges at a point
    for (const auto& [a, b] : edges_) {
      const double length = distance(original_[a], original_[b]);
      longest[a] = std::max(longest[a], length);
      longest[b] = std::max(longest[b], length);
    }
    for (Index p = 0; p < target.size(); ++p) {
      if (stays(p)) continue;
      if (!target[p] || distance(*target[p], original_[p]) > longest[p]) {
        ++report_.left;
      } else if (*target[p] != original_[p]) {
        mesh_.points[p] = *target[p];
        moved_.insert(p);
        report_.farthest = std::max(report_.farthest, distance(*target[p], original_[p]));
      }
    }
    report_.moved = moved_.size();
    follow();
  }

  /// Points inside of regions go along with those on their boundaries: each by the mean of what its neighbours go,
  /// so that elements that are small beside the moves keep their shape.
  void follow() {
    std::vector<char> inside(mesh_.points.size(), 0);
    for (const auto& t : mesh_.tetrahedra) {
      for (const Index p : t.points) inside[p] = point_faces_[p].empty() && !wired_[p];
    }
    for (const auto& v : mesh_.vertices) inside[v.points[0]] = 0;
    std::vector<std::vector<Index>> neighbours(mesh_.points.size());
    for (const auto& [a, b] : edges_) {
      if (inside[a]) neighbours[a].push_back(b);
      if (inside[b]) neighbours[b].push_back(a);
    }
    constexpr int kRounds = 40;
    std::vector<Point> way(mesh_.points.size()), next;
    for (std::size_t p = 0; p < way.size(); ++p) way[p] = difference(mesh_.points[p], original_[p]);
    for (int round = 0; round < kRounds; ++round) {
      watch_.check();
      next = way;
      for_each_index(
          way.size(),
          [&](std::size_t p) {
            if (!inside[p] || neighbours[p].empty()) return;
            Point all{0, 0, 0};
            for (const Index q : neighbours[p]) all = sum(all, way[q]);
            next[p] = scaled(1 / static_cast<double>(neighbours[p].size()), all);
          },
          256);
      way.swap(next);
    }
    for (Index p = 0; p < way.size(); ++p) {
      if (!inside[p] || dot(way[p], way[p]) == 0) continue;
      mesh_.points[p] = sum(original_[p], way[p]);
      moved_.insert(p);
    }
  }

  void bend_edges() {
    std::vector<Edge> on_faces;
    for (const auto& [edge, faces] : edge_faces_) {
      if (curved(faces) && !(wired_[edge[0]] && wired_[edge[1]])) on_faces.push_back(edge);
    }
    std::vector<std::optional<Point>> target(on_faces.size());
    Steps steps(watch_, "bend: edges", on_faces.size());
    for_each_index(
        on_faces.size(),
        [&](std::size_t i) {
          const auto& [a, b] = on_faces[i];
          target[i] = on_surfaces(edge_faces_.at(on_faces[i]), middle_of(mesh_.points[a], mesh_.points[b]));
          steps.step();
        },
        64);
    for (std::size_t i = 0; i < on_faces.size(); ++i) bend(on_faces[i], target[i]);
  }

  void bend(const Edge& edge, const std::optional<Point>& target) {
    const Point straight = middle_of(mesh_.points[edge[0]], mesh_.points[edge[1]]);
    const double length = distance(mesh_.points[edge[0]], mesh_.points[edge[1]]);
    if (!target || distance(*target, straight) > length) {
      ++report_.left;
    } else if (distance(*target, straight) > 1e-14 * length) {
      bent_[edge] = *target;
      was_bent_.insert(edge);
    }
  }

  Point middle(const Edge& edge) const {
    const auto it = bent_.find(edge);
    return it != bent_.end() ? it->second : middle_of(mesh_.points[edge[0]], mesh_.points[edge[1]]);
  }

  SecondOrderNodes nodes_of(const Mesh::Simplex<4>& t) const {
    SecondOrderNodes nodes;
    for (std::size_t k = 0; k < 4; ++k) nodes[k] = mesh_.points[t.points[k]];
    for (std::size_t e = 0; e < 6; ++e) {
      nodes[4 + e] = middle(key(t.points[kSecondOrderEdges[e][0]], t.points[kSecondOrderEdges[e][1]]));
    }
    return nodes;
  }

  template <class Body>
  static void for_each_edge(const Mesh::Simplex<4>& t, const Body& body) {
    for (const auto& [i, j] : kSecondOrderEdges) body(key(t.points[i], t.points[j]));
  }

  /// Two sides of one tetrahedron on one smooth surface have to meet at an angle of 180 degrees once they are
  /// bent, and then it has no volume there. Where nothing else is at the edge between them, the tetrahedron is
  /// left out, and its other two sides take the place of these: they are as near to the surface. True if that was
  /// done.
  bool drop_pinched(std::size_t number, std::map<Index, std::vector<std::size_t>>& around) {
    const Mesh::Simplex<4> t = mesh_.tetrahedra[number];
    std::vector<std::size_t> opposite;  // corners opposite to curved sides
    std::vector<Index> sides;           // their triangles
    for (std::size_t k = 0; k < 4; ++k) {
      const auto it = curved_sides_.find(
          sorted(std::array{t.points[(k + 1) % 4], t.points[(k + 2) % 4], t.points[(k + 3) % 4]}));
      if (it == curved_sides_.end()) continue;
      opposite.push_back(k);
      sides.push_back(it->second);
    }
    if (sides.size() != 2 || mesh_.triangles[sides[0]].entity != mesh_.triangles[sides[1]].entity) return false;
    // The sides are a b c and b a d.
    const Index d = t.points[opposite[0]], c = t.points[opposite[1]];
    std::array<Index, 3> first = mesh_.triangles[sides[0]].points;
    while (first[2] != c) std::rotate(first.begin(), first.begin() + 1, first.end());
    const auto [a, b, rest] = first;
    const Point n = normal_of({a, b, c}), m = normal_of({b, a, d});
    if (dot(n, m) < 0.5 * std::sqrt(dot(n, n) * dot(m, m))) return false;
    if (on_edges_.contains(key(a, b)) || on_edges_.contains(key(c, d)) || edge_faces_.contains(key(c, d)))
      return false;
    for (const std::size_t i : around[a]) {
      const auto& points = mesh_.tetrahedra[i].points;
      if (i != number && std::find(points.begin(), points.end(), b) != points.end()) return false;
    }
    const std::vector<Index> faces = edge_faces_.at(key(a, b));
    mesh_.triangles[sides[0]].points = {c, a, d};
    mesh_.triangles[sides[1]].points = {d, b, c};
    curved_sides_.erase(sorted(std::array{a, b, c}));
    curved_sides_.erase(sorted(std::array{a, b, d}));
    curved_sides_[sorted(std::array{a, c, d})] = sides[0];
    curved_sides_[sorted(std::array{b, c, d})] = sides[1];
    bent_.erase(key(a, b));
    edges_.erase(key(a, b));
    was_bent_.erase(key(a, b));
    edge_faces_.erase(key(a, b));
    edge_faces_[key(c, d)] = faces;
    bend(key(c, d), on_surfaces(faces, middle_of(mesh_.points[c], mesh_.points[d])));
    for (const Index p : t.points) std::erase(around[p], number);
    mesh_.tetrahedra[number].entity = kDropped;
    --made_.regions[t.entity].tetrahedra;
    return true;
  }

  Point normal_of(const std::array<Index, 3>& t) const {
    return cross(difference(original_[t[1]], original_[t[0]]), difference(original_[t[2]], original_[t[0]]));
  }

  /// Middles go back to straight edges, then points to where they were, until no element folds.
  void undo_folds() {
    std::map<Index, std::vector<std::size_t>> around;  // elements at each point
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < mesh_.tetrahedra.size(); ++i) {
      watch_.check();
      open.push_back(i);
      for (const Index p : mesh_.tetrahedra[i].points) around[p].push_back(i);
    }
    while (!open.empty()) {
      std::vector<char> good(open.size());
      Steps steps(watch_, "bend: folds", open.size());
      for_each_index(
          open.size(),
          [&](std::size_t k) {
            good[k] = has_positive_determinant(nodes_of(mesh_.tetrahedra[open[k]]));
            steps.step();
          },
          64);
      std::set<std::size_t> again;
      const auto ask_about = [&](Index p) { again.insert(around[p].begin(), around[p].end()); };
      for (std::size_t k = 0; k < open.size(); ++k) {
        if (good[k]) continue;
        if (mesh_.tetrahedra[open[k]].entity == kDropped) continue;
        if (drop_pinched(open[k], around)) {
          for (const Index p : mesh_.tetrahedra[open[k]].points) ask_about(p);
          again.erase(open[k]);
          continue;
        }
        const Mesh::Simplex<4> t = mesh_.tetrahedra[open[k]];
        bool changed = false;
        for_each_edge(t, [&](const Edge& edge) {
          if (bent_.erase(edge) == 0) return;
          changed = true;
          ask_about(edge[0]);
        });
        if (changed) continue;
        for (const Index p : t.points) {
          if (moved_.erase(p) == 0) continue;
          changed = true;
          mesh_.points[p] = original_[p];
          ask_about(p);
          for (const std::size_t i : around[p]) {
            for_each_edge(mesh_.tetrahedra[i], [&](const Edge& edge) {
              if (edge[0] != p && edge[1] != p) return;
              bent_.erase(edge);
              ask_about(edge[0]);
            });
          }
        }
        // Others may have changed it meanwhile; else it is as TetGen made it.
        if (!changed && !again.contains(open[k])) require_straight(t);
      }
      open.assign(again.begin(), again.end());
    }
  }

  /// An element as it was, but for the rounding of its middles.
  void require_straight(const Mesh::Simplex<4>& t) const {
    if (has_positive_determinant(nodes_of(t))) return;
    throw InputError(
        "a tetrahedron is so flat that it is not proven to be turned right once its edges have rounded middles; "
        "give "
        "--quality 2, or mesh without --curved");
  }

  void finish() {
    std::erase_if(mesh_.tetrahedra, [](const auto& t) { return t.entity == kDropped; });
    report_.middles = bent_.size();
    report_.curved.assign(made_.regions.size(), 0);
    report_.straight.assign(made_.regions.size(), 0);
    std::vector<double> more(made_.regions.size(), 0);
    ExactVolume exact(mesh_.points);
    std::vector<Rational> straight(made_.regions.size());
    watch_.begin("bend: volumes");
    for (std::size_t i = 0; i < mesh_.tetrahedra.size(); ++i) {
      watch_.check();
      const Mesh::Simplex<4>& t = mesh_.tetrahedra[i];
      exact.add(t.points[0], t.points[1], t.points[2], t.points[3]);
      if (i + 1 == mesh_.tetrahedra.size() || mesh_.tetrahedra[i + 1].entity != t.entity) {
        straight[t.entity] = exact.value();
        exact.clear();
      }
      bool bends = false, lost = false;
      for_each_edge(t, [&](const Edge& edge) {
        const bool has = bent_.contains(edge);
        bends = bends || has;
        lost = lost || (!has && was_bent_.contains(edge));
      });
      if (lost) ++report_.straight[t.entity];
      else if (bends) ++report_.curved[t.entity];
      if (!bends) continue;
      const auto [six, six_straight] = six_volumes(nodes_of(t));
      more[t.entity] += (six - six_straight) / 6;
    }
    for (std::size_t r = 0; r < made_.regions.size(); ++r)
      made_.regions[r].volume = straight[r] + from_double(more[r]);
    mesh_.middles.clear();
    for (const Edge& edge : edges_) {
      mesh_.middles.emplace_back(edge, next_number(mesh_.points.size(), "points"));
      mesh_.points.push_back(middle(edge));
    }
  }

  const Watch& watch_;
  TetrahedralMesh& made_;
  Mesh& mesh_;
  const FlatComplex flat_;
  std::map<FlatComplex::Patch, PlacedSurface> surfaces_;
  // By the surface of the result's faces; where it has no number, by their patch.
  std::map<std::pair<std::uint32_t, FlatComplex::Patch>, SurfaceChart> charts_;
  std::vector<Carrier> carriers_;  // of each face
  std::vector<Point> original_;
  std::vector<std::vector<Index>> point_faces_;
  std::map<Edge, std::vector<Index>> edge_faces_;
  std::vector<char> wired_;  // points of wires stay on them
  std::set<Edge> edges_;
  std::set<Edge> on_edges_;                             // of the result
  std::map<std::array<Index, 3>, Index> curved_sides_;  // triangles by their corners, ascending
  std::set<Index> moved_;
  std::map<Edge, Point> bent_;
  std::set<Edge> was_bent_;  // before anything went back
  CurvedReport report_;
};

}  // namespace

Mesh::Index Mesh::middle(Index a, Index b) const {
  const std::array<Index, 2> edge{std::min(a, b), std::max(a, b)};
  const auto it = std::lower_bound(middles.begin(), middles.end(), edge,
                                   [](const auto& entry, const auto& key) { return entry.first < key; });
  require(it != middles.end() && it->first == edge, "mesh: a middle of what is no edge");
  return it->second;
}

CurvedReport curve(const ResultView& view, TetrahedralMesh& made, const Watch& watch) {
  return Bender(view, made, watch).run();
}

}  // namespace cnrg
