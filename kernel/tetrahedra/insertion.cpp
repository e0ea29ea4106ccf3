#include "kernel/tetrahedra/insertion.h"

#include <algorithm>
#include <cmath>

#include "kernel/base/vectors.h"

namespace cnrg {
namespace {

using Index = Stars::Index;
using Point = Stars::Point;
using Tetrahedron = Stars::Tetrahedron;

/// No hole has more tetrahedra, and no way to a place leads through more.
constexpr std::size_t kMost = 4000, kFar = 400;
/// A triangle of a facet must keep at least this part of a right angle's turn to the facet's normal.
constexpr double kFlatTurn = 0.9;

Point plus(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

/// From the first corner to the middle of the sphere around a tetrahedron.
Point to_center(const Stars& mesh, const Tetrahedron& t) {
  const Point& a = mesh.point(t.corners[0]);
  const Point u = minus(mesh.point(t.corners[1]), a), v = minus(mesh.point(t.corners[2]), a),
              w = minus(mesh.point(t.corners[3]), a);
  const Point vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const double uu = dot(u, u), vv = dot(v, v), ww = dot(w, w), twice = 2 * dot(u, vw);
  Point c;
  for (std::size_t k = 0; k < 3; ++k) c[k] = (uu * vw[k] + vv * wu[k] + ww * uv[k]) / twice;
  return c;
}
/// From a corner to the middle of the circle around a triangle, by its edges from there.
Point to_center(const Point& u, const Point& v) {
  const Point n = cross(u, v), vn = cross(v, n), nu = cross(n, u);
  const double uu = dot(u, u), vv = dot(v, v), twice = 2 * dot(n, n);
  Point c;
  for (std::size_t k = 0; k < 3; ++k) c[k] = (uu * vn[k] + vv * nu[k]) / twice;
  return c;
}
bool finite(const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

}  // namespace

/// Walks from the tetrahedron to the middle of its sphere.
bool Insertion::find(Index t, Place& place) {
  place.at = plus(mesh_.point(mesh_.at(t).corners[0]), to_center(mesh_, mesh_.at(t)));
  if (!finite(place.at)) return false;
  place.facet = Stars::kNone;
  Index at = t;
  way_.clear();
  for (std::size_t step = 0; step < kFar; ++step) {
    way_.push_back(at);
    const Tetrahedron& here = mesh_.at(at);
    int out = -1;
    for (int k = 0; k < 4 && out < 0; ++k) {
      const auto [p, q, r] = here.face(k);
      const Point& a = mesh_.point(p);
      const Point n = cross(minus(mesh_.point(q), a), minus(mesh_.point(r), a));
      const double there = dot(n, minus(place.at, a)),
                   inside = dot(n, minus(mesh_.point(here.corners[static_cast<std::size_t>(k)]), a));
      if (there * inside < 0) out = k;
    }
    if (out < 0) {
      place.tetrahedron = at;
      return true;
    }
    if (here.facets[static_cast<std::size_t>(out)] != Stars::kNone) return find_on_facet(at, out, place);
    at = mesh_.across(at, out);
    if (at == Stars::kNoTetrahedron) return false;
  }
  return false;
}

/// Walks in the facet to the middle of the circle around the triangle opposite to corner k.
bool Insertion::find_on_facet(Index t, int k, Place& place) {
  if (keep_) return false;
  place.facet = mesh_.at(t).facets[static_cast<std::size_t>(k)];
  std::array<Index, 3> f = mesh_.at(t).face(k);
  const Point& n = mesh_.normal(place.facet);
  {
    const Point& a = mesh_.point(f[0]);
    place.at = plus(a, to_center(minus(mesh_.point(f[1]), a), minus(mesh_.point(f[2]), a)));
    if (!finite(place.at)) return false;
    const double off = dot(minus(place.at, mesh_.origin(place.facet)), n);
    for (std::size_t i = 0; i < 3; ++i) place.at[i] -= off * n[i];
  }
  Index at = t;  // has the triangle f
  for (std::size_t step = 0; step < kFar; ++step) {
    std::size_t out = 3;
    for (std::size_t i = 0; i < 3 && out == 3; ++i) {
      const Point &a = mesh_.point(f[(i + 1) % 3]), &b = mesh_.point(f[(i + 2) % 3]);
      const Point side = cross(n, minus(b, a));
      if (dot(side, minus(place.at, a)) * dot(side, minus(mesh_.point(f[i]), a)) < 0) out = i;
    }
    if (out == 3) {
      place.tetrahedron = at;
      return true;
    }
    const Index a = f[(out + 1) % 3], b = f[(out + 2) % 3];
    if (mesh_.line(a, b) != Stars::kNone) {
      in_the_way_ = {a, b, f[out]};
      return false;
    }
    Index next = Stars::kNoTetrahedron, apex = f[out];
    for (const Index u : mesh_.star(a)) {
      const Tetrahedron& tet = mesh_.at(u);
      if (!tet.has(b)) continue;
      for (std::size_t i = 0; i < 4; ++i) {
        const Index c = tet.corners[i];
        if (c == a || c == b || c == f[out]) continue;
        // The triangle a, b, c is opposite to the fourth corner.
        for (std::size_t j = 0; j < 4; ++j) {
          const Index d = tet.corners[j];
          if (d != a && d != b && d != c && tet.facets[j] == place.facet) next = u, apex = c;
        }
      }
    }
    if (next == Stars::kNoTetrahedron) return false;
    at = next;
    f = {a, b, apex};
  }
  return false;
}

/// All that has the place inside of its sphere, from the tetrahedron that holds it.
void Insertion::grow(const Place& place) {
  mark_.resize(mesh_.size(), 0);
  ++round_;
  hole_.clear();
  if (place.facet != Stars::kNone) way_.assign(1, place.tetrahedron);
  for (const Index h : way_) {
    if (!in_hole(h)) hole_.push_back(h);
    mark_[h] = round_;
  }
  for (std::size_t i = 0; i < hole_.size() && hole_.size() < kMost; ++i) {
    for (int k = 0; k < 4; ++k) {
      if (between(mesh_.at(hole_[i]).facets[static_cast<std::size_t>(k)], place)) continue;
      const Index u = mesh_.across(hole_[i], k);
      if (u == Stars::kNoTetrahedron || in_hole(u)) continue;
      const Point m = to_center(mesh_, mesh_.at(u));
      const Point off = minus(minus(place.at, mesh_.point(mesh_.at(u).corners[0])), m);
      if (finite(m) && dot(off, off) >= dot(m, m)) continue;
      hole_.push_back(u);
      mark_[u] = round_;
    }
  }
}

bool Insertion::take_out(const Place& place, Index t, Index h) {
  if (h == t || h == place.tetrahedron) return false;
  mark_[h] = 0;
  return true;
}

/// Takes tetrahedra out of the hole until all its walls pass.
bool Insertion::fit(Index v, const Place& place, Index t, double bar) {
  for (bool changed = true; changed;) {
    changed = false;
    fresh_.clear();
    for (const Index h : hole_) {
      if (!in_hole(h)) continue;
      const std::size_t before = fresh_.size();
      bool passes = true;
      for (int k = 0; k < 4 && passes; ++k) {
        const Tetrahedron& here = mesh_.at(h);
        const std::int32_t facet = here.facets[static_cast<std::size_t>(k)];
        const bool in_plane = facet != Stars::kNone && facet == place.facet;
        if (!between(facet, place)) {
          const Index u = mesh_.across(h, k);
          if (u == Stars::kNoTetrahedron ? in_plane : in_hole(u)) continue;
        }
        Tetrahedron n = here;
        n.corners[static_cast<std::size_t>(k)] = v;
        for (int j = 0; j < 4; ++j)
          if (j != k) n.facets[static_cast<std::size_t>(j)] = Stars::kNone;
        n.shape = in_plane ? -1 : mesh_.measure(n.corners, n.region, bar);
        passes = n.shape > bar && n.shape >= 0;
        fresh_.push_back(n);
      }
      if (passes) continue;
      fresh_.resize(before);
      if (!take_out(place, t, h)) return false;
      changed = true;
    }
    std::erase_if(hole_, [&](Index h) { return !in_hole(h); });
    if (!changed && !keep_sides(place, t, changed)) return false;
  }
  return place.facet == Stars::kNone || set_facets(v, place.facet);
}

/// A line or a vertex that has to stay is on the walls, or a tetrahedron that has it, the farthest, stays, too.
bool Insertion::keep_sides(const Place& place, Index t, bool& changed) {
  sides_.clear();
  for (const Tetrahedron& n : fresh_) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j <= i; ++j)
        sides_.push_back({std::min(n.corners[i], n.corners[j]), std::max(n.corners[i], n.corners[j])});
    }
  }
  std::sort(sides_.begin(), sides_.end());
  const auto on_wall = [&](Index a, Index b) {
    return std::binary_search(sides_.begin(), sides_.end(), std::array{std::min(a, b), std::max(a, b)});
  };
  const auto keep = [&](Index a, Index b) {
    double far = -1;
    Index which = Stars::kNoTetrahedron;
    for (const Index i : hole_) {
      const Tetrahedron& h = mesh_.at(i);
      if (i == t || i == place.tetrahedron || !in_hole(i) || !h.has(a) || !h.has(b)) continue;
      Point off{};
      for (const Index c : h.corners) off = plus(off, minus(mesh_.point(c), place.at));
      if (dot(off, off) > far) far = dot(off, off), which = i;
    }
    if (which == Stars::kNoTetrahedron) return false;
    mark_[which] = 0;
    changed = true;
    return true;
  };
  for (const Index h : hole_) {
    if (!in_hole(h)) continue;
    for (const Index a : mesh_.at(h).corners) {
      const bool stays = a < fixed_ || mesh_.facet(a) != Stars::kNone || !mesh_.lines(a).empty();
      if (stays && !on_wall(a, a) && !keep(a, a)) return false;
      for (const Stars::Line& line : mesh_.lines(a)) {
        if (line.to > a && mesh_.at(h).has(line.to) && !on_wall(a, line.to) && !keep(a, line.to)) return false;
      }
      if (!in_hole(h)) break;
    }
  }
  return true;
}

/// The new triangles of the facet are over the sides that one of the old ones has.
bool Insertion::set_facets(Index v, std::int32_t facet) {
  sides_.clear();
  for (const Index h : hole_) {
    const Tetrahedron& here = mesh_.at(h);
    for (int k = 0; k < 4; ++k) {
      if (here.facets[static_cast<std::size_t>(k)] != facet) continue;
      const Index u = mesh_.across(h, k);
      if (u != Stars::kNoTetrahedron && h > u) continue;
      const std::array<Index, 3> f = here.face(k);
      for (std::size_t j = 0; j < 3; ++j)
        sides_.push_back({std::min(f[j], f[(j + 1) % 3]), std::max(f[j], f[(j + 1) % 3])});
    }
  }
  std::sort(sides_.begin(), sides_.end());
  std::vector<std::array<Index, 2>> once;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    if (i + 1 < sides_.size() && sides_[i] == sides_[i + 1]) ++i;
    else once.push_back(sides_[i]);
  }
  const Point &n = mesh_.normal(facet), &p = mesh_.point(v);
  for (const auto& [a, b] : once) {
    const Point m = cross(minus(mesh_.point(a), p), minus(mesh_.point(b), p));
    const double up = dot(m, n);
    if (!(up * up > kFlatTurn * kFlatTurn * dot(m, m))) return false;
  }
  for (Tetrahedron& t : fresh_) {
    const int at = t.place(v);
    for (int j = 0; j < 4; ++j) {
      if (j == at) continue;
      std::array<Index, 2> side{};
      std::size_t m = 0;
      for (int i = 0; i < 4; ++i)
        if (i != j && i != at) side[m++] = t.corners[static_cast<std::size_t>(i)];
      if (side[0] > side[1]) std::swap(side[0], side[1]);
      if (std::binary_search(once.begin(), once.end(), side)) t.facets[static_cast<std::size_t>(j)] = facet;
    }
  }
  return !once.empty();
}

Index Insertion::insert(Index t, double gain) {
  in_the_way_ = {0, 0, 0};
  Place place{};
  if (!find(t, place)) return Stars::kNoTetrahedron;
  grow(place);
  if (!in_hole(t)) return Stars::kNoTetrahedron;
  const Index v = mesh_.add_point(place.at, place.facet);
  if (!fit(v, place, t, gain * mesh_.at(t).shape)) {
    mesh_.drop_point();
    return Stars::kNoTetrahedron;
  }
  mesh_.replace(hole_, fresh_);
  return v;
}

}  // namespace cnrg
