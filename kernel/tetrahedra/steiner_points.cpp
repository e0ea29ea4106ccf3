#include "kernel/tetrahedra/steiner_points.h"

#include <algorithm>
#include <sstream>

#include "kernel/base/sorted.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/predicates.h"
#include "kernel/refine/input.h"

namespace cnrg {
namespace {

/// Of the way to a vertex, the smallest part that is tried.
constexpr int kFurther = 64;
/// Flips of one star: each makes those that are turned fewer, but for what goes beside an edge.
constexpr int kFlips = 1000;

std::string too_thin(const std::array<double, 3>& p) {
  std::ostringstream text;
  text.precision(9);
  text << "tetrahedra are too thin for doubles near (" << p[0] << " " << p[1] << " " << p[2]
       << "); join what nearly touches there by --join or `weld`, or move it apart";
  return text.str();
}

}  // namespace

SteinerPoints::SteinerPoints(PointTable& points, Tetrahedra& tetrahedra, ConstrainedTetrahedra& made,
                             std::span<const std::array<VertexId, 2>> pieces, std::vector<VertexId> open,
                             Ways ways)
    : points_(points),
      tetrahedra_(tetrahedra),
      made_(made),
      open_(std::move(open)),
      ways_(std::move(ways)),
      flips_(points, tetrahedra),
      room_(points, tetrahedra) {
  if (open_.empty()) return;  // nothing will move
  for (const auto& [a, b] : pieces) bind(a, b);
  for (const auto& triangle : made_.triangles) bind(triangle.corners);
}

/// Does it help at least one of the points?
bool SteinerPoints::some(bool (SteinerPoints::*way)(VertexId), const Watch& watch) {
  const auto done = [&](VertexId v) {
    watch.check();
    return (this->*way)(v);
  };
  return std::erase_if(open_, done) > 0;
}

void SteinerPoints::reduce(const Watch& watch) {
  watch.begin("tetrahedra: fewer points");
  while (some(&SteinerPoints::pull<Flips::Deep::no>, watch)) {
  }
  follow();
}

void SteinerPoints::move_to_doubles(const Watch& watch) {
  watch.begin("tetrahedra: doubles");
  while (!open_.empty()) {
    if (some(&SteinerPoints::move_near, watch) || some(&SteinerPoints::move_far, watch) ||
        some(&SteinerPoints::move_by_flips, watch) || some(&SteinerPoints::pull<Flips::Deep::yes>, watch))
      continue;
    throw NearFault(too_thin(points_.approx(open_[0])));
  }
  follow();
}

/// The vertex of `made` that is here now.
VertexId SteinerPoints::first(VertexId v) const {
  const auto at = origin_.find(v);
  return at == origin_.end() ? v : at->second;
}

/// Is it an edge of a segment, or a face of a facet?
bool SteinerPoints::is_bound(std::span<const VertexId> corners) const {
  if (corners.size() == 2) return edges_.contains(RefineInput::key(first(corners[0]), first(corners[1])));
  return faces_.contains(sorted(std::array{first(corners[0]), first(corners[1]), first(corners[2])}));
}

/// Is an edge in no segment and no face of a facet?
bool SteinerPoints::may_go(VertexId a, VertexId b) const {
  return !sides_.contains(RefineInput::key(first(a), first(b)));
}

void SteinerPoints::bind(std::array<VertexId, 3> face) {
  for (std::size_t k = 0; k < 3; ++k) sides_.insert(RefineInput::key(face[k], face[(k + 1) % 3]));
  faces_.insert(sorted(face));
}

void SteinerPoints::bind(VertexId a, VertexId b) {
  sides_.insert(RefineInput::key(a, b));
  edges_.insert(RefineInput::key(a, b));
}

void SteinerPoints::move(VertexId v, VertexId w) {
  if (v == w) return;
  tetrahedra_.rename(v, w);
  moved_.emplace(v, w);
  origin_.emplace(w, v);
}

bool SteinerPoints::move_near(VertexId v) {
  const VertexId w = room_.near_double(v);
  if (w.valid()) move(v, w);
  return w.valid();
}

bool SteinerPoints::move_far(VertexId v) {
  const VertexId w = room_.far_double(v, ways_(v));
  if (w.valid()) move(v, w);
  return w.valid();
}

/// To the nearest double, or one beside it, or to one further on the way to a vertex next to it.
bool SteinerPoints::move_by_flips(VertexId v) {
  const auto move_to = [&](const std::array<double, 3>& p) {
    const VertexId w = points_.add(p[0], p[1], p[2]);
    if (!make_room(v, w, Flips::Deep::yes)) return false;
    move(v, w);
    return true;
  };
  for (const auto& p : with_neighbours(points_.nearest(v))) {
    if (move_to(p)) return true;
  }
  const RationalPoint at = points_.rational(v);
  for (const VertexId u : neighbours_on_carrier(v)) {
    const RationalPoint way = points_.rational(u) - at;
    for (int parts = 2; parts <= kFurther; parts *= 2) {
      if (move_to(to_doubles(at + Rational(1, parts) * way))) return true;
    }
  }
  return false;
}

/// Flips away what would be turned if v were at w, which is another place or a vertex that it shares an edge with.
/// Other tetrahedra may be flipped even where some of these stay.
bool SteinerPoints::make_room(VertexId v, VertexId w, Flips::Deep deep) {
  const auto turned = [&](std::span<const VertexId> part) {
    if (part.size() != 4) return false;
    Tetrahedra::Corners t;
    std::copy(part.begin(), part.end(), t.begin());
    const auto at = std::find(t.begin(), t.end(), v);
    if (at == t.end() || std::find(t.begin(), t.end(), w) != t.end()) return false;
    *at = w;
    return orient3d(points_, t[0], t[1], t[2], t[3]) <= 0;
  };
  const auto may_go = [&](VertexId a, VertexId b) { return this->may_go(a, b); };
  const auto flip = [&](Index t) {
    const Tetrahedra::Corners corners = tetrahedra_.corners(t);
    if (!tetrahedra_.alive(t) || !turned(corners)) return false;  // what was tried before has changed it
    for (int k = 0; k < 4; ++k) {
      if (!is_bound(tetrahedra_.face({t, k})) && flips_.remove_face({t, k}, turned)) return true;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (flips_.remove_edge(corners[i], corners[j], turned, may_go, deep)) return true;
        if (!tetrahedra_.alive(t) || tetrahedra_.corners(t) != corners) return true;
      }
    }
    return false;
  };
  for (int n = 0; n < kFlips; ++n) {
    tetrahedra_.around(v, star_);
    std::erase_if(star_, [&](Index t) { return !turned(tetrahedra_.corners(t)); });
    if (star_.empty()) return true;
    if (std::none_of(star_.begin(), star_.end(), flip)) return false;
  }
  return false;
}

/// The vertices next to it in its segment or, where it is in none, in its facet.
std::vector<VertexId> SteinerPoints::neighbours_on_carrier(VertexId v) {
  std::vector<VertexId> along, beside;
  const auto add = [](std::vector<VertexId>& list, VertexId u) {
    if (std::find(list.begin(), list.end(), u) == list.end()) list.push_back(u);
  };
  tetrahedra_.around(v, star_);
  for (const Index t : star_) {
    const auto& corners = tetrahedra_.corners(t);
    for (const VertexId u : corners) {
      if (u == v) continue;
      if (is_bound(std::array{v, u})) add(along, u);
      for (const VertexId q : corners) {
        if (q != v && q != u && is_bound(std::array{v, u, q})) add(beside, u);
      }
    }
  }
  return along.empty() ? beside : along;
}

template <Flips::Deep deep>
bool SteinerPoints::pull(VertexId v) {
  for (const VertexId u : neighbours_on_carrier(v)) {
    if (!make_room(v, u, deep)) continue;
    tetrahedra_.around(v, star_);
    const VertexId by = first(u);
    for (const Index t : star_) {
      for (int k = 0; k < 4; ++k) {
        auto f = tetrahedra_.face({t, k});
        if (std::find(f.begin(), f.end(), v) == f.end() || !is_bound(f)) continue;
        for (VertexId& p : f) p = p == v ? by : first(p);
        bind(f);
      }
      for (const VertexId p : tetrahedra_.corners(t)) {
        if (p != v && is_bound(std::array{v, p})) bind(by, first(p));
      }
    }
    tetrahedra_.fill(u, star_);
    moved_.emplace(v, u);
    return true;
  }
  return false;
}

/// The constraints by the vertices that are now; a piece of which the ends are one now is no more.
void SteinerPoints::follow() {
  const auto last = [&](VertexId v) {
    for (auto at = moved_.find(v); at != moved_.end(); at = moved_.find(v)) v = at->second;
    return v;
  };
  for (auto& segment : made_.segments) {
    for (VertexId& v : segment.ends) v = last(v);
  }
  std::erase_if(made_.segments, [](const auto& segment) { return segment.ends[0] == segment.ends[1]; });
  for (auto& triangle : made_.triangles) {
    for (VertexId& v : triangle.corners) v = last(v);
  }
  std::erase_if(made_.triangles, [](const auto& triangle) {
    const auto& [a, b, c] = triangle.corners;
    return a == b || b == c || c == a;
  });
}

}  // namespace cnrg
