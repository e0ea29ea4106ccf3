// What is seen, held against rays: at random places every facet is asked, in rational arithmetic and without a
// map.
#include "csg/picture/visibility.h"

#include <cmath>
#include <random>
#include <sstream>

#include "csg/evaluate/evaluate.h"
#include "csg/picture/make_scene.h"
#include "csg/result/result_data.h"
#include "csg/tree/tree.h"
#include "tests/catch.h"

using namespace cnrg;

namespace {

using Index = Scene::Index;

Tree tree_of(const std::string& text) { return parse_tree(text, "test.yaml"); }

/// A union of boxes, tetrahedra, polygons, polylines and points with corners on a small grid.
std::string random_tree(std::mt19937& random) {
  const auto number = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  const auto point = [&] {
    return "[" + std::to_string(number(0, 6)) + ", " + std::to_string(number(0, 6)) + ", " +
           std::to_string(number(0, 6)) + "]";
  };
  std::ostringstream text;
  text << "cnrg: 1\nnodes:\n";
  std::string names;
  const int n = number(2, 7);
  for (int i = 0; i < n; ++i) {
    const std::string name(1, static_cast<char>('a' + i));
    names += (i == 0 ? "" : ", ") + name;
    text << "  " << name << ": {";
    const int x = number(0, 4), y = number(0, 4), z = number(0, 4);
    switch (number(0, 4)) {
      case 0:
      case 1:
        text << "box: {min: [" << x << ", " << y << ", " << z << "], max: [" << x + number(1, 3) << ", "
             << y + number(1, 3) << ", " << z + number(1, 3) << "]}";
        break;
      case 2:
        text << "polygon: [[" << x << ", " << y << ", " << z << "], [" << x + number(1, 3) << ", " << y << ", "
             << z << "], [" << x + number(0, 3) << ", " << y + number(1, 3) << ", " << z + number(0, 2) << "]]";
        break;
      case 3:
        text << "polyline: [[" << x << ", " << y << ", " << z << "], [" << x + 1 << ", " << y + number(-2, 2)
             << ", " << z << "], [7, " << number(0, 6) << ", " << number(0, 6) << "]]";
        break;
      default: text << "points: [" << point() << ", [9, 9, 9]]"; break;
    }
    text << "}\n";
  }
  text << "  u: {" << (number(0, 3) == 0 ? "difference" : "union") << ": [" << names << "]}\nresult: u\n";
  return text.str();
}

struct Shot {
  Scene scene;
  SeenScene seen;
};

Shot shoot(const std::string& text, const DrawOptions& options) {
  const Tree tree = tree_of(text);
  const Result result = evaluate(tree).result();
  const ResultView view = result.data().view();
  const FlatComplex flat = flatten(view);
  const Camera camera(*options.camera);
  PictureCells cells = picture_cells(result.complex(), flat);
  for (const DrawOptions::Cut& plane : options.cuts) cells = cut(cells, plane, camera.towards(), 1);
  Shot out;
  out.scene = make_scene(view, flat, cells, options, camera);
  if (options.apart != 0) out.scene = without_crossings(out.scene, 1);
  out.seen = see(out.scene, 1);
  return out;
}

/// Twice the area of a loop as it is seen.
Rational seen_area(const Scene& scene, const Scene::Loop& loop) {
  Rational sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const RationalPoint &p = scene.points[loop[i]], &q = scene.points[loop[(i + 1) % loop.size()]];
    sum += p[0] * q[1] - p[1] * q[0];
  }
  return sum;
}

/// 1 inside, 0 on the border, -1 outside.
int where(const Scene& scene, const Scene::Facet& facet, const Rational& x, const Rational& y) {
  int inside = -1;
  for (const Scene::Loop& loop : facet.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const RationalPoint &p = scene.points[loop[i]], &q = scene.points[loop[(i + 1) % loop.size()]];
      const Rational turn = (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
      if (turn == 0 && (x - p[0]) * (x - q[0]) + (y - p[1]) * (y - q[1]) <= 0) return 0;
      if ((p[1] <= y) != (q[1] <= y) && (turn > 0) == (q[1] > p[1])) inside = -inside;
    }
  }
  return inside;
}

/// z of the facet's plane, from the first three corners that are not in line.
Rational depth(const Scene& scene, const Scene::Facet& facet, const Rational& x, const Rational& y) {
  const Scene::Loop& loop = facet.loops.front();
  const RationalPoint &a = scene.points[loop[0]], &b = scene.points[loop[1]];
  for (std::size_t i = 2; i < loop.size(); ++i) {
    const RationalPoint& c = scene.points[loop[i]];
    const Rational det = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (det == 0) continue;
    const Rational s = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / det;
    const Rational t = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / det;
    return a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2]);
  }
  FAIL("a facet without area");
  return 0;
}

bool inside(const std::vector<std::vector<Point2>>& loops, double x, double y) {
  bool in = false;
  for (const auto& loop : loops) {
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
      const auto &a = loop[j], &b = loop[i];
      if ((a[1] <= y) != (b[1] <= y) && x < a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1])) in = !in;
    }
  }
  return in;
}

double distance(const std::vector<Point2>& chain, bool closed, double x, double y) {
  double nearest = INFINITY;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < chain.size(); ++i) {
    const Point2 &a = chain[i], &b = chain[(i + 1) % chain.size()];
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    const double t = std::clamp(((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(a[0] + t * dx - x, a[1] + t * dy - y));
  }
  return nearest;
}

struct Hit {
  Rational z;
  Index facet = 0;
};
/// What a ray meets, the nearest first; nothing where it meets a border, or two at one depth.
std::optional<std::vector<Hit>> hits(const Scene& scene, const Rational& x, const Rational& y) {
  std::vector<Hit> out;
  for (Index f = 0; f < scene.facets.size(); ++f) {
    if (seen_area(scene, scene.facets[f].loops.front()) == 0) continue;
    const int in = where(scene, scene.facets[f], x, y);
    if (in == 0) return std::nullopt;
    if (in > 0) out.push_back({depth(scene, scene.facets[f], x, y), f});
  }
  std::sort(out.begin(), out.end(), [](const Hit& a, const Hit& b) { return a.z > b.z; });
  for (std::size_t i = 1; i < out.size(); ++i) {
    if (out[i].z == out[i - 1].z) return std::nullopt;
  }
  return out;
}

struct Tally {
  int areas = 0, empty = 0, seen = 0, gone = 0, hidden = 0, dots = 0;
};

void check_areas(const Shot& shot, std::mt19937& random, Tally& tally) {
  const Scene& scene = shot.scene;
  if (scene.points.empty()) return;
  std::array<Rational, 2> low{scene.points[0][0], scene.points[0][1]}, high = low;
  for (const RationalPoint& p : scene.points) {
    for (std::size_t k = 0; k < 2; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
  }
  std::uniform_int_distribution<int> share(1, 9972);
  for (int sample = 0; sample < 25; ++sample) {
    const Rational x = low[0] + (high[0] - low[0]) * Rational(share(random), 9973);
    const Rational y = low[1] + (high[1] - low[1]) * Rational(share(random), 9973);
    const std::optional<std::vector<Hit>> ray = hits(scene, x, y);
    if (!ray) continue;
    std::vector<Index> wanted;
    for (const Hit& hit : *ray) {
      const Scene::Surface& s = scene.surfaces[scene.facets[hit.facet].surface];
      const bool front = seen_area(scene, scene.facets[hit.facet].loops.front()) > 0;
      if (!s.two_sided && !front) {
        // The back of an opaque skin is never the first that a ray meets.
        if (s.opacity >= 1 && wanted.empty()) FAIL("the back of a skin is in sight");
        continue;
      }
      wanted.push_back(scene.facets[hit.facet].surface);
      if (s.opacity >= 1) break;
    }
    std::vector<std::vector<Index>> found;
    for (const SeenScene::Area& area : shot.seen.areas) {
      if (!inside(area.loops, to_double(x), to_double(y))) continue;
      std::vector<Index>& surfaces = found.emplace_back();
      for (const Index f : area.facets) surfaces.push_back(scene.facets[f].surface);
    }
    if (wanted.empty()) {
      CHECK(found.empty());
      ++tally.empty;
    } else {
      REQUIRE(found.size() == 1);
      CHECK(found[0] == wanted);
      ++tally.areas;
    }
  }
}

void check_lines(const Shot& shot, std::mt19937& random, double size, Tally& tally) {
  const Scene& scene = shot.scene;
  std::uniform_int_distribution<int> share(1, 9972);
  for (std::size_t i = 0; i < scene.segments.size(); ++i) {
    const Scene::Segment& segment = scene.segments[i];
    const RationalPoint &a = scene.points[segment.ends[0]], &b = scene.points[segment.ends[1]];
    if (a[0] == b[0] && a[1] == b[1]) continue;
    const Rational t(share(random), 9973);
    const Rational x = a[0] + t * (b[0] - a[0]), y = a[1] + t * (b[1] - a[1]), z = a[2] + t * (b[2] - a[2]);
    // Other lines that are seen through this place belong to another question.
    bool alone = true;
    for (std::size_t j = 0; j < scene.segments.size() && alone; ++j) {
      const RationalPoint &p = scene.points[scene.segments[j].ends[0]],
                          &q = scene.points[scene.segments[j].ends[1]];
      alone = j == i || (q[0] - p[0]) * (y - p[1]) != (q[1] - p[1]) * (x - p[0]);
    }
    bool in_front = false, opaque = false;
    for (Index f = 0; f < scene.facets.size() && alone; ++f) {
      const Scene::Facet& facet = scene.facets[f];
      const Rational area = seen_area(scene, facet.loops.front());
      const Scene::Surface& s = scene.surfaces[facet.surface];
      if (area == 0 || (area < 0 && !s.two_sided)) continue;
      const int in = where(scene, facet, x, y);
      if (in < 0) continue;
      const Rational d = depth(scene, facet, x, y);
      if (in == 0 && d != z) alone = false;  // seen through a border
      if (in == 0 || d <= z) continue;
      in_front = true;
      opaque = opaque || s.opacity >= 1;
    }
    if (!alone) continue;
    bool seen = false, hidden = false;
    for (const SeenScene::Stroke& stroke : shot.seen.strokes) {
      if (stroke.line != segment.line) continue;
      if (distance(stroke.points, stroke.closed, to_double(x), to_double(y)) > 1e-9 * size) continue;
      (stroke.hidden ? hidden : seen) = true;
    }
    CHECK(seen == !in_front);
    CHECK(hidden == (in_front && !opaque));
    ++(seen ? tally.seen : opaque ? tally.gone : tally.hidden);
  }
}

void check_dots(const Shot& shot, Tally& tally) {
  const Scene& scene = shot.scene;
  for (Index i = 0; i < scene.dots.size(); ++i) {
    const RationalPoint& p = scene.points[scene.dots[i].point];
    bool in_front = false, opaque = false, plain = true;
    for (const Scene::Facet& facet : scene.facets) {
      const Rational area = seen_area(scene, facet.loops.front());
      const Scene::Surface& s = scene.surfaces[facet.surface];
      if (area == 0 || (area < 0 && !s.two_sided)) continue;
      const int in = where(scene, facet, p[0], p[1]);
      if (in < 0) continue;
      const Rational d = depth(scene, facet, p[0], p[1]);
      if (in == 0 && d != p[2]) plain = false;
      if (in == 0 || d <= p[2]) continue;
      in_front = true;
      opaque = opaque || s.opacity >= 1;
    }
    if (!plain) continue;
    const auto found = std::find_if(shot.seen.dots.begin(), shot.seen.dots.end(),
                                    [&](const SeenScene::Dot& dot) { return dot.dot == i; });
    CHECK((found != shot.seen.dots.end()) == !opaque);
    if (found != shot.seen.dots.end()) CHECK(found->hidden == in_front);
    ++tally.dots;
  }
}

/// Scenes of these seeds, from all sides, seen through, pulled apart and cut.
Tally check_seeds(unsigned first, unsigned last) {
  Tally tally;
  for (unsigned seed = first; seed <= last; ++seed) {
    std::mt19937 random(seed);
    const std::string text = random_tree(random);
    DrawOptions options;
    options.camera =
        DrawOptions::Camera{static_cast<double>(random() % 360), static_cast<double>(random() % 160) - 80};
    if (seed % 7 == 0) options.camera = DrawOptions::Camera{90.0 * (seed % 4), 0};
    if (seed % 3 == 1) options.opacity = 0.5;
    if (seed % 4 == 1) options.apart = 0.4;
    if (seed % 5 == 1) options.cuts = {{{Rational(1), Rational(seed % 2), Rational(0)}, Rational(3)}};
    INFO("seed " << seed << "\n" << text);
    const Shot shot = shoot(text, options);
    const double size = 10 * to_double(Camera(*options.camera).scale());
    check_areas(shot, random, tally);
    check_lines(shot, random, size, tally);
    check_dots(shot, tally);
  }
  return tally;
}

}  // namespace

TEST_CASE("what is seen of random models is what rays meet", "[picture][random]") {
  const Tally tally = check_seeds(1, 200);
  // The cases are not empty ones.
  CHECK(tally.areas > 1000);
  CHECK(tally.empty > 500);
  CHECK(tally.seen > 1000);
  CHECK(tally.gone > 200);
  CHECK(tally.hidden > 200);
  CHECK(tally.dots > 50);
}

TEST_CASE("what is seen of thousands of random models is what rays meet", "[.picture-long]") {
  check_seeds(1000, 11000);
}
