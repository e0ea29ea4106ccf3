// Points between the circles, the convex hull of all points, and the edges of the hull.
#include "csg/carriers/ball_hull.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>

#include "csg/carriers/point_lattice.h"
#include "csg/geometry/circle.h"
#include "csg/leaves/geometry_leaf.h"
#include "kernel/base/hypotenuse.h"
#include "kernel/exact/convex_hull.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/trigonometry.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;
using Point3 = std::array<double, 3>;

/// Balls that no point between the circles may lie in: over each chord as its diameter, a little larger, and
/// around each single point.
class Keepout {
 public:
  Keepout(const std::vector<SphereCircle>& circles, const std::vector<RationalPoint>& points, double least)
      : tree_(boxes(circles, points, least)) {}
  bool holds(const Point3& p) const {
    bool found = false;
    tree_.query([&](const Box& box) { return in(box, p); },
                [&](Index i) {
                  double square = 0;
                  for (std::size_t k = 0; k < 3; ++k) square += (p[k] - middles_[i][k]) * (p[k] - middles_[i][k]);
                  found = found || square < radii_[i] * radii_[i];
                });
    return found;
  }

 private:
  static bool in(const Box& box, const Point3& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (p[k] < box.lo[k] || p[k] > box.hi[k]) return false;
    }
    return true;
  }
  std::vector<Box> boxes(const std::vector<SphereCircle>& circles, const std::vector<RationalPoint>& points,
                         double least) {
    std::vector<Box> result;
    const auto add = [&](const Point3& middle, double radius) {
      middles_.push_back(middle);
      radii_.push_back(radius);
      Box box;
      for (std::size_t k = 0; k < 3; ++k) {
        box.lo[k] = middle[k] - radius;
        box.hi[k] = middle[k] + radius;
      }
      result.push_back(box);
    };
    for (const SphereCircle& circle : circles) {
      for (std::size_t i = 0; i < circle.size(); ++i) {
        const Point3 a = to_doubles(circle[i]), b = to_doubles(circle[(i + 1) % circle.size()]);
        Point3 middle;
        double square = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          middle[k] = (a[k] + b[k]) / 2;
          square += (a[k] - b[k]) * (a[k] - b[k]);
        }
        add(middle, std::max(0.55 * std::sqrt(square), least));
      }
    }
    for (const RationalPoint& p : points) add(to_doubles(p), least);
    return result;
  }

  std::vector<Point3> middles_;
  std::vector<double> radii_;
  BoxTree tree_;
};

/// The points of the grid about z.
std::vector<RationalPoint> grid(const Ball& ball, const CurveSteps& around, const CurveSteps& up) {
  std::vector<RationalPoint> result;
  std::vector<Rational> meridians{0}, rows{0};
  for (const Rational& turn : around.inside()) meridians.push_back(turn);
  for (const Rational& way : up.inside()) rows.push_back(way);
  rows.push_back(1);
  for (const Rational& way : rows) {
    const Rational latitude = 180 * way - 90;
    const Rational out = ball.radius * from_double(cosine_degrees(latitude));
    RationalPoint p = ball.center;
    p[2] = rounded_for(p[2] + ball.radius * from_double(sine_degrees(latitude)), ball.radius);
    for (std::size_t i = 0; i < (out == 0 ? 1 : meridians.size()); ++i) {
      const Rational longitude = 360 * meridians[i];
      p[0] = rounded_for(ball.center[0] + out * from_double(cosine_degrees(longitude)), ball.radius);
      p[1] = rounded_for(ball.center[1] + out * from_double(sine_degrees(longitude)), ball.radius);
      result.push_back(p);
    }
  }
  return result;
}

}  // namespace

BallHull hull_of(const Ball& ball, const std::vector<SphereCircle>& circles,
                 const std::vector<RationalPoint>& points, const std::vector<RationalPoint>& others,
                 const CurveSteps& around, const CurveSteps& up) {
  std::set<RationalPoint> all(points.begin(), points.end());
  for (const SphereCircle& circle : circles) all.insert(circle.begin(), circle.end());
  std::vector<RationalPoint> single = points;
  if (!others.empty()) {
    PointLattice known(ball.center, ball.radius);
    for (const RationalPoint& p : all) known.add(p);
    for (const RationalPoint& p : others) {
      if (!known.add(p)) continue;
      all.insert(p);
      single.push_back(p);
    }
  }
  const double step = to_double(ball.radius) * std::numbers::pi / up.even;
  const Keepout keepout(circles, single, step / 4);
  for (const RationalPoint& p : grid(ball, around, up)) {
    if (!keepout.holds(to_doubles(p))) all.insert(p);
  }
  BallHull hull;
  hull.points.assign(all.begin(), all.end());
  std::set<std::array<Index, 2>> edges;
  for (const std::vector<Index>& corners : convex_hull(hull.points)) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      hull.triangles.push_back({corners[0], corners[i], corners[i + 1]});
    for (std::size_t i = 0; i < corners.size(); ++i) edges.insert({corners[i], corners[(i + 1) % corners.size()]});
  }
  std::sort(hull.triangles.begin(), hull.triangles.end());
  const auto index = [&](const RationalPoint& p) {
    return static_cast<Index>(std::lower_bound(hull.points.begin(), hull.points.end(), p) - hull.points.begin());
  };
  for (std::size_t c = 0; c < circles.size(); ++c) {
    for (std::size_t i = 0; i < circles[c].size(); ++i) {
      if (!edges.contains({index(circles[c][i]), index(circles[c][(i + 1) % circles[c].size()])}))
        hull.missed.push_back({c, i});
    }
  }
  return hull;
}

std::unique_ptr<PreparedLeaf> tessellate(const Ball& ball, const BallHull& hull, LeafParameters* record) {
  LeafBuilder builder(Fill::winding, record);
  builder.name_patch(0, "sphere");
  std::vector<PointId> ids;
  std::vector<std::array<Rational, 2>> at;  // of each point; u is anything at a pole
  std::vector<bool> pole;
  for (const RationalPoint& p : hull.points) {
    ids.push_back(builder.point(p));
    const RationalPoint off = p - ball.center;
    const double up = rounded::arc_tangent(to_double(off[2]), hypotenuse(to_double(off[0]), to_double(off[1])));
    pole.push_back(off[0] == 0 && off[1] == 0);
    Rational u = from_double(rounded::arc_tangent(to_double(off[1]), to_double(off[0])) / (2 * std::numbers::pi));
    if (u < 0) u += 1;
    at.push_back({u, from_double(up / std::numbers::pi + 0.5)});
  }
  for (const auto& t : hull.triangles) {
    std::array<std::array<Rational, 2>, 3> uv;
    Rational most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      uv[k] = at[t[k]];
      if (!pole[t[k]] && uv[k][0] > most) most = uv[k][0];
    }
    // Across the meridian where u begins anew it goes on above 1.
    for (std::size_t k = 0; k < 3; ++k) {
      if (!pole[t[k]] && 2 * (most - uv[k][0]) > 1) uv[k][0] += 1;
    }
    const auto first = std::find_if(t.begin(), t.end(), [&](Index p) { return pole[p]; });
    const std::size_t a = first == t.end() ? 0 : static_cast<std::size_t>(first - t.begin());
    const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
    if (first == t.end()) {
      builder.facet(ids[t[a]], ids[t[b]], ids[t[c]], 0,
                    {{{&uv[a][0], &uv[a][1]}, {&uv[b][0], &uv[b][1]}, {&uv[c][0], &uv[c][1]}}});
    } else {
      builder.facet(
          ids[t[a]], ids[t[a]], ids[t[b]], ids[t[c]], 0,
          {{{&uv[c][0], &uv[a][1]}, {&uv[b][0], &uv[a][1]}, {&uv[b][0], &uv[b][1]}, {&uv[c][0], &uv[c][1]}}});
    }
  }
  return builder.finish();
}

}  // namespace cnrg
