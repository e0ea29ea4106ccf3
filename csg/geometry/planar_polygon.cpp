// Checks of polygons: plane first, then everything else in an exact projection onto two coordinates.
#include "csg/geometry/planar_polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/refine/box_pairs.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {
namespace {

using Loops = std::vector<std::vector<RationalPoint>>;
using Point2 = std::array<Rational, 2>;

struct PolygonEdge {
  std::size_t loop, from, to;
  const Point2 *a, *b;
  Box box;
};

double below(const Rational& x) { return std::nextafter(to_double(x), -std::numeric_limits<double>::infinity()); }
double above(const Rational& x) { return std::nextafter(to_double(x), std::numeric_limits<double>::infinity()); }

/// By a point, rounded outward.
void extend(Box& box, const Point2& p) {
  box.extend({below(p[0]), below(p[1]), 0}, {above(p[0]), above(p[1]), 0});
}

int turn(const Point2& a, const Point2& b, const Point2& c) {
  return sgn(Rational((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])));
}

/// True if c, a point of the line ab, is on the segment ab.
bool between(const Point2& a, const Point2& b, const Point2& c) {
  const int k = a[0] != b[0] ? 0 : 1;
  return a[k] < b[k] ? a[k] <= c[k] && c[k] <= b[k] : b[k] <= c[k] && c[k] <= a[k];
}

bool segments_meet(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const int abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) || (cda == 0 && between(c, d, a)) ||
         (cdb == 0 && between(c, d, b));
}

/// True if two edges overlap that share the end `shared`: they leave it in the same direction.
bool fold_back(const Point2& shared, const Point2& p, const Point2& q) {
  if (turn(shared, p, q) != 0) return false;
  const Rational along = (p[0] - shared[0]) * (q[0] - shared[0]) + (p[1] - shared[1]) * (q[1] - shared[1]);
  return along > 0;
}

/// A loop that is asked about many points. A point is inside if a ray to the right passes an odd number of edges;
/// a tree of boxes finds those that it may pass.
class LoopOfEdges {
 public:
  explicit LoopOfEdges(const std::vector<Point2>& loop) : loop_(loop), edges_(boxes_of(loop)) {}
  /// p is on none of the edges.
  bool holds(const Point2& p) const {
    Box from;
    extend(from, p);
    bool odd = false;
    edges_.query(
        [&](const Box& box) {
          return box.lo[1] <= from.hi[1] && box.hi[1] >= from.lo[1] && box.hi[0] >= from.lo[0];
        },
        [&](std::uint32_t i) {
          const Point2 &a = loop_[i], &b = loop_[(i + 1) % loop_.size()];
          if ((a[1] > p[1]) == (b[1] > p[1])) return;
          if ((turn(a, b, p) > 0) == (b[1] > a[1])) odd = !odd;
        });
    return odd;
  }

 private:
  static std::vector<Box> boxes_of(const std::vector<Point2>& loop) {
    std::vector<Box> boxes(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      extend(boxes[i], loop[i]), extend(boxes[i], loop[(i + 1) % loop.size()]);
    }
    return boxes;
  }
  const std::vector<Point2>& loop_;
  BoxTree edges_;
};

class Checker {
 public:
  Checker(const Loops& loops, const PolygonNames& names) : loops_(loops), names_(names) {}

  RationalPoint run() {
    check_points();
    check_plane();
    project();
    check_edges();
    check_holes();
    return area_vector(loops_[0]);
  }

 private:
  std::string loop_name(std::size_t loop) const {
    if (loops_.size() == 1) return names_.polygon;
    return (loop == 0 ? std::string("the outer loop") : "hole " + std::to_string(loop)) + " of " + names_.polygon;
  }
  std::string point_name(std::size_t loop, std::size_t i) const {
    if (names_.point) return names_.point(loop, i);
    return "point " + std::to_string(i + 1) + (loop > 0 ? " of hole " + std::to_string(loop) : "");
  }
  std::string edge_name(const PolygonEdge& e) const {
    return "edge " + std::to_string(e.from + 1) + (e.loop > 0 ? " of hole " + std::to_string(e.loop) : "") + " (" +
           point_name(e.loop, e.from) + " to " + point_name(e.loop, e.to) + ")";
  }

  void check_points() const {
    for (std::size_t l = 0; l < loops_.size(); ++l) {
      const auto& loop = loops_[l];
      if (loop.size() < 3) {
        throw InputError(loop_name(l) + " has " + std::to_string(loop.size()) +
                         (loop.size() == 1 ? " point" : " points") + ": give at least 3 distinct points");
      }
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::size_t next = (i + 1) % loop.size();
        if (loop[i] != loop[next]) continue;
        if (next == 0) {
          throw InputError(loop_name(l) + ": the last point, " + point_name(l, i) + ", repeats the first " +
                           describe(loop[i]) + ": leave it out, loops close by themselves");
        }
        throw InputError(loop_name(l) + ": " + point_name(l, i) + " and " + point_name(l, next) + " are both " +
                         describe(loop[i]) + ": leave one out");
      }
    }
  }

  void check_plane() {
    const auto& outer = loops_[0];
    for (std::size_t i = 2; i < outer.size() && is_zero(normal_); ++i) {
      normal_ = cross(outer[1] - outer[0], outer[i] - outer[0]);
    }
    if (is_zero(normal_)) {
      throw InputError("all points of " + loop_name(0) +
                       " lie on one line, its area is zero: move one off the line" + " or use a polyline");
    }
    const Rational offset = dot(normal_, outer[0]);
    for (std::size_t l = 0; l < loops_.size(); ++l) {
      for (std::size_t i = 0; i < loops_[l].size(); ++i) {
        if (dot(normal_, loops_[l][i]) == offset) continue;
        throw InputError(names_.polygon + " is not planar: " + point_name(l, i) + " " + describe(loops_[l][i]) +
                         " is off the plane of its first points (exactly, with no tolerance); all lie between" +
                         " two planes " + to_decimal(thickness(), 3) + " apart: " + remedy());
      }
    }
  }

  std::string remedy() const {
    // Two digits are less than 5 % off, and planes are found in doubles.
    const std::string fit =
        names_.has_fit ? "give `fit: " + to_decimal(thickness() * Rational(53, 50), 2) + "`, " : "";
    return fit + "correct it, with fractions where decimals are inexact, or give triangles";
  }

  /// How far two parallel planes are apart that hold all points between them, at the better one of two normals.
  Rational thickness() const {
    std::vector<RationalPoint> points;
    RationalPoint area{0, 0, 0};
    for (const auto& loop : loops_) {
      points.insert(points.end(), loop.begin(), loop.end());
      const RationalPoint own = area_vector(loop);
      area = dot(own, area) > 0 ? area - own : area + own;
    }
    if (is_zero(area)) area = normal_;
    return std::min(thickness(points, area), thickness(points, least_squares_normal(points, area)));
  }
  static Rational thickness(const std::vector<RationalPoint>& points, const RationalPoint& normal) {
    std::vector<Rational> heights;
    for (const RationalPoint& p : points) heights.push_back(dot(normal, p));
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    const Rational most = std::max({abs(normal[0]), abs(normal[1]), abs(normal[2])});
    const RationalPoint n = Rational(1 / most) * normal;
    return (*high - *low) / most / from_double(std::sqrt(to_double(dot(n, n))));
  }

  /// Drops a coordinate in which the normal is not zero: an exact projection, simple if the polygon is simple.
  void project() {
    std::size_t dropped = 0;
    while (normal_[dropped] == 0) ++dropped;
    const std::size_t u = (dropped + 1) % 3, v = (dropped + 2) % 3;
    flat_.resize(loops_.size());
    for (std::size_t l = 0; l < loops_.size(); ++l) {
      for (const RationalPoint& p : loops_[l]) flat_[l].push_back({p[u], p[v]});
    }
  }

  void check_edges() const {
    std::vector<PolygonEdge> edges;
    for (std::size_t l = 0; l < flat_.size(); ++l) {
      for (std::size_t i = 0; i < flat_[l].size(); ++i) {
        const std::size_t next = (i + 1) % flat_[l].size();
        PolygonEdge e{l, i, next, &flat_[l][i], &flat_[l][next], {}};
        extend(e.box, *e.a), extend(e.box, *e.b);
        edges.push_back(e);
      }
    }
    // Of all pairs whose boxes meet the first one at fault in the order of the polygon is reported.
    std::vector<Box> boxes;
    for (const PolygonEdge& e : edges) boxes.push_back(e.box);
    const BoxPairs pairs(boxes);
    std::pair<std::size_t, std::size_t> fault{edges.size(), edges.size()};
    for (std::size_t part = 0; part < pairs.part_count(); ++part) {
      pairs.find(part, [&](std::uint32_t x, std::uint32_t y) {
        const std::pair<std::size_t, std::size_t> pair = std::minmax(pairs.item(x), pairs.item(y));
        if (pair < fault && at_fault(edges[pair.first], edges[pair.second])) fault = pair;
      });
    }
    if (fault.first == edges.size()) return;
    const PolygonEdge &e = edges[fault.first], &f = edges[fault.second];
    throw InputError(
        (e.loop == f.loop ? loop_name(e.loop) + " is not simple: " : "loops of " + names_.polygon + " meet: ") +
        edge_name(e) + " crosses or touches " + edge_name(f) +
        ": reorder or move the points, or split it into simple polygons");
  }

  bool at_fault(const PolygonEdge& e, const PolygonEdge& f) const {
    if (e.loop == f.loop) {
      if (e.to == f.from) return fold_back(*e.b, *e.a, *f.b) || (f.to == e.from && fold_back(*e.a, *e.b, *f.a));
      if (f.to == e.from) return fold_back(*e.a, *e.b, *f.a);
    }
    return segments_meet(*e.a, *e.b, *f.a, *f.b);
  }

  void check_holes() const {
    if (flat_.size() == 1) return;
    const LoopOfEdges outer(flat_[0]);
    std::vector<LoopOfEdges> holes;
    std::vector<Box> boxes;
    for (std::size_t l = 1; l < flat_.size(); ++l) {
      holes.emplace_back(flat_[l]);
      Box& box = boxes.emplace_back();
      for (const Point2& p : flat_[l]) extend(box, p);
    }
    const BoxTree tree(boxes);
    for (std::size_t l = 1; l < flat_.size(); ++l) {
      const Point2& p = flat_[l][0];
      if (!outer.holds(p)) {
        throw InputError("hole " + std::to_string(l) + " of " + names_.polygon +
                         " is outside of the outer loop (" + point_name(l, 0) + " " + describe(loops_[l][0]) +
                         "): move it inside or leave it out");
      }
      Box around;
      extend(around, p);
      std::size_t within = flat_.size();
      tree.query([&](const Box& box) { return box.meets(around); },
                 [&](std::uint32_t i) {
                   const std::size_t m = i + 1;
                   if (m != l && m < within && holes[i].holds(p)) within = m;
                 });
      if (within == flat_.size()) continue;
      throw InputError("hole " + std::to_string(l) + " of " + names_.polygon + " is inside hole " +
                       std::to_string(within) +
                       ": holes must be disjoint; give an island as a polygon of its own");
    }
  }

  const Loops& loops_;
  const PolygonNames& names_;
  RationalPoint normal_{0, 0, 0};
  std::vector<std::vector<Point2>> flat_;
};

}  // namespace

// Heights h over coordinates u, v in the plane: of h = a u + b v the two normal equations, solved by Cramer's
// rule.

RationalPoint least_squares_normal(std::span<const RationalPoint> points, const RationalPoint& start) {
  RationalPoint mean{0, 0, 0};
  for (const RationalPoint& p : points) mean = mean + p;
  mean = Rational(1, static_cast<unsigned>(points.size())) * mean;
  const RationalPoint axis = start[0] == 0 ? RationalPoint{1, 0, 0} : RationalPoint{0, 1, 0};
  const RationalPoint along_u = cross(start, axis), along_v = cross(start, along_u);
  Rational uu = 0, uv = 0, vv = 0, hu = 0, hv = 0;
  for (const RationalPoint& p : points) {
    const RationalPoint from = p - mean;
    const Rational u = dot(along_u, from), v = dot(along_v, from), h = dot(start, from);
    uu += u * u, uv += u * v, vv += v * v, hu += h * u, hv += h * v;
  }
  const Rational determinant = uu * vv - uv * uv;
  if (determinant == 0) return start;
  return start - Rational((hu * vv - hv * uv) / determinant) * along_u -
         Rational((hv * uu - hu * uv) / determinant) * along_v;
}

RationalPoint check_polygon(const Loops& loops, const PolygonNames& names) {
  require(!loops.empty(), "check_polygon: no loop");
  return Checker(loops, names).run();
}

RationalPoint area_vector(const std::vector<RationalPoint>& loop) {
  RationalPoint sum{0, 0, 0};
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) sum = sum + cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
  return sum;
}

bool are_in_a_plane(std::span<const RationalPoint> points) {
  if (points.size() < 4) return true;
  const auto off_line =
      std::ranges::find_if(points, [&](const auto& p) { return !collinear(points[0], points[1], p); });
  return off_line == points.end() || std::ranges::all_of(points, [&](const RationalPoint& p) {
           return volume6(points[0], points[1], *off_line, p) == 0;
         });
}

}  // namespace cnrg
