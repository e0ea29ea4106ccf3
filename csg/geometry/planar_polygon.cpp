// Checks of polygons: plane first, then everything else in an exact projection onto two coordinates.
#include "csg/geometry/planar_polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "csg/geometry/exact_vectors.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

using Loops = std::vector<std::vector<RationalPoint>>;
using Point2 = std::array<Rational, 2>;

struct PolygonEdge {
  std::size_t loop, from, to;
  const Point2 *a, *b;
  double low[2], high[2];  // rounded outward
};

double below(const Rational& x) { return std::nextafter(to_double(x), -std::numeric_limits<double>::infinity()); }
double above(const Rational& x) { return std::nextafter(to_double(x), std::numeric_limits<double>::infinity()); }

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

/// True if p, which is on none of the loop's edges, is inside of it.
bool inside(const std::vector<Point2>& loop, const Point2& p) {
  bool odd = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    if ((a[1] > p[1]) == (b[1] > p[1])) continue;
    if ((turn(a, b, p) > 0) == (b[1] > a[1])) odd = !odd;
  }
  return odd;
}

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
                         " is off the plane of its first points (exactly, with no tolerance): correct it, with" +
                         " fractions where decimals are inexact, or give triangles");
      }
    }
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
        PolygonEdge e{l, i, next, &flat_[l][i], &flat_[l][next], {}, {}};
        for (int k = 0; k < 2; ++k) {
          e.low[k] = below(std::min((*e.a)[k], (*e.b)[k]));
          e.high[k] = above(std::max((*e.a)[k], (*e.b)[k]));
        }
        edges.push_back(e);
      }
    }
    // Sweep along the first coordinate; the first pair at fault in the order of the polygon is reported.
    std::vector<std::size_t> order(edges.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](auto a, auto b) { return edges[a].low[0] < edges[b].low[0]; });
    std::vector<std::size_t> open;
    std::pair<std::size_t, std::size_t> fault{edges.size(), edges.size()};
    for (std::size_t i : order) {
      const PolygonEdge& e = edges[i];
      std::erase_if(open, [&](std::size_t j) { return edges[j].high[0] < e.low[0]; });
      for (std::size_t j : open) {
        const PolygonEdge& f = edges[j];
        if (f.high[1] < e.low[1] || f.low[1] > e.high[1]) continue;
        if (at_fault(e, f)) fault = std::min(fault, {std::min(i, j), std::max(i, j)});
      }
      open.push_back(i);
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
    for (std::size_t l = 1; l < flat_.size(); ++l) {
      if (!inside(flat_[0], flat_[l][0])) {
        throw InputError("hole " + std::to_string(l) + " of " + names_.polygon +
                         " is outside of the outer loop (" + point_name(l, 0) + " " + describe(loops_[l][0]) +
                         "): move it inside or leave it out");
      }
      for (std::size_t m = 1; m < flat_.size(); ++m) {
        if (m != l && inside(flat_[m], flat_[l][0])) {
          throw InputError("hole " + std::to_string(l) + " of " + names_.polygon + " is inside hole " +
                           std::to_string(m) + ": holes must be disjoint; give an island as a polygon of its own");
        }
      }
    }
  }

  const Loops& loops_;
  const PolygonNames& names_;
  RationalPoint normal_{0, 0, 0};
  std::vector<std::vector<Point2>> flat_;
};

}  // namespace

RationalPoint check_polygon(const Loops& loops, const PolygonNames& names) {
  require(!loops.empty(), "check_polygon: no loop");
  return Checker(loops, names).run();
}

RationalPoint area_vector(const std::vector<RationalPoint>& loop) {
  RationalPoint sum{0, 0, 0};
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) sum = sum + cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
  return sum;
}

}  // namespace cnrg
