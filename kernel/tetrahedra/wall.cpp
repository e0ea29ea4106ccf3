#include "kernel/tetrahedra/wall.h"

#include <algorithm>
#include <set>

#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/in_sphere.h"
#include "kernel/exact/predicates.h"

namespace cnrg {
namespace {

/// From so many triangles on a facet has a tree of their boxes.
constexpr std::size_t kMany = 32;

template <class Corners>
Corners sorted(Corners corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// The corners of both, each once.
template <class Corners, class Others>
std::vector<VertexId> united(const Corners& p, const Others& q) {
  std::vector<VertexId> out(p.begin(), p.end());
  for (const VertexId v : q) {
    if (std::find(p.begin(), p.end(), v) == p.end()) out.push_back(v);
  }
  return out;
}

/// Does a plane or line with these sides have one on each side, not both on it? Then the corners on it.
template <class Corners, class Others, class Side>
bool part(const Corners& p, const Others& q, const Side& side, std::vector<VertexId>& in_p,
          std::vector<VertexId>& in_q) {
  const auto side_of = [&](const auto& corners, std::vector<VertexId>& in, int& all) {
    for (const VertexId v : corners) {
      const int s = side(v);
      if (s == 0) in.push_back(v);
      else if (s == -all) return false;
      else all = s;
    }
    return true;
  };
  int of_p = 0, of_q = 0;
  return side_of(p, in_p, of_p) && side_of(q, in_q, of_q) && of_p != of_q;
}

}  // namespace

Wall::Wall(const PointTable& points, Tetrahedra& tetrahedra, std::span<const Triangle> facet,
           std::vector<Ends> border)
    : points_(points), tetrahedra_(tetrahedra), facet_(facet), border_(std::move(border)) {
  for (const Triangle& t : facet_) corners_.insert(corners_.end(), t.begin(), t.end());
  for (const Ends& ends : border_) corners_.push_back(ends[0]);
  sort_unique(corners_);
  std::sort(border_.begin(), border_.end());
  for (const VertexId v : corners_) side_[v] = 0;
}

int Wall::side(VertexId v) {
  const auto [it, fresh] = side_.try_emplace(v, 0);
  if (fresh) it->second = orient3d(points_, facet_[0][0], facet_[0][1], facet_[0][2], v);
  return it->second;
}

std::vector<Wall::Triangle> Wall::faces(std::size_t count) {
  std::vector<Triangle> found = find();
  if (found.size() < count) {
    clear_the_way();
    found = find();
  }
  require(found.size() == count, "tetrahedra: a facet is not made of faces");
  return found;
}

/// The faces with three corners of the facet, inside of its border.
std::vector<Wall::Triangle> Wall::find() {
  std::vector<Triangle> all;
  std::vector<Index> star;
  for (const VertexId v : corners_) {
    tetrahedra_.around(v, star);
    for (const Index t : star) {
      for (int k = 0; k < 4; ++k) {
        Triangle f = tetrahedra_.face({t, k});
        const bool in = std::all_of(f.begin(), f.end(), [&](VertexId p) {
          return std::binary_search(corners_.begin(), corners_.end(), p);
        });
        if (!in) continue;
        if (side(tetrahedra_.corners(t)[static_cast<std::size_t>(k)]) < 0) std::swap(f[1], f[2]);
        std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
        all.push_back(f);
      }
    }
  }
  sort_unique(all);
  return inside(all);
}

/// From the faces at the border to those that share with them a side that is none of it.
std::vector<Wall::Triangle> Wall::inside(const std::vector<Triangle>& faces) const {
  std::vector<std::pair<Ends, std::size_t>> sides;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) sides.push_back({{faces[i][k], faces[i][(k + 1) % 3]}, i});
  }
  std::sort(sides.begin(), sides.end());
  std::vector<char> seen(faces.size(), 0);
  std::vector<Triangle> out;
  const auto take = [&](const Ends& side) {
    const auto at = std::lower_bound(sides.begin(), sides.end(), std::pair(side, std::size_t{0}));
    if (at == sides.end() || at->first != side || seen[at->second]) return;
    seen[at->second] = 1;
    out.push_back(faces[at->second]);
  };
  for (const Ends& side : border_) take(side);
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId a = out[i][k], b = out[i][(k + 1) % 3];
      if (!std::binary_search(border_.begin(), border_.end(), Ends{a, b})) take({b, a});
    }
  }
  return out;
}

/// Takes all tetrahedra away that the facet passes through. Holes that share no face are filled one by one.
void Wall::clear_the_way() {
  std::set<Index> passed;
  std::vector<Index> star, all;
  for (const VertexId v : corners_) {
    tetrahedra_.around(v, star);
    for (const Index t : star) {
      if (!passed.contains(t) && pierced(t)) all.push_back(*passed.insert(t).first);
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (int k = 0; k < 4; ++k) {
      const Index u = tetrahedra_.neighbour(all[i], k);
      if (u != Tetrahedra::kNone && !passed.contains(u) && pierced(u)) all.push_back(*passed.insert(u).first);
    }
  }
  while (!passed.empty()) {
    std::vector<Index> hole{*passed.begin()};
    passed.erase(passed.begin());
    for (std::size_t i = 0; i < hole.size(); ++i) {
      for (int k = 0; k < 4; ++k) {
        const auto found = passed.find(tetrahedra_.neighbour(hole[i], k));
        if (found == passed.end()) continue;
        hole.push_back(*found);
        passed.erase(found);
      }
    }
    fill(hole);
  }
}

/// Does the facet pass through the inside of a tetrahedron? Its border is made of edges, so where the plane cuts
/// the tetrahedron, all of the cut is in the facet or nothing of it: any edge across the plane tells.
bool Wall::pierced(Index t) {
  VertexId above, below;
  for (const VertexId v : tetrahedra_.corners(t)) {
    const int s = side(v);
    if (s > 0) above = v;
    if (s < 0) below = v;
  }
  if (!above.valid() || !below.valid()) return false;
  const auto through = [&](const Triangle& f) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (orient3d(points_, below, above, f[k], f[(k + 1) % 3]) < 0) return false;
    }
    return true;
  };
  if (facet_.size() < kMany) return std::any_of(facet_.begin(), facet_.end(), through);
  const auto box_of = [&](std::span<const VertexId> corners) {
    Box box;
    for (const VertexId v : corners) {
      const PointView p = points_.view(v);
      box.extend(p.lo, p.hi);
    }
    return box;
  };
  if (!boxes_) {
    std::vector<Box> boxes;
    for (const Triangle& f : facet_) boxes.push_back(box_of(f));
    boxes_.emplace(std::move(boxes));
  }
  const Box edge = box_of(std::array{above, below});
  bool found = false;
  boxes_->query([&](const Box& box) { return !found && box.meets(edge); },
                [&](std::uint32_t i) { found = found || through(facet_[i]); });
  return found;
}

void Wall::fill(std::span<const Index> hole) {
  Open above, below;
  std::set<VertexId> corners;
  const std::set<Index> inside(hole.begin(), hole.end());
  for (const Index t : hole) {
    for (const VertexId v : tetrahedra_.corners(t)) corners.insert(v);
    for (int k = 0; k < 4; ++k) {
      if (inside.contains(tetrahedra_.neighbour(t, k))) continue;
      const Triangle f = tetrahedra_.face({t, k});
      const bool up = std::any_of(f.begin(), f.end(), [&](VertexId v) { return side(v) > 0; });
      (up ? above : below).emplace(sorted(f), OpenFace{f, tetrahedra_.opposite({t, k})});
    }
  }
  tetrahedra_.remove(hole);
  std::vector<VertexId> up, down;
  for (const VertexId v : corners) {
    if (side(v) >= 0) up.push_back(v);
    if (side(v) <= 0) down.push_back(v);
  }
  Open floor;
  wrap(above, up, &floor);
  below.merge(floor);
  require(floor.empty(), "tetrahedra: a face twice");
  wrap(below, down, nullptr);
}

/// Fills one half of a hole. Faces in the plane of the triangle go to `floor`, unless they are to be filled, too.
void Wall::wrap(Open& open, const std::vector<VertexId>& corners, Open* floor) {
  while (!open.empty()) {
    const auto base = open.extract(open.begin());
    const auto& [a, b, c] = base.mapped().corners;
    if (floor != nullptr && side(a) == 0 && side(b) == 0 && side(c) == 0) {
      floor->emplace(base.key(), base.mapped());
      continue;
    }
    const VertexId d = apex(base.mapped().corners, open, corners);
    const Index t = tetrahedra_.add({a, b, c, d});
    tetrahedra_.join({t, 3}, base.mapped().outside);
    for (int k = 0; k < 3; ++k) {
      const auto [p, q, r] = tetrahedra_.face({t, k});
      const auto [at, fresh] = open.try_emplace(sorted(Triangle{p, q, r}), OpenFace{{p, r, q}, {t, k}});
      if (fresh) continue;
      tetrahedra_.join({t, k}, at->second.outside);
      open.erase(at);
    }
  }
}

/// Of the corners that the whole base sees the one with no other of them in its sphere.
VertexId Wall::apex(const Triangle& base, const Open& open, const std::vector<VertexId>& corners) const {
  const auto& [a, b, c] = base;
  VertexId best;
  for (const VertexId v : corners) {
    if (v == a || v == b || v == c || orient3d(points_, a, b, c, v) <= 0) continue;
    if (best.valid() && in_sphere_perturbed(points_, a, b, c, best, v) <= 0) continue;
    const Tetrahedra::Corners t{a, b, c, v};
    const bool free =
        std::none_of(open.begin(), open.end(), [&](const auto& face) { return overlap(t, face.first); });
    if (free) best = v;
  }
  require(best.valid(), "tetrahedra: a hole that no tetrahedra fill");
  return best;
}

/// Do a tetrahedron and a triangle have more in common than common corners span? If not, some plane parts them,
/// and then one through corners of both: of a face of one of them, or of an edge of one and a corner of the other.
/// What they have in common is in that plane.
bool Wall::overlap(const Tetrahedra::Corners& t, const Triangle& face) const {
  const std::vector<VertexId> corners = united(t, face);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      for (std::size_t k = j + 1; k < corners.size(); ++k) {
        const VertexId a = corners[i], b = corners[j], c = corners[k];
        std::vector<VertexId> in_t, in_face;
        const auto side = [&](VertexId v) {
          return v == a || v == b || v == c ? 0 : orient3d(points_, a, b, c, v);
        };
        if (!part(t, face, side, in_t, in_face)) continue;
        const auto off = std::find_if(t.begin(), t.end(), [&](VertexId v) { return side(v) != 0; });
        return overlap_in_plane(in_t, in_face, *off);
      }
    }
  }
  return true;
}

/// The same of corners in one plane, which does not pass through `off`.
bool Wall::overlap_in_plane(const std::vector<VertexId>& p, const std::vector<VertexId>& q, VertexId off) const {
  const std::vector<VertexId> corners = united(p, q);
  if (corners.size() == std::max(p.size(), q.size()) || corners.size() <= 3) return false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      const VertexId a = corners[i], b = corners[j];
      std::vector<VertexId> in_p, in_q;
      const auto side = [&](VertexId v) { return v == a || v == b ? 0 : orient3d(points_, a, b, off, v); };
      if (part(p, q, side, in_p, in_q)) return overlap_on_line(in_p, in_q);
    }
  }
  return true;
}

bool Wall::overlap_on_line(std::vector<VertexId> p, std::vector<VertexId> q) const {
  if (p.empty() || q.empty()) return false;
  const auto before = [&](VertexId a, VertexId b) { return compare_lex(points_, a, b) < 0; };
  std::sort(p.begin(), p.end(), before), std::sort(q.begin(), q.end(), before);
  if (p == q) return false;
  const VertexId low = before(p.front(), q.front()) ? q.front() : p.front();
  const VertexId high = before(p.back(), q.back()) ? p.back() : q.back();
  if (before(high, low)) return false;
  const auto has = [](const std::vector<VertexId>& list, VertexId v) {
    return std::find(list.begin(), list.end(), v) != list.end();
  };
  // One point in common, which is a corner of both, or a corner inside of the other one's segment.
  return !(low == high && has(p, low) && has(q, low));
}

}  // namespace cnrg
