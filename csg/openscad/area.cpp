// Booleans of areas by their split edges, without a sweep: outlines of models have hundreds of edges.
#include "csg/openscad/area.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/delaunay.h"
#include "kernel/exact/points.h"
#include "kernel/exact/triangulate.h"

namespace cnrg::openscad {
namespace {

using Exact2 = std::array<Rational, 2>;

constexpr double kGrid = 65536;
constexpr std::size_t kMostEdges = 20'000;  // each piece of them asks all

Exact2 exact(const Point2& p) { return {from_double(p[0]), from_double(p[1])}; }

/// Twice the area of the triangle a b c.
Rational turn(const Exact2& a, const Exact2& b, const Exact2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

struct Edge {
  Point2 ends[2];
  Exact2 a, b;
  std::size_t operand;
  std::vector<Exact2> splits{};

  double least(int axis) const { return std::min(ends[0][axis], ends[1][axis]); }
  double most(int axis) const { return std::max(ends[0][axis], ends[1][axis]); }
  bool may_meet(const Edge& other) const {
    return least(0) <= other.most(0) && other.least(0) <= most(0) && least(1) <= other.most(1) &&
           other.least(1) <= most(1);
  }
};

std::vector<Edge> edges_of(const std::vector<Area>& operands) {
  std::vector<Edge> out;
  const auto on_grid = [](const Point2& p) {
    return Point2{std::trunc(p[0] * kGrid) / kGrid, std::trunc(p[1] * kGrid) / kGrid};
  };
  for (std::size_t i = 0; i < operands.size(); ++i) {
    for (const Loop& loop : operands[i].loops) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Point2 p = on_grid(loop[k]), q = on_grid(loop[(k + 1) % loop.size()]);
        if (p != q) out.push_back({{p, q}, exact(p), exact(q), i});
      }
    }
  }
  return out;
}

/// Notes where two edges meet: in a point, or in the ends of what they share.
void split(Edge& e, Edge& f) {
  const Rational c = turn(e.a, e.b, f.a), d = turn(e.a, e.b, f.b);
  const Rational g = turn(f.a, f.b, e.a), h = turn(f.a, f.b, e.b);
  if (sgn(c) * sgn(d) < 0 && sgn(g) * sgn(h) < 0) {
    const Rational t = g / (g - h);
    const Exact2 p{e.a[0] + t * (e.b[0] - e.a[0]), e.a[1] + t * (e.b[1] - e.a[1])};
    e.splits.push_back(p);
    f.splits.push_back(p);
    return;
  }
  const auto add = [](Edge& to, const Exact2& p, const Rational& off) {
    if (off == 0 && std::min(to.a, to.b) < p && p < std::max(to.a, to.b)) to.splits.push_back(p);
  };
  add(e, f.a, c);
  add(e, f.b, d);
  add(f, e.a, g);
  add(f, e.b, h);
}

using Piece = std::pair<Exact2, Exact2>;  // the lesser end first

std::vector<Piece> split_all(std::vector<Edge>& edges) {
  std::vector<std::size_t> order(edges.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](auto i, auto j) { return edges[i].least(0) < edges[j].least(0); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    Edge& e = edges[order[i]];
    for (std::size_t j = i + 1; j < order.size() && edges[order[j]].least(0) <= e.most(0); ++j) {
      if (e.may_meet(edges[order[j]])) split(e, edges[order[j]]);
    }
  }
  std::vector<Piece> out;
  for (Edge& e : edges) {
    std::vector<Exact2> points = std::move(e.splits);
    points.push_back(e.a);
    points.push_back(e.b);
    sort_unique(points);
    for (std::size_t k = 0; k + 1 < points.size(); ++k) out.emplace_back(points[k], points[k + 1]);
  }
  sort_unique(out);
  return out;
}

/// Which operands are on the left and on the right of a piece, from the lesser end on: a ray from its middle,
/// upwards (of a vertical piece to the left), crosses an odd number of edges, and of those that it starts on all
/// or none.
std::array<std::vector<bool>, 2> sides(const Piece& piece, const std::vector<Edge>& edges, std::size_t operands) {
  const bool vertical = piece.first[0] == piece.second[0];
  const std::size_t u = vertical ? 1 : 0;
  const Exact2 middle{(piece.first[0] + piece.second[0]) / 2, (piece.first[1] + piece.second[1]) / 2};
  const double near = to_double(middle[u]);
  std::array<std::vector<bool>, 2> in{std::vector<bool>(operands), std::vector<bool>(operands)};
  for (const Edge& e : edges) {
    if (e.most(int(u)) < near || e.least(int(u)) > near) continue;
    const Exact2 &low = e.a[u] < e.b[u] ? e.a : e.b, &high = e.a[u] < e.b[u] ? e.b : e.a;
    if (!(low[u] <= middle[u] && middle[u] < high[u])) continue;
    const int side = sgn(turn(low, high, middle));  // below 0: the ray crosses the edge
    if (side < 0) in[0][e.operand] = !in[0][e.operand];
    if (side <= 0) in[1][e.operand] = !in[1][e.operand];
  }
  return in;
}

Point2 rounded(const Exact2& p) {
  return {std::round(to_double(p[0]) * kGrid) / kGrid, std::round(to_double(p[1]) * kGrid) / kGrid};
}

double angle(const Point2& from, const Point2& to) { return std::atan2(to[1] - from[1], to[0] - from[0]); }

/// Takes corners away that are on a line with their neighbours.
Loop without_straight(const Loop& loop) {
  Loop out;
  for (const Point2& p : loop) {
    out.push_back(p);
    while (out.size() > 2 && turn(exact(out[out.size() - 3]), exact(out[out.size() - 2]), exact(out.back())) == 0)
      out.erase(out.end() - 2);
  }
  const auto straight = [&](std::size_t i) {
    const std::size_t n = out.size();
    return turn(exact(out[(i + n - 1) % n]), exact(out[i]), exact(out[(i + 1) % n])) == 0;
  };
  while (out.size() > 2 && straight(out.size() - 1)) out.pop_back();
  while (out.size() > 2 && straight(0)) out.erase(out.begin());
  return out.size() > 2 ? out : Loop{};
}

/// Loops of edges that have the inside on their left; at a corner of several the next is the first clockwise.
std::vector<Loop> loops_of(const std::vector<std::array<Point2, 2>>& edges) {
  std::multimap<Point2, Point2> next;
  for (const auto& [a, b] : edges) {
    if (a != b) next.emplace(a, b);
  }
  std::vector<Loop> out;
  while (!next.empty()) {
    const auto first = next.begin();
    Loop loop{first->first};
    Point2 before = first->first, at = first->second;
    next.erase(first);
    while (at != loop.front()) {
      const auto [begin, end] = next.equal_range(at);
      require(begin != end, "combine: an outline of an area is open");
      const double back = angle(at, before);
      const auto clockwise = [&](const auto& way) {
        const double turned = back - angle(at, way.second);
        return turned <= 0 ? turned + 2 * std::numbers::pi : turned;
      };
      const auto best =
          std::min_element(begin, end, [&](const auto& x, const auto& y) { return clockwise(x) < clockwise(y); });
      loop.push_back(at);
      before = at;
      at = best->second;
      next.erase(best);
    }
    loop = without_straight(loop);
    if (!loop.empty()) out.push_back(std::move(loop));
  }
  return out;
}

}  // namespace

Area combine(const std::vector<Area>& operands, const Membership& membership) {
  std::vector<Edge> edges = edges_of(operands);
  if (edges.size() > kMostEdges) throw InputError("has areas of more than 20,000 edges; make them coarser");
  std::vector<std::array<Point2, 2>> bounds;
  for (const Piece& piece : split_all(edges)) {
    const auto in = sides(piece, edges, operands.size());
    const bool left = membership(in[0]), right = membership(in[1]);
    if (left == right) continue;
    const Point2 p = rounded(piece.first), q = rounded(piece.second);
    bounds.push_back(left ? std::array{p, q} : std::array{q, p});
  }
  return {loops_of(bounds), true};
}

Area cleaned(const Area& area) {
  return area.is_clean ? area : combine({area}, [](const std::vector<bool>& in) { return in[0]; });
}

Area hull(const std::vector<Area>& operands) {
  std::vector<Exact2> points;
  for (const Area& area : operands) {
    for (const Loop& loop : area.loops)
      std::transform(loop.begin(), loop.end(), std::back_inserter(points), exact);
  }
  sort_unique(points);
  std::vector<Exact2> around;
  const auto walk = [&](const auto& sorted) {  // one half, from end to end
    const std::size_t start = around.size();
    for (const Exact2& p : sorted) {
      while (around.size() > start + 1 && turn(around[around.size() - 2], around.back(), p) <= 0)
        around.pop_back();
      around.push_back(p);
    }
    if (!around.empty()) around.pop_back();
  };
  walk(points);
  std::reverse(points.begin(), points.end());
  walk(points);
  Loop loop;
  for (const Exact2& p : around) loop.push_back({to_double(p[0]), to_double(p[1])});
  return loop.size() < 3 ? Area{} : Area{{loop}, true};
}

Area transformed(const Area& area, const std::array<std::array<double, 3>, 2>& m) {
  Area out = area;
  for (Loop& loop : out.loops) {
    for (Point2& p : loop) {
      p = {m[0][0] * p[0] + m[0][1] * p[1] + m[0][2], m[1][0] * p[0] + m[1][1] * p[1] + m[1][2]};
    }
  }
  out.is_clean = area.is_clean && m[0][0] * m[1][1] - m[0][1] * m[1][0] > 0;
  return out;
}

bool is_convex(const Area& area) {
  if (area.loops.size() != 1) return false;
  const Loop& loop = area.loops.front();
  const std::size_t n = loop.size();
  int way = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const int side = sgn(turn(exact(loop[i]), exact(loop[(i + 1) % n]), exact(loop[(i + 2) % n])));
    if (side * way < 0) return false;
    if (side != 0) way = side;
  }
  return true;
}

namespace {

Point2 corner_at(const PointTable& points, VertexId v) {
  const RationalPoint p = points.rational(v);
  return {to_double(p[0]), to_double(p[1])};
}

/// Whether the first and the third corner of a quad are joined, as OpenSCAD's triangulation has it: that is
/// CGAL's, where four corners lie on one circle, too.
bool is_diagonal(const std::array<Point2, 4>& quad) {
  const auto joins = [](const auto& t) { return t[0] == 0 && (t[1] == 2 || t[2] == 2); };
  const Delaunay made = delaunay(quad);
  return made.triangles.size() == 2 && std::all_of(made.triangles.begin(), made.triangles.end(), joins);
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangles(const Area& area) {
  PointTable points;
  std::vector<std::vector<VertexId>> loops;
  std::map<Point2, VertexId> known;
  std::vector<std::uint32_t> number;  // of the first corner at the place of each point
  std::uint32_t corner = 0;
  for (const Loop& loop : area.loops) {
    auto& ids = loops.emplace_back();
    for (const Point2& p : loop) {
      const auto [at, is_new] = known.try_emplace(p);
      if (is_new) {
        at->second = points.add(p[0], p[1], 0);
        number.push_back(corner);
      }
      ids.push_back(at->second);
      ++corner;
    }
  }
  std::vector<std::array<VertexId, 3>> made = triangulate(points, Projection{0, 1}, loops);
  flip_edges(made, loops, [&](VertexId p, VertexId a, VertexId q, VertexId b) {
    return is_diagonal({corner_at(points, p), corner_at(points, a), corner_at(points, q), corner_at(points, b)});
  });
  std::vector<std::array<std::uint32_t, 3>> out;
  for (const auto& t : made) out.push_back({number[t[0].index()], number[t[1].index()], number[t[2].index()]});
  return out;
}

}  // namespace cnrg::openscad
