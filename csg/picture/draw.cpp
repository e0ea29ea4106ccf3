#include "csg/picture/draw.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>

#include "csg/picture/make_scene.h"
#include "csg/picture/visibility.h"
#include "csg/result/result_data.h"
#include "kernel/base/error.h"
#include "kernel/base/hypotenuse.h"
#include "kernel/base/vectors.h"
#include "kernel/refine/box.h"

namespace cnrg {
namespace {

using Index = Scene::Index;
using Vector = DoubleVector;
using Loops = std::vector<std::vector<Point2>>;

/// Distance to the border, negative outside.
double room_at(const Loops& loops, const Point2& p) {
  bool inside = false;
  double nearest = INFINITY;
  for (const auto& loop : loops) {
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
      const auto& [ax, ay] = loop[j];
      const auto& [bx, by] = loop[i];
      if ((ay > p[1]) != (by > p[1]) && p[0] < (bx - ax) * (p[1] - ay) / (by - ay) + ax) inside = !inside;
      const double dx = bx - ax, dy = by - ay, size = dx * dx + dy * dy;
      const double t = size == 0 ? 0 : std::clamp(((p[0] - ax) * dx + (p[1] - ay) * dy) / size, 0.0, 1.0);
      nearest = std::min(nearest, hypotenuse(ax + t * dx - p[0], ay + t * dy - p[1]));
    }
  }
  return inside ? nearest : -nearest;
}

/// The middle of nearly the largest disk in what the loops enclose, and its radius: the best place within
/// 1/50 of the area's extent (Agafonkin's quadtree search, "polylabel").
Figure::Label::Place place_with_room(const Loops& loops) {
  Point2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  for (const auto& loop : loops) {
    for (const Point2& p : loop) {
      for (std::size_t k = 0; k < 2; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    }
  }
  const double width = high[0] - low[0], height = high[1] - low[1], side = std::min(width, height);
  if (!(side > 0)) return {};
  struct Square {
    Point2 middle;
    double half, room;
    double most() const { return room + half * M_SQRT2; }
    bool operator<(const Square& other) const { return most() < other.most(); }
  };
  std::priority_queue<Square> open;
  const auto push = [&](const Point2& middle, double half) { open.push({middle, half, room_at(loops, middle)}); };
  const double half = side / 2, precision = side / 50;
  for (double x = low[0] + half; x < high[0] + half; x += side) {
    for (double y = low[1] + half; y < high[1] + half; y += side) push({x, y}, half);
  }
  Square best{{}, 0, 0};
  for (int steps = 0; !open.empty() && steps < 2000; ++steps) {
    const Square at = open.top();
    open.pop();
    if (at.room > best.room) best = at;
    if (at.most() - best.room <= precision) break;
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5})
        push({at.middle[0] + x * at.half, at.middle[1] + y * at.half}, at.half / 2);
    }
  }
  return {best.middle, best.room};
}

constexpr double kLights = 40;  // steps from dark to light

/// The area of a facet as a vector, in units of the largest coordinate.
Vector area_of(const std::vector<Vector>& points, const Scene::Loop& loop) {
  const Vector& o = points[loop.front()];
  Vector n{};
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const Vector part = cross(minus(points[loop[i]], o), minus(points[loop[i + 1]], o));
    for (std::size_t k = 0; k < 3; ++k) n[k] += part[k];
  }
  return n;
}

/// How light each facet is, in steps: the light comes over the left shoulder of who looks. A facet of a curved
/// surface leans towards its neighbours, so that the triangles of one quadrangle do not show.
void set_light(Scene& scene) {
  Rational most = 0;
  for (const RationalPoint& p : scene.points) {
    for (const Rational& x : p) most = std::max<Rational>(most, abs(x));
  }
  if (most == 0) return;
  std::vector<Vector> points;
  for (const RationalPoint& p : scene.points) {
    points.push_back({to_double(p[0] / most), to_double(p[1] / most), to_double(p[2] / most)});
  }
  std::vector<Vector> areas;
  std::map<std::pair<Index, Index>, Vector> at;  // by surface and point
  for (const Scene::Facet& facet : scene.facets) {
    areas.push_back(area_of(points, facet.loops.front()));
    for (const Index p : facet.loops.front()) {
      for (std::size_t k = 0; k < 3; ++k) at[{facet.surface, p}][k] += areas.back()[k];
    }
  }
  for (std::size_t f = 0; f < scene.facets.size(); ++f) {
    Scene::Facet& facet = scene.facets[f];
    Vector n{};
    for (const Index p : facet.loops.front()) {
      const Vector& sum = at[{facet.surface, p}];
      const double size = length(sum);
      for (std::size_t k = 0; k < 3 && size > 0; ++k) n[k] += sum[k] / size;
    }
    constexpr Vector kLight{-0.42, 0.72, 0.55};
    const double turn = areas[f][2] < 0 ? -1 : 1, size = length(n) * length(kLight);
    const double cosine = size > 0 ? turn * dot(n, kLight) / size : 0;
    facet.light = static_cast<int>(std::llround(kLights * (0.74 + 0.30 * cosine)));
  }
}

/// From what is seen to what is painted: colors in light and shade, one above the other; texts where there is
/// room.
class Finisher {
 public:
  Finisher(const Scene& scene, const SeenScene& seen, const Rational& scale)
      : scene_(scene), seen_(seen), scale_(to_double(scale)) {}

  Figure run() {
    places_.resize(scene_.labels.size());
    add_areas();
    add_strokes();
    add_dots();
    add_labels();
    for (const Figure::Key& key : scene_.keys) out_.keys.push_back(key);
    find_box();
    return std::move(out_);
  }

 private:
  const Scene& scene_;
  const SeenScene& seen_;
  const double scale_;
  Figure out_;
  std::vector<std::vector<Figure::Label::Place>> places_;  // by label

  std::vector<Point2> scaled(const std::vector<Point2>& points) const {
    std::vector<Point2> out;
    for (const Point2& p : points) out.push_back({p[0] / scale_, p[1] / scale_});
    return out;
  }

  static Rgb lit(const Rgb& color, int steps) {
    const double light = steps / kLights;
    return light <= 1 ? mix({0.10, 0.10, 0.16}, color, light) : color;
  }

  void add_areas() {
    for (const SeenScene::Area& area : seen_.areas) {
      Figure::Area painted;
      double through = 1;
      for (const Index f : area.facets) {
        const Scene::Surface& s = scene_.surfaces[scene_.facets[f].surface];
        const Rgb color = lit(s.color, scene_.facets[f].light);
        for (std::size_t k = 0; k < 3; ++k) painted.color[k] += through * s.opacity * color[k];
        through *= 1 - s.opacity;
      }
      painted.opacity = 1 - through;
      for (double& x : painted.color) x /= painted.opacity;
      for (const auto& loop : area.loops) painted.loops.push_back(scaled(loop));
      const Scene::Surface& front = scene_.surfaces[scene_.facets[area.facets.front()].surface];
      painted.missing = front.missing;
      painted.sheet = front.sheet;
      out_.areas.push_back(std::move(painted));
    }
    place_texts_in_areas();
  }

  /// A text stands in what is seen in front of one surface, facets and what shines through taken together.
  void place_texts_in_areas() {
    if (scene_.labels.empty()) return;
    std::map<Index, std::vector<std::size_t>> of_surface;
    for (std::size_t i = 0; i < seen_.areas.size(); ++i) {
      of_surface[scene_.facets[seen_.areas[i].facets.front()].surface].push_back(i);
    }
    for (const auto& [surface, areas] : of_surface) {
      if (scene_.surfaces[surface].labels.empty()) continue;
      std::vector<Figure::Label::Place> found;
      for (const std::size_t i : areas) found.push_back(place_with_room(out_.areas[i].loops));
      std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.room > b.room; });
      found.resize(std::min<std::size_t>(found.size(), 3));
      for (const Index label : scene_.surfaces[surface].labels) {
        places_[label].insert(places_[label].end(), found.begin(), found.end());
      }
    }
  }

  void add_strokes() {
    std::map<Index, std::pair<double, Figure::Label::Place>> longest;  // by line
    for (const SeenScene::Stroke& stroke : seen_.strokes) {
      Figure::Stroke painted;
      painted.points = scaled(stroke.points);
      painted.closed = stroke.closed;
      const bool ghost = stroke.line == SeenScene::kNone && scene_.surfaces[stroke.surface].ghost;
      painted.color = kInk;
      if (stroke.line != SeenScene::kNone) {
        const Scene::Line& line = scene_.lines[stroke.line];
        painted.line = line.look;
        painted.color = line.color;
        painted.missing = line.missing;
        find_middle(painted.points, longest[stroke.line]);
      }
      const bool plain = painted.line != Figure::Line::wire && painted.line != Figure::Line::ghost;
      painted.hidden = stroke.hidden;
      if (ghost) painted.line = Figure::Line::ghost;
      else if (stroke.outline && plain) painted.line = Figure::Line::outline;
      out_.strokes.push_back(std::move(painted));
    }
    for (const auto& [line, found] : longest) {
      for (const Index label : scene_.lines[line].labels) places_[label].push_back(found.second);
    }
  }

  /// The middle of a chain, if it is the longest of its line.
  static void find_middle(const std::vector<Point2>& points, std::pair<double, Figure::Label::Place>& best) {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      length += hypotenuse(points[i][0] - points[i - 1][0], points[i][1] - points[i - 1][1]);
    }
    if (length <= best.first) return;
    double left = length / 2;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto &a = points[i - 1], &b = points[i];
      const double step = hypotenuse(b[0] - a[0], b[1] - a[1]);
      if (left <= step) {
        const double t = step > 0 ? left / step : 0;
        best = {length, {{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])}, 0}};
        return;
      }
      left -= step;
    }
  }

  void add_dots() {
    for (const SeenScene::Dot& seen : seen_.dots) {
      const Scene::Dot& dot = scene_.dots[seen.dot];
      const Point2 at{seen.at[0] / scale_, seen.at[1] / scale_};
      out_.dots.push_back({at, dot.mark, dot.color, dot.missing, seen.hidden});
      for (const Index label : dot.labels) places_[label].push_back({at, 0});
    }
  }

  /// Names and regions first, since each has few places where it may stand.
  void add_labels() {
    for (Index i = 0; i < scene_.labels.size(); ++i) {
      auto& places = places_[i];
      if (places.empty()) continue;
      std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.room > b.room; });
      out_.labels.push_back({scene_.labels[i], std::move(places)});
    }
    std::stable_sort(out_.labels.begin(), out_.labels.end(),
                     [](const auto& a, const auto& b) { return a.places.front().room > b.places.front().room; });
  }

  void find_box() {
    out_.low = {INFINITY, INFINITY};
    out_.high = {-INFINITY, -INFINITY};
    const auto add = [&](const Point2& p) {
      for (std::size_t k = 0; k < 2; ++k) {
        out_.low[k] = std::min(out_.low[k], p[k]);
        out_.high[k] = std::max(out_.high[k], p[k]);
      }
    };
    for (const auto& area : out_.areas) {
      for (const auto& loop : area.loops) std::for_each(loop.begin(), loop.end(), add);
    }
    for (const auto& stroke : out_.strokes) std::for_each(stroke.points.begin(), stroke.points.end(), add);
    for (const auto& dot : out_.dots) add(dot.at);
    if (out_.low[0] > out_.high[0]) out_.low = out_.high = {0, 0};
  }
};

/// The box around the points of results.
Box extent_of(const std::vector<Result>& results) {
  Box out;
  for (const Result& result : results) {
    const Complex& complex = result.complex();
    const auto add = [&](VertexId v) {
      const auto p = complex.points.approx(v);
      out.extend(p, p);
    };
    for (const auto& vertex : result.cells().vertices) add(vertex.cell);
    for (const auto& edge : result.cells().edges) {
      for (const HalfEdge h : edge.chain) add(complex.origin(h));
    }
  }
  return out;
}

}  // namespace

DrawOptions::Camera camera_for(const std::vector<Result>& results) {
  const Box box = extent_of(results);
  const double x = box.hi[0] - box.lo[0], y = box.hi[1] - box.lo[1], z = box.hi[2] - box.lo[2];
  if (z == 0) return {0, 90};
  if (y == 0) return {0, 0};
  if (x == 0) return {90, 0};
  return {x >= y ? 30.0 : 60.0, 24};
}

Figure draw(const Result& result, const DrawOptions& options, const Result* removed, int threads) {
  const ResultView view = result.data().view();
  const FlatComplex flat = flatten(view);
  const Camera camera(options.camera.value_or(camera_for({result})));
  const bool moved = !options.cuts.empty() || options.apart != 0;
  const bool unbounded = std::any_of(flat.regions.begin(), flat.regions.end(),
                                     [](const auto& r) { return r.component != 0 && !r.bounded; });
  const std::string what = options.cuts.empty() ? "pulled apart" : "cut";
  if (moved && unbounded) {
    throw InputError("it is unbounded, and cannot be " + what + " in a picture; intersect it with a box");
  }
  require(!moved || removed == nullptr, "draw: ghosts of a model that is cut or pulled apart");
  PictureCells cells = picture_cells(result.complex(), flat);
  const Rational most("1" + std::string(250, '0'));
  for (const RationalPoint& p : cells.points) {
    const bool far = std::any_of(p.begin(), p.end(), [&](const Rational& x) { return abs(x) > most; });
    if (far) throw InputError("a picture has no coordinates beyond 1e250; make the model smaller with `scale`");
  }
  for (const DrawOptions::Cut& plane : options.cuts) cells = cut(cells, plane, camera.towards(), threads);
  if (cells.points.empty() && !flat.points.empty()) {
    throw InputError("the cut takes away all of it; turn the camera to the other side, or move the plane");
  }
  Scene scene = make_scene(view, flat, cells, options, camera);
  if (options.apart != 0) scene = without_crossings(scene, threads);
  if (removed != nullptr) add_ghosts(removed->complex(), flatten(removed->data().view()), camera, scene);
  return figure_of(scene, camera, threads);
}

Figure figure_of(Scene& scene, const Camera& camera, int threads) {
  set_light(scene);
  return Finisher(scene, see(scene, threads), camera.scale()).run();
}

}  // namespace cnrg
