// A point is put in by taking away all tetrahedra around whose corners there is a sphere with the point inside;
// what is left is a hole whose walls all see the point (bowyer1981). The way there is a walk from tetrahedron to
// tetrahedron, which ends since tetrahedra are Delaunay.
#include "kernel/tetrahedra/tetrahedra.h"

#include <cmath>

#include "kernel/base/error.h"
#include "kernel/base/per_thread.h"
#include "kernel/exact/in_sphere.h"
#include "kernel/exact/predicates.h"
#include "kernel/refine/input.h"
#include "kernel/refine/morton.h"

namespace cnrg {
Tetrahedra::Tetrahedra(PointTable& points, const Watch& watch)
    : points_(points), first_corner_(VertexId(points.size())) {
  make_box();
  std::vector<Box> places(first_corner_.index());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PointView p = points_.view(VertexId(i));
    places[i].extend(p.lo, p.hi);
  }
  VertexId last = first_corner_;
  Steps steps(watch, "tetrahedra: points", places.size());
  for (const std::uint32_t i : morton_order(places, Grid(bounds(places)))) {
    insert(VertexId(i), last);
    last = VertexId(i);
    steps.step();
  }
}

/// Corner i of the box has the upper x, y, z where i has bit 0, 1, 2. All are on one sphere, and the tetrahedra
/// have to be Delaunay by perturbation (kernel/exact/in_sphere.h), else walks may turn round and round.
void Tetrahedra::make_box() {
  std::array<double, 3> low{0, 0, 0}, high{0, 0, 0};
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const auto xyz = points_.approx(VertexId(i));
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = i == 0 ? xyz[k] : std::min(low[k], xyz[k]);
      high[k] = i == 0 ? xyz[k] : std::max(high[k], xyz[k]);
    }
  }
  double size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  for (std::size_t k = 0; k < 3; ++k) size = std::max(size, std::max(std::abs(low[k]), std::abs(high[k])) * 1e-6);
  if (size == 0) size = 1;
  for (int i = 0; i < 8; ++i) {
    const auto at = [&](int k) {
      const auto axis = static_cast<std::size_t>(k);
      return (i >> k & 1) != 0 ? high[axis] + size : low[axis] - size;
    };
    points_.add(at(0), at(1), at(2));
  }
  at_.assign(points_.size(), kNone);
  // Of two corners of a square that have a diagonal, none is the last one.
  constexpr std::array<std::array<std::size_t, 4>, 6> kParts{
      {{0, 1, 2, 4}, {1, 2, 3, 4}, {1, 3, 4, 5}, {2, 3, 4, 6}, {3, 4, 5, 6}, {3, 5, 6, 7}}};
  std::vector<Index> all;
  for (const auto& part : kParts) {
    Corners c;
    for (std::size_t k = 0; k < 4; ++k) c[k] = VertexId(first_corner_.index() + part[k]);
    if (orient3d(points_, c[0], c[1], c[2], c[3]) < 0) std::swap(c[1], c[2]);
    all.push_back(add(c));
  }
  for (const Index t : all) {
    for (const Index u : all) {
      for (int k = 0; t < u && k < 4; ++k) {
        for (int l = 0; l < 4; ++l) {
          auto f = face({t, k}), g = face({u, l});
          std::sort(f.begin(), f.end()), std::sort(g.begin(), g.end());
          if (f == g) join({t, k}, {u, l});
        }
      }
    }
  }
}

std::array<VertexId, 3> Tetrahedra::face(Face f) const {
  const auto& [i, j, l] = kFace[static_cast<std::size_t>(f.k)];
  const Corners& c = corners_[f.tetrahedron];
  return {c[static_cast<std::size_t>(i)], c[static_cast<std::size_t>(j)], c[static_cast<std::size_t>(l)]};
}

/// The same face as its other tetrahedron has it; its `tetrahedron` is kNone on the box.
Tetrahedra::Face Tetrahedra::opposite(Face f) const {
  const Index u = neighbour(f.tetrahedron, f.k);
  if (u == kNone) return {};
  // Two tetrahedra share one face at most, so the numbers of the neighbours tell it.
  const auto& back = neighbours_[u];
  return {u, static_cast<int>(std::find(back.begin(), back.end(), f.tetrahedron) - back.begin())};
}

bool Tetrahedra::meet(Index t) const {
  if (seen_[t] == round_) return false;
  seen_[t] = round_;
  return true;
}

void Tetrahedra::around(VertexId v, std::vector<Index>& out) const {
  out.clear();
  ++round_;
  const Index start = at_[v.index()];
  if (start == kNone) return;
  meet(start);
  out.push_back(start);
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (int k = 0; k < 4; ++k) {
      if (corners_[out[i]][static_cast<std::size_t>(k)] == v) continue;
      const Index u = neighbour(out[i], k);
      if (u != kNone && meet(u)) out.push_back(u);
    }
  }
}

/// The first one is looked for from both ends in turn, since one of them may have very many; then around the edge.
void Tetrahedra::around(VertexId a, VertexId b, std::vector<Index>& out) const {
  const auto has = [&](Index t, VertexId v) { return place(t, v) < 4; };
  const std::array<VertexId, 2> ends{a, b};
  out.clear();
  ++round_;
  Index first = kNone;
  for (std::size_t e = 0; e < 2; ++e) {
    ways_[e].clear();
    const Index start = at_[ends[e].index()];
    if (start == kNone) return;
    if (has(start, ends[1 - e])) first = start;
    meet(start);
    ways_[e].push_back(start);
  }
  for (std::size_t i = 0; first == kNone; ++i) {
    for (std::size_t e = 0; e < 2 && first == kNone; ++e) {
      if (i == ways_[e].size()) return;  // it has met all at this end
      for (int k = 0; k < 4 && first == kNone; ++k) {
        const Index t = ways_[e][i], u = neighbour(t, k);
        if (corners_[t][static_cast<std::size_t>(k)] == ends[e] || u == kNone || !meet(u)) continue;
        ways_[e].push_back(u);
        if (has(u, ends[1 - e])) first = u;
      }
    }
  }
  out.push_back(first);
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (int k = 0; k < 4; ++k) {
      const VertexId v = corners_[out[i]][static_cast<std::size_t>(k)];
      const Index u = neighbour(out[i], k);
      if (v != a && v != b && u != kNone && std::find(out.begin(), out.end(), u) == out.end()) out.push_back(u);
    }
  }
}

Tetrahedra::Index Tetrahedra::locate(VertexId v, Index start) const {
  Index t = start, from = kNone;
  for (;;) {
    bool moved = false;
    for (int k = 0; k < 4 && !moved; ++k) {
      const Index u = neighbour(t, k);
      if (u == from && from != kNone) continue;
      const auto [a, b, c] = face({t, k});
      if (orient3d(points_, a, b, c, v) >= 0) continue;
      require(u != kNone, "tetrahedra: a point outside of the box");
      from = t, t = u, moved = true;
    }
    if (!moved) return t;
  }
}

/// All tetrahedra must be Delaunay. `near` is a vertex that is in already, the nearer the better.
void Tetrahedra::insert(VertexId v, VertexId near) {
  const Index start = locate(v, at_[near.index()]);
  std::vector<Index> hole{start};
  ++round_;
  meet(start);
  for (std::size_t i = 0; i < hole.size(); ++i) {
    for (int k = 0; k < 4; ++k) {
      const Index u = neighbour(hole[i], k);
      if (u == kNone || seen_[u] == round_) continue;
      const auto& [a, b, c, d] = corners_[u];
      if (in_sphere_perturbed(points_, a, b, c, d, v) <= 0) continue;
      meet(u);
      hole.push_back(u);
    }
  }
  fill(v, hole);
}

void Tetrahedra::mark(std::span<const Index> hole) const {
  ++round_;
  for (const Index t : hole) meet(t);
}

bool Tetrahedra::sees(VertexId v, std::span<const Index> hole) const {
  mark(hole);
  for (const Index t : hole) {
    for (int k = 0; k < 4; ++k) {
      const Index u = neighbour(t, k);
      if (u != kNone && seen_[u] == round_) continue;
      const auto [a, b, c] = face({t, k});
      if (v != a && v != b && v != c && orient3d(points_, a, b, c, v) <= 0) return false;
    }
  }
  return true;
}

/// Makes neighbours of each two faces that have the same key. Sorts them.
template <class Key>
void Tetrahedra::join_pairs(std::vector<std::pair<Key, Face>>& faces) {
  std::sort(faces.begin(), faces.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  require(faces.size() % 2 == 0, "tetrahedra: a hole with a gap");
  for (std::size_t i = 0; i < faces.size(); i += 2) {
    require(faces[i].first == faces[i + 1].first, "tetrahedra: a hole with a gap");
    Face f = faces[i].second, g = faces[i + 1].second;
    if (f.tetrahedron == kNone) std::swap(f, g);
    if (f.tetrahedron != kNone) join(f, g);
  }
}

void Tetrahedra::fill(VertexId v, std::span<const Index> hole) {
  if (at_.size() < points_.size()) at_.resize(points_.size(), kNone);
  struct Wall {
    std::array<VertexId, 3> corners;  // with the hole in front
    Face outside;                     // the same face there
  };
  struct Scratch {
    std::vector<Wall> walls;
    std::vector<std::pair<std::uint64_t, Face>> sides;  // faces with v, by the edge opposite to it
  };
  auto& walls = PerThread<Scratch>::own().walls;
  auto& sides = PerThread<Scratch>::own().sides;
  walls.clear(), sides.clear();
  mark(hole);
  for (const Index t : hole) {
    for (int k = 0; k < 4; ++k) {
      const Index u = neighbour(t, k);
      if (u == kNone || seen_[u] != round_) walls.push_back({face({t, k}), opposite({t, k})});
    }
  }
  remove(hole);
  for (const Wall& wall : walls) {
    const auto& corners = wall.corners;
    const auto at = std::find(corners.begin(), corners.end(), v) - corners.begin();
    const auto side = [&](std::ptrdiff_t k) {
      return RefineInput::key(corners[static_cast<std::size_t>((k + 1) % 3)],
                              corners[static_cast<std::size_t>((k + 2) % 3)]);
    };
    if (at < 3) {
      sides.emplace_back(side(at), wall.outside);
      continue;
    }
    const Index t = add({corners[0], corners[1], corners[2], v});
    join({t, 3}, wall.outside);
    for (int k = 0; k < 3; ++k) sides.emplace_back(side(k), Face{t, k});
  }
  join_pairs(sides);
}

void Tetrahedra::replace(std::span<const Index> hole, std::span<const Corners> fresh) {
  struct Sides {
    std::vector<std::pair<std::array<VertexId, 3>, Face>> list;  // by sorted corners
  };
  auto& sides = PerThread<Sides>::own().list;
  sides.clear();
  const auto side = [&](std::array<VertexId, 3> corners, Face f) {
    std::sort(corners.begin(), corners.end());
    sides.emplace_back(corners, f);
  };
  mark(hole);
  for (const Index t : hole) {
    for (int k = 0; k < 4; ++k) {
      const Index u = neighbour(t, k);
      if (u == kNone || seen_[u] != round_) side(face({t, k}), opposite({t, k}));
    }
  }
  remove(hole);
  for (const Corners& corners : fresh) {
    const Index t = add(corners);
    for (int k = 0; k < 4; ++k) side(face({t, k}), {t, k});
  }
  join_pairs(sides);
}

void Tetrahedra::rename(VertexId vertex, VertexId by) {
  if (at_.size() < points_.size()) at_.resize(points_.size(), kNone);
  std::vector<Index> star;
  around(vertex, star);
  for (const Index t : star) std::replace(corners_[t].begin(), corners_[t].end(), vertex, by);
  at_[by.index()] = std::exchange(at_[vertex.index()], kNone);
}

void Tetrahedra::remove(std::span<const Index> hole) {
  for (const Index t : hole) {
    for (const VertexId corner : corners_[t]) at_[corner.index()] = kNone;
    corners_[t].fill(VertexId::none());
    free_.push_back(t);
  }
}

Tetrahedra::Index Tetrahedra::add(const Corners& corners) {
  Index t;
  if (free_.empty()) {
    check_count(corners_.size() + 1, "tetrahedra");
    t = static_cast<Index>(corners_.size());
    corners_.push_back(corners);
    neighbours_.push_back({kNone, kNone, kNone, kNone});
    seen_.push_back(0);
  } else {
    t = free_.back();
    free_.pop_back();
    corners_[t] = corners;
    neighbours_[t].fill(kNone);
  }
  for (const VertexId v : corners) at_[v.index()] = t;
  return t;
}

/// Makes two faces with the same corners neighbours; `g` may be on the box.
void Tetrahedra::join(Face f, Face g) {
  neighbours_[f.tetrahedron][static_cast<std::size_t>(f.k)] = g.tetrahedron;
  if (g.tetrahedron != kNone) neighbours_[g.tetrahedron][static_cast<std::size_t>(g.k)] = f.tetrahedron;
}

}  // namespace cnrg
