// The result as a model, if it is one: its structure, the Euler-Poincare formula and each face are checked.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "bench/baseline/mantyla.h"
#include "bench/baseline/scene.h"

namespace cnrg::bench::mantyla {
namespace {

[[noreturn]] void fail_output(const std::string& what) { throw Failure(Stage::output, what); }

template <class N>
void check_face(const Scene<N>& scene, FaceId face) {
  const Plane<N>& plane = scene.plane(face);
  const std::vector<LoopId>& loops = scene.topology.face(face).loops;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const std::vector<HalfEdgeId> all = scene.topology.cycle(loops[k]);
    if (all.size() < 3) fail_output("a loop of less than three edges");
    for (const HalfEdgeId h : all)
      if (N(0) == scene.metric.length && scene.metric.side(plane, scene.point(scene.topology.origin(h))) != 0)
        fail_output("a face that is not planar");
    const N area = signed_area(scene, plane.normal, loops[k]);
    if (k == 0 ? !(area > 0) : !(area < 0)) fail_output("a loop of a face runs the wrong way or has no area");
  }
}

/// Edges of a model, by their points, ascending.
using Edges = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// Ear clipping of one face in the plane of its two larger coordinates. An edge that the model has already is made
/// again only where nothing else is left: its faces could not be told apart.
class Clipping {
 public:
  Clipping(const std::vector<std::array<double, 3>>& points, const std::vector<std::vector<std::uint32_t>>& loops,
           Edges& edges)
      : points_(points), polygon_(loops.front()), edges_(edges) {
    std::array<double, 3> normal = {0, 0, 0};
    for (std::size_t k = 2; k < polygon_.size(); ++k) {
      const auto n = cross(at(k - 1) - at(0), at(k) - at(0));
      for (int c = 0; c < 3; ++c) normal[c] += n[c];
    }
    const int axis = dominant_axis(normal);
    x_ = (axis + 1) % 3;
    y_ = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(x_, y_);
    std::vector<std::vector<std::uint32_t>> holes(loops.begin() + 1, loops.end());
    while (!holes.empty()) bridge(holes);
  }

  std::vector<std::array<std::uint32_t, 3>> run() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    while (polygon_.size() > 3) {
      const std::size_t ear = best_ear();
      const std::size_t n = polygon_.size();
      triangles.push_back({polygon_[(ear + n - 1) % n], polygon_[ear], polygon_[(ear + 1) % n]});
      edges_.insert(std::minmax(triangles.back()[0], triangles.back()[2]));
      polygon_.erase(polygon_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    if (shape(1) < -kFlat) fail_output("a face that cannot be cut into triangles");
    triangles.push_back({polygon_[0], polygon_[1], polygon_[2]});
    return triangles;
  }

 private:
  const std::array<double, 3>& at(std::size_t k) const { return points_[polygon_[k]]; }

  double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const auto &p = points_[a], &q = points_[b], &r = points_[c];
    return (q[x_] - p[x_]) * (r[y_] - p[y_]) - (q[y_] - p[y_]) * (r[x_] - p[x_]);
  }

  double distance2(std::uint32_t a, std::uint32_t b) const {
    const double dx = points_[a][x_] - points_[b][x_], dy = points_[a][y_] - points_[b][y_];
    return dx * dx + dy * dy;
  }

  bool crosses(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    if (a == c || a == d || b == c || b == d) return false;
    return (turn(a, b, c) > 0) != (turn(a, b, d) > 0) && (turn(c, d, a) > 0) != (turn(c, d, b) > 0);
  }

  /// Whether the bridge leaves a corner of the polygon into its inside.
  bool leaves_inward(std::size_t k, std::uint32_t to) const {
    const std::size_t n = polygon_.size();
    const std::uint32_t before = polygon_[(k + n - 1) % n], here = polygon_[k], after = polygon_[(k + 1) % n];
    const bool left = turn(here, after, to) > 0, right = turn(before, here, to) > 0;
    return turn(before, here, after) > 0 ? left && right : left || right;
  }

  bool crosses_any(std::uint32_t a, std::uint32_t b, const std::vector<std::uint32_t>& loop) const {
    for (std::size_t j = 0; j < loop.size(); ++j)
      if (crosses(a, b, loop[j], loop[(j + 1) % loop.size()])) return true;
    return false;
  }

  /// A hole into the polygon, over the shortest of all bridges that cross nothing.
  void bridge(std::vector<std::vector<std::uint32_t>>& holes) {
    std::size_t best_corner = 0, best_hole = holes.size(), best_start = 0;
    double best = 0;
    for (std::size_t h = 0; h < holes.size(); ++h)
      for (std::size_t s = 0; s < holes[h].size(); ++s)
        for (std::size_t k = 0; k < polygon_.size(); ++k) {
          const std::uint32_t from = polygon_[k], to = holes[h][s];
          const double length = distance2(from, to);
          if (best_hole < holes.size() && length >= best) continue;
          if (edges_.contains(std::minmax(from, to))) continue;
          if (!leaves_inward(k, to) || crosses_any(from, to, polygon_)) continue;
          if (std::any_of(holes.begin(), holes.end(),
                          [&](const auto& hole) { return crosses_any(from, to, hole); }))
            continue;
          best_corner = k;
          best_hole = h;
          best_start = s;
          best = length;
        }
    if (best_hole == holes.size()) fail_output("a hole of a face that cannot be reached");
    std::vector<std::uint32_t> with = holes[best_hole];
    std::rotate(with.begin(), with.begin() + static_cast<std::ptrdiff_t>(best_start), with.end());
    with.push_back(with.front());
    with.push_back(polygon_[best_corner]);
    edges_.insert(std::minmax(with.front(), with.back()));
    polygon_.insert(polygon_.begin() + static_cast<std::ptrdiff_t>(best_corner) + 1, with.begin(), with.end());
    holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(best_hole));
  }

  bool same_place(std::uint32_t a, std::uint32_t b) const {
    return points_[a][x_] == points_[b][x_] && points_[a][y_] == points_[b][y_];
  }

  /// The triangle at a corner is inside: no other corner in it, or on its border either. Corners at one place are
  /// told apart by the directions in which the polygon goes on.
  bool is_ear(std::size_t k, bool border) const {
    const std::size_t n = polygon_.size();
    const std::uint32_t a = polygon_[(k + n - 1) % n], b = polygon_[k], c = polygon_[(k + 1) % n];
    if (!leaves_inward((k + n - 1) % n, c) || !leaves_inward((k + 1) % n, a)) return false;
    const auto beside = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
      const double height = turn(p, q, r), flat = kFlat * distance2(p, q);
      return border ? height < -flat : height <= flat;
    };
    for (const std::uint32_t p : polygon_) {
      if (same_place(p, a) || same_place(p, b) || same_place(p, c)) continue;
      if (!beside(a, b, p) && !beside(b, c, p) && !beside(c, a, p)) return false;
    }
    return true;
  }

  /// The ear with the best shape: area by the longest side. Without any, the flattest corner if it is flat up to
  /// rounding.
  std::size_t best_ear() const {
    const std::size_t n = polygon_.size();
    std::vector<std::pair<double, std::size_t>> corners;
    for (std::size_t k = 0; k < n; ++k)
      if (const double s = shape(k); s > 0) corners.push_back({-s, k});
    std::sort(corners.begin(), corners.end());
    const auto is_new = [&](std::size_t k) {
      return !edges_.contains(std::minmax(polygon_[(k + n - 1) % n], polygon_[(k + 1) % n]));
    };
    for (const auto& [s, k] : corners)
      if (is_new(k) && is_ear(k, true)) return k;
    for (const bool border : {true, false})
      for (const auto& [s, k] : corners)
        if (is_ear(k, border)) return k;
    std::size_t flattest = 0;
    for (std::size_t k = 1; k < n; ++k)
      if (std::fabs(shape(k)) < std::fabs(shape(flattest))) flattest = k;
    if (std::fabs(shape(flattest)) > kFlat) fail_output("a face that cannot be cut into triangles");
    return flattest;
  }

  /// Area by the square of the longest side; 0 where two corners are at one place.
  double shape(std::size_t k) const {
    const std::size_t n = polygon_.size();
    const std::uint32_t a = polygon_[(k + n - 1) % n], b = polygon_[k], c = polygon_[(k + 1) % n];
    const double longest = std::max({distance2(a, b), distance2(b, c), distance2(c, a)});
    return longest > 0 ? turn(a, b, c) / longest : 0;
  }

  static constexpr double kFlat = 1e-9;  ///< a shape that rounding may turn over

  const std::vector<std::array<double, 3>>& points_;
  std::vector<std::uint32_t> polygon_;
  Edges& edges_;
  int x_ = 0, y_ = 1;
};

/// Vertices become points, in the order of the faces.
template <class N>
class Writer {
 public:
  explicit Writer(const Scene<N>& scene) : scene_(scene), topology_(scene.topology) {}

  Model run(const std::vector<FaceId>& faces) {
    std::set<FaceId> ours(faces.begin(), faces.end());
    for (const FaceId f : faces)
      staged(
          Stage::output, [&] { add_face(f, ours); },
          [&] { return places_of(scene_, topology_.loop(topology_.face(f).loops.front()).start); });
    return std::move(model_);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  void add_face(FaceId f, const std::set<FaceId>& ours) {
    if (scene_.departures.checks) check_face(scene_, f);
    model_.faces.emplace_back();
    for (const LoopId loop : topology_.face(f).loops) {
      model_.faces.back().loops.emplace_back();
      auto& polygon = model_.faces.back().loops.back();
      for (const HalfEdgeId h : topology_.cycle(loop)) {
        check(scene_.departures, ours.contains(topology_.face(topology_.mate(h))), Stage::output,
              "the result is open");
        polygon.push_back(vertex(topology_.origin(h)));
        const std::uint32_t middle = middle_of(h);
        if (middle != kNone) polygon.push_back(middle);
      }
      if (polygon.size() < 3) fail_output("a loop of less than three edges");
    }
  }

  std::uint32_t add(const Vec<N>& p) {
    model_.points.push_back(exact(p));
    return static_cast<std::uint32_t>(model_.points.size() - 1);
  }

  std::uint32_t vertex(VertexId v) {
    const auto [found, fresh] = vertices_.emplace(v, 0);
    if (fresh) found->second = add(scene_.point(v));
    return found->second;
  }

  /// Loops of vertices do not tell edges with the same ends apart: all but the first of them get a vertex.
  std::uint32_t middle_of(HalfEdgeId h) {
    const EdgeId edge = topology_.edge(h);
    const VertexId v = topology_.origin(h), w = topology_.target(h);
    const EdgeId first = first_edges_.emplace(std::minmax(v, w), edge).first->second;
    if (first == edge) return kNone;
    const auto [found, fresh] = middles_.emplace(edge, 0);
    if (fresh) found->second = add((scene_.point(v) + scene_.point(w)) * N(N(1) / N(2)));
    return found->second;
  }

  const Scene<N>& scene_;
  const Topology& topology_;
  Model model_;
  std::map<VertexId, std::uint32_t> vertices_;
  std::map<std::pair<VertexId, VertexId>, EdgeId> first_edges_;
  std::map<EdgeId, std::uint32_t> middles_;
};

}  // namespace

template <class N>
Model write_result(const Scene<N>& scene, const std::vector<FaceId>& faces) {
  try {
    if (scene.departures.checks) scene.topology.validate();
  } catch (const TopologyError& error) {
    fail_output(error.what());
  }
  return Writer<N>(scene).run(faces);
}

Model triangulated(const Model& model) {
  std::vector<std::array<double, 3>> points;
  for (const RationalPoint& p : model.points)
    points.push_back({to_double(p[0]), to_double(p[1]), to_double(p[2])});
  Edges edges;
  for (const Model::Face& face : model.faces)
    for (const auto& loop : face.loops)
      for (std::size_t k = 0; k < loop.size(); ++k)
        edges.insert(std::minmax(loop[k], loop[(k + 1) % loop.size()]));
  Model result;
  result.points = model.points;
  for (const Model::Face& face : model.faces) {
    if (face.loops.size() == 1 && face.loops[0].size() == 3) {
      result.faces.push_back(face);
      continue;
    }
    staged(
        Stage::output,
        [&] {
          for (const auto& [a, b, c] : Clipping(points, face.loops, edges).run())
            result.faces.push_back({{{a, b, c}}, true});
        },
        [&] { return Failure::Places{model.points[face.loops[0][0]]}; });
  }
  return result;
}

template Model write_result(const Scene<double>&, const std::vector<FaceId>&);
template Model write_result(const Scene<Rational>&, const std::vector<FaceId>&);

}  // namespace cnrg::bench::mantyla
