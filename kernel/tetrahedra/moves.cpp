#include "kernel/tetrahedra/moves.h"

#include <cmath>
#include <functional>

#include "kernel/base/limits.h"
#include "kernel/base/per_thread.h"
#include "kernel/base/vectors.h"

namespace cnrg {
namespace {

using Index = Stars::Index;
using Point = Stars::Point;
using Tetrahedron = Stars::Tetrahedron;

/// Rings of more tetrahedra are left: the best triangulation takes the third power of their number.
constexpr std::size_t kLongest = 12;
/// A triangle of a facet must keep at least this part of a right angle's turn to the facet's normal.
constexpr double kFlat = 0.9;
/// Costs fall by at least so much, as for one bad shape that gets better by a twentieth: there is nearly always a
/// little to gain, which helps nobody.
constexpr double kLess = 0.05;
/// A vertex is drawn to what makes so many bad tetrahedra better, and so often for each.
constexpr std::size_t kBadOnes = 6, kPulls = 2;

}  // namespace

double Moves::worst(std::span<const Index> tetrahedra) const {
  double worst = kInfinity;
  for (const Index t : tetrahedra) worst = std::min(worst, mesh_.at(t).shape);
  return worst;
}

double Moves::value(std::span<const Index> tetrahedra) const {
  double all = nothing();
  for (const Index t : tetrahedra) all = both(all, value(mesh_.at(t)));
  return all;
}

/// Of one that would be there; of no use where it is not above the bar.
double Moves::value(const std::array<Index, 4>& corners, std::int32_t region, double bar) const {
  Tetrahedron t{.corners = corners, .region = region};
  t.shape = mesh_.measure(corners, region, aim_ ? 0 : bar);
  return t.shape > 0 ? value(t) : -kInfinity;
}

/// Where costs count: what a move would put in the place of what it would take away.
bool Moves::costs_less() const {
  double fresh = 0;
  for (const Tetrahedron& t : fresh_) fresh += value(t);
  return fresh > value(old_) + kLess;
}

double Moves::squared(Index a, Index b) const {
  const Point d = minus(mesh_.point(a), mesh_.point(b));
  return dot(d, d);
}

const std::vector<Index>& Moves::at_edge(Index a, Index b) {
  at_edge_.clear();
  if (mesh_.star(b).size() < mesh_.star(a).size()) std::swap(a, b);
  for (const Index t : mesh_.star(a))
    if (mesh_.at(t).has(b)) at_edge_.push_back(t);
  return at_edge_;
}

bool Moves::remove_edge(Index a, Index b, double longest) {
  if (mesh_.line(a, b) != Stars::kNone || !mesh_.ring(a, b, ring_)) return false;
  auto& around = ring_.around;
  auto& tets = ring_.tetrahedra;
  const std::size_t n = tets.size();
  if (n > kLongest) return false;
  const auto facet_at = [&](std::size_t k) {  // of the face a, b, around[k]
    if (k < n) {
      const auto& t = mesh_.at(tets[k]);
      return t.facet_opposite(around[(k + 1) % around.size()]);
    }
    return mesh_.at(tets[k - 1]).facet_opposite(around[k - 1]);
  };
  std::vector<std::size_t> walls;
  for (std::size_t k = 0; k < around.size(); ++k)
    if (facet_at(k) != Stars::kNone) walls.push_back(k);
  old_ = tets;
  fresh_.clear();
  const double bar = value(old_);
  if (walls.empty()) {
    if (!ring_.closed || n < 3 || !fill_arc(a, b, 0, n, false, Stars::kNone, bar, longest)) return false;
  } else {
    if (keep_ || walls.size() != 2 || facet_at(walls[0]) != facet_at(walls[1])) return false;
    const std::int32_t facet = facet_at(walls[0]);
    const Index c = around[walls[0]], d = around[walls[1]];
    if (mesh_.line(c, d) != Stars::kNone) return false;
    if (!turned_like(facet, mesh_.point(a), mesh_.point(d), c, b) ||
        !turned_like(facet, mesh_.point(b), mesh_.point(c), d, a))
      return false;
    const auto change_side = [&](std::size_t from, std::size_t count) {
      return count == 2 ? peel(tets[from], a, b, facet) : fill_arc(a, b, from, count, true, facet, bar, longest);
    };
    if (!ring_.closed) {
      if (walls[0] != 0 || walls[1] != n || !change_side(0, n + 1)) return false;
    } else {
      const std::size_t between = walls[1] - walls[0];
      if (!change_side(walls[0], between + 1) || !change_side(walls[1], n - between + 1)) return false;
    }
  }
  if (aim_ && !costs_less()) return false;
  mesh_.replace(old_, fresh_);
  return true;
}

/// One tetrahedron alone lies over both triangles of a facet at ab, as flat as that: it goes, and what is beyond
/// it comes to the new triangles.
bool Moves::peel(Index t, Index a, Index b, std::int32_t facet) {
  const Tetrahedron flat = mesh_.at(t);
  for (const Index corner : {a, b}) {
    const int k = flat.place(corner);
    const Index beyond = mesh_.across(t, k);
    if (flat.facets[static_cast<std::size_t>(k)] != Stars::kNone || beyond == Stars::kNoTetrahedron) return false;
    Tetrahedron next = mesh_.at(beyond);
    for (std::size_t j = 0; j < 4; ++j)
      if (flat.place(next.corners[j]) < 0) next.facets[j] = facet;
    old_.push_back(beyond), fresh_.push_back(next);
  }
  return true;
}

/// Fills what is between a, b and `count` vertices of the ring from the place `from` on. `closing`: the side from
/// the last one to the first is a new side in `facet`, not one of the ring.
bool Moves::fill_arc(Index a, Index b, std::size_t from, std::size_t count, bool closing, std::int32_t facet,
                     double bar, double longest) {
  if (count < 3) return false;
  const auto& around = ring_.around;
  const std::size_t n = ring_.tetrahedra.size();
  const auto p = [&](std::size_t i) { return around[(from + i) % around.size()]; };
  const std::int32_t region = mesh_.at(ring_.tetrahedra[from % n]).region;
  double best[kLongest + 1][kLongest + 1];
  std::size_t by[kLongest + 1][kLongest + 1];
  for (std::size_t i = 0; i + 1 < count; ++i) best[i][i + 1] = nothing();
  for (std::size_t length = 2; length < count; ++length) {
    for (std::size_t i = 0; i + length < count; ++i) {
      const std::size_t j = i + length;
      best[i][j] = -kInfinity, by[i][j] = i + 1;
      const bool fresh = closing || length + 1 < count;
      if (fresh && longest < kInfinity && squared(p(i), p(j)) >= longest) continue;
      for (std::size_t k = i + 1; k < j; ++k) {
        double good = both(best[i][k], best[k][j]);
        const double least = std::max(bar, best[i][j]);
        if (good <= least) continue;
        good = both(good, value({a, p(i), p(k), p(j)}, region, least));
        if (good <= least) continue;
        good = both(good, value({b, p(i), p(j), p(k)}, region, least));
        if (good > best[i][j]) best[i][j] = good, by[i][j] = k;
      }
      if (length + 1 == count && best[i][j] <= bar) return false;
    }
  }
  if (!(best[0][count - 1] > bar)) return false;
  const auto label = [&](std::size_t i, std::size_t j,
                         Index other) {  // of the face over a side, seen from `other`
    if (j == i + 1) return mesh_.at(ring_.tetrahedra[(from + i) % n]).facet_opposite(other);
    if (i == 0 && j + 1 == count)
      return closing ? facet : mesh_.at(ring_.tetrahedra[(from + j) % n]).facet_opposite(other);
    return Stars::kNone;
  };
  const std::function<void(std::size_t, std::size_t)> build = [&](std::size_t i, std::size_t j) {
    if (j == i + 1) return;
    const std::size_t k = by[i][j];
    // Opposite to each corner is the face over the side of the two others.
    fresh_.push_back({{a, p(i), p(k), p(j)},
                      {Stars::kNone, label(k, j, b), label(i, j, b), label(i, k, b)},
                      region,
                      mesh_.measure({a, p(i), p(k), p(j)}, region)});
    fresh_.push_back({{b, p(i), p(j), p(k)},
                      {Stars::kNone, label(k, j, a), label(i, k, a), label(i, j, a)},
                      region,
                      mesh_.measure({b, p(i), p(j), p(k)}, region)});
    build(i, k), build(k, j);
  };
  build(0, count - 1);
  return true;
}

bool Moves::swap_face(Index t, int k) {
  const Tetrahedron s = mesh_.at(t);
  if (s.facets[static_cast<std::size_t>(k)] != Stars::kNone) return false;
  const Index u = mesh_.across(t, k);
  if (u == Stars::kNoTetrahedron) return false;
  const Tetrahedron& o = mesh_.at(u);
  const std::array<Index, 3> f = s.face(k);
  const Index d = s.corners[static_cast<std::size_t>(k)];
  Index e = d;
  for (const Index v : o.corners)
    if (!s.has(v)) e = v;
  const double bar = aim_ ? 0 : std::min(s.shape, o.shape);
  fresh_.clear();
  for (std::size_t i = 0; i < 3; ++i) {
    const Index p = f[i], q = f[(i + 1) % 3], r = f[(i + 2) % 3];
    Tetrahedron n{
        {e, d, p, q}, {s.facet_opposite(r), o.facet_opposite(r), Stars::kNone, Stars::kNone}, s.region, 0};
    n.shape = mesh_.measure(n.corners, n.region, bar);
    if (n.shape <= bar) return false;
    fresh_.push_back(n);
  }
  old_ = {t, u};
  if (aim_ && !costs_less()) return false;
  mesh_.replace(old_, fresh_);
  return true;
}

/// Is the triangle p, q, `after` turned to the facet as p, q, `before` is, and no sliver of it?
bool Moves::turned_like(std::int32_t facet, const Point& before, const Point& after, Index p, Index q) const {
  const Point& a = mesh_.point(p);
  const Point side = minus(mesh_.point(q), a), old = cross(side, minus(before, a)),
              fresh = cross(side, minus(after, a));
  const double x = dot(old, mesh_.normal(facet)), y = dot(fresh, mesh_.normal(facet));
  return x * y > 0 && y * y > kFlat * kFlat * dot(fresh, fresh);
}

/// May `a` go to `b`, as far as lines and facets tell? A vertex on a line goes along it, one on a facet in it.
bool Moves::may_go(Index a, Index b) const {
  if (a < fixed_) return false;
  if (!mesh_.lines(a).empty()) {
    if (keep_) return false;
    const auto lines = mesh_.lines(a);
    if (lines.size() != 2 || lines[0].line != lines[1].line || mesh_.line(a, b) == Stars::kNone) return false;
    const Index other = lines[0].to == b ? lines[1].to : lines[0].to;
    return other != b && mesh_.line(other, b) == Stars::kNone;
  }
  const std::int32_t facet = mesh_.facet(a);
  if (facet == Stars::kNone) return true;
  if (keep_ || facet == Stars::kMany) return false;
  for (const Index t : mesh_.star(a)) {
    const auto& tet = mesh_.at(t);
    if (!tet.has(b)) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      if (tet.facets[k] == facet && tet.corners[k] != a && tet.corners[k] != b) return true;
    }
  }
  return false;
}

bool Moves::collapse(Index a, Index b, double enough, double longest) {
  if (!may_go(a, b)) return false;
  fresh_.clear();
  old_.assign(mesh_.star(a).begin(), mesh_.star(a).end());
  const double bar = aim_ ? 0 : std::min(enough, worst(old_));
  // Faces of what goes, opposite to `a`, lie on what comes: the face (b, x, y) of a tetrahedron (a, b, x, y).
  struct Joined {
    std::array<Index, 2> side;  // sorted
    std::int32_t facet;
  };
  std::vector<Joined> joined;
  for (const Index i : old_) {
    const Tetrahedron& t = mesh_.at(i);
    if (!t.has(b)) continue;
    if (t.facet_opposite(b) != Stars::kNone) return false;
    if (t.facet_opposite(a) == Stars::kNone) continue;
    std::array<Index, 2> side{};
    std::size_t n = 0;
    for (const Index v : t.corners)
      if (v != a && v != b) side[n++] = v;
    if (side[0] > side[1]) std::swap(side[0], side[1]);
    joined.push_back({side, t.facet_opposite(a)});
  }
  for (const Index i : old_) {
    Tetrahedron t = mesh_.at(i);
    if (t.has(b)) continue;
    const auto at = static_cast<std::size_t>(t.place(a));
    // A face of a facet at `a` keeps its turn.
    for (std::size_t k = 0; k < 4; ++k) {
      if (t.facets[k] == Stars::kNone || k == at) continue;
      Index p = a, q = a;
      for (std::size_t m = 0; m < 4; ++m) {
        if (m == k || m == at) continue;
        (p == a ? p : q) = t.corners[m];
      }
      if (!turned_like(t.facets[k], mesh_.point(a), mesh_.point(b), p, q)) return false;
    }
    t.corners[at] = b;
    t.shape = mesh_.measure(t.corners, t.region, bar);
    if (t.shape < 0 || t.shape <= bar) return false;
    for (const Index v : t.corners)
      if (t.region >= 0 && v != b && squared(v, b) > longest) return false;
    for (const Joined& j : joined) {
      const int p = t.place(j.side[0]), q = t.place(j.side[1]);
      if (p < 0 || q < 0) continue;
      for (std::size_t k = 0; k < 4; ++k) {
        if (static_cast<int>(k) != p && static_cast<int>(k) != q && t.corners[k] != b) t.facets[k] = j.facet;
      }
    }
    fresh_.push_back(t);
  }
  if (fresh_.empty() || (aim_ && !costs_less())) return false;
  const auto lines = mesh_.lines(a);
  if (!lines.empty()) {
    const Stars::Line along = lines[0];
    const Index other = lines[0].to == b ? lines[1].to : lines[0].to;
    mesh_.remove_line(a, b);
    mesh_.remove_line(a, other);
    mesh_.add_line(b, other, along.line);
  }
  mesh_.replace(old_, fresh_);
  return true;
}

Index Moves::split(Index a, Index b) {
  const Point &p = mesh_.point(a), &q = mesh_.point(b);
  const Point m{p[0] + (q[0] - p[0]) / 2, p[1] + (q[1] - p[1]) / 2, p[2] + (q[2] - p[2]) / 2};
  const std::int32_t line = mesh_.line(a, b);
  old_ = at_edge(a, b);
  std::int32_t facet = Stars::kNone;
  for (const Index t : old_) {
    const auto& tet = mesh_.at(t);
    for (std::size_t k = 0; k < 4; ++k) {
      if (tet.corners[k] != a && tet.corners[k] != b && tet.facets[k] != Stars::kNone) facet = tet.facets[k];
    }
  }
  if (line != Stars::kNone) facet = Stars::kMany;
  if (keep_ && facet != Stars::kNone) return Stars::kNoTetrahedron;
  const Index v = mesh_.add_point(m, facet);
  fresh_.clear();
  for (const Index i : old_) {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      Tetrahedron t = mesh_.at(i);
      const auto at = static_cast<std::size_t>(t.place(from)), other = static_cast<std::size_t>(t.place(to));
      t.corners[at] = v;
      t.facets[other] = Stars::kNone;  // the new face between the two
      t.shape = mesh_.measure(t.corners, t.region);
      if (t.shape < 0) return Stars::kNoTetrahedron;
      fresh_.push_back(t);
    }
  }
  if (line != Stars::kNone) {
    mesh_.remove_line(a, b);
    mesh_.add_line(a, v, line);
    mesh_.add_line(v, b, line);
  }
  mesh_.replace(old_, fresh_);
  return v;
}

bool Moves::divide(Index a, Index b) {
  const std::int32_t line = mesh_.line(a, b);
  std::vector<Tetrahedron> before;
  for (const Index t : at_edge(a, b)) before.push_back(mesh_.at(t));
  const double cost = value(at_edge_);
  const Index v = split(a, b);
  if (v == Stars::kNoTetrahedron) return false;
  smooth(v, 1);
  if (value(mesh_.star(v)) > cost + kLess) return true;
  old_.assign(mesh_.star(v).begin(), mesh_.star(v).end());
  if (line != Stars::kNone) {
    mesh_.remove_line(a, v);
    mesh_.remove_line(v, b);
    mesh_.add_line(a, b, line);
  }
  mesh_.replace(old_, before);
  mesh_.drop_point();
  return false;
}

/// Brings a place for `v` to the line or facet on which it is. False if it may not move.
bool Moves::project(Index v, Point& p) const {
  const auto lines = mesh_.lines(v);
  const std::int32_t facet = mesh_.facet(v);
  if (v < fixed_ || (keep_ && facet != Stars::kNone)) return false;
  if (!lines.empty()) {
    if (lines.size() != 2 || lines[0].line != lines[1].line) return false;
    const Point &a = mesh_.point(lines[0].to), d = minus(mesh_.point(lines[1].to), a);
    double s = dot(minus(p, a), d) / dot(d, d);
    if (!(s > 0.1 && s < 0.9)) return false;
    for (std::size_t k = 0; k < 3; ++k) p[k] = a[k] + s * d[k];
    return true;
  }
  if (facet == Stars::kNone) return true;
  if (facet == Stars::kMany) return false;
  const Point& n = mesh_.normal(facet);
  const double off = dot(minus(p, mesh_.origin(facet)), n);
  for (std::size_t k = 0; k < 3; ++k) p[k] -= off * n[k];
  return true;
}

bool Moves::try_place(Index v, const Point& place, double gain, double& now) {
  Point p = place;
  if (!project(v, p)) return false;
  const Point before = mesh_.point(v);
  if (p == before) return false;
  const std::int32_t facet = mesh_.facet(v);
  if (facet >= 0) {  // triangles of the facet keep their turn
    for (const Index i : mesh_.star(v)) {
      const auto& t = mesh_.at(i);
      for (std::size_t k = 0; k < 4; ++k) {
        if (t.facets[k] != facet || t.corners[k] == v) continue;
        std::array<Index, 2> side{};
        std::size_t n = 0;
        for (std::size_t m = 0; m < 4; ++m)
          if (m != k && t.corners[m] != v) side[n++] = t.corners[m];
        if (!turned_like(facet, before, p, side[0], side[1])) return false;
      }
    }
  }
  mesh_.move(v, p);
  const double bar = aim_ ? now + kLess : now * gain;
  struct Shapes {
    std::vector<double> list;
  };
  auto& shapes = PerThread<Shapes>::own().list;
  shapes.clear();
  double then = nothing();
  for (const Index i : mesh_.star(v)) {
    Tetrahedron t = mesh_.at(i);
    t.shape = mesh_.measure(t.corners, t.region, aim_ ? 0 : bar);
    if (t.shape > 0) then = both(then, value(t));
    if (!(t.shape > 0 && then > bar)) {
      mesh_.move(v, before);
      return false;
    }
    shapes.push_back(t.shape);
  }
  mesh_.set_shapes(v, shapes);
  now = then;
  return true;
}

/// The way in which a shape at `v` gets better fastest.
Point Moves::way_to_better(Index v, Index bad) const {
  // d(det)/dv is the normal of the opposite face, d(sum of squares)/dv = 2 (3 v - a - b - c).
  const Point& here = mesh_.point(v);
  const auto opposite = mesh_.at(bad).face(mesh_.at(bad).place(v));
  const Point &p = mesh_.point(opposite[0]), &q = mesh_.point(opposite[1]), &r = mesh_.point(opposite[2]);
  const Point normal = cross(minus(q, p), minus(r, p)), arm = minus(here, p);
  const double det = dot(normal, arm);
  double squares = 0;
  Point pull{};
  for (const Point* x : {&p, &q, &r}) {
    const Point d = minus(here, *x);
    squares += dot(d, d);
    for (std::size_t k = 0; k < 3; ++k) pull[k] += 2 * d[k];
  }
  const Point pq = minus(q, p), qr = minus(r, q), rp = minus(p, r);
  squares += dot(pq, pq) + dot(qr, qr) + dot(rp, rp);
  Point way;
  for (std::size_t k = 0; k < 3; ++k) way[k] = 2 * normal[k] / det - 3 * pull[k] / squares;
  return way;
}

/// Draws `v` the way in which a bad shape gets better fastest, in shorter and shorter steps.
bool Moves::pull(Index v, Index bad, double room, double gain, double& now) {
  const Point here = mesh_.point(v), way = way_to_better(v, bad);
  const double length = std::sqrt(dot(way, way));
  if (!(length > 0) || !std::isfinite(length)) return false;
  for (const double step : {0.4, 0.1, 0.02}) {
    Point to = here;
    for (std::size_t k = 0; k < 3; ++k) to[k] += way[k] / length * step * room;
    if (try_place(v, to, gain, now)) return true;
  }
  return false;
}

bool Moves::smooth(Index v, double gain) {
  if (Point probe = mesh_.point(v); !project(v, probe)) return false;
  double now = value(mesh_.star(v));
  if (now == nothing()) return false;
  // First to the middle of what is around.
  Point middle{};
  std::size_t n = 0;
  double near = kInfinity;
  for (const Index i : mesh_.star(v)) {
    for (const Index w : mesh_.at(i).corners) {
      if (w == v) continue;
      for (std::size_t k = 0; k < 3; ++k) middle[k] += mesh_.point(w)[k];
      near = std::min(near, squared(v, w));
      ++n;
    }
  }
  for (double& x : middle) x /= static_cast<double>(n);
  const double room = std::sqrt(near);
  bool better = try_place(v, middle, gain, now);
  const auto worse = [&](Index a, Index b) { return mesh_.at(a).shape < mesh_.at(b).shape; };
  if (!aim_) {
    for (int round = 0; round < 4; ++round) {
      if (!pull(v, *std::ranges::min_element(mesh_.star(v), worse), room, gain, now)) break;
      better = true;
    }
    return better;
  }
  std::array<Index, kBadOnes> bad{};
  const auto end = std::ranges::partial_sort_copy(mesh_.star(v), bad, worse).out;
  for (auto t = bad.begin(); t != end; ++t) {
    for (std::size_t round = 0; round < kPulls && value(mesh_.at(*t)) < 0; ++round) {
      if (!pull(v, *t, room, gain, now)) break;
      better = true;
    }
  }
  return better;
}

}  // namespace cnrg
