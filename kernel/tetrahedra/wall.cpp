#include "kernel/tetrahedra/wall.h"

#include <algorithm>
#include <unordered_set>

#include "kernel/base/sorted.h"
#include "kernel/exact/predicates.h"

namespace cnrg {
namespace {

/// From so many triangles on a facet has a tree of their boxes.
constexpr std::size_t kMany = 32;

}  // namespace

Wall::Wall(const PointTable& points, const Tetrahedra& tetrahedra, std::span<const Triangle> facet,
           std::vector<Ends> border, std::span<const VertexId> inside)
    : points_(points), tetrahedra_(tetrahedra), facet_(facet), border_(std::move(border)) {
  corners_.assign(inside.begin(), inside.end());
  for (const Triangle& t : facet_) corners_.insert(corners_.end(), t.begin(), t.end());
  for (const Ends& ends : border_) corners_.push_back(ends[0]);
  sort_unique(corners_);
  std::sort(border_.begin(), border_.end());
  for (const VertexId v : corners_) side_[v] = 0;
}

int Wall::side(VertexId v) const {
  const auto [it, fresh] = side_.try_emplace(v, 0);
  if (fresh) it->second = orient3d(points_, facet_[0][0], facet_[0][1], facet_[0][2], v);
  return it->second;
}

std::vector<Wall::Triangle> Wall::faces() const {
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
  return within_border(all);
}

/// From the faces at the border to those that share with them a side that is none of it.
std::vector<Wall::Triangle> Wall::within_border(const std::vector<Triangle>& faces) const {
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

std::vector<Wall::Ends> Wall::edges_through() {
  std::unordered_set<Index> known;
  std::vector<Index> star, all;
  const auto take = [&](Index t) {
    if (known.insert(t).second && pierced(t)) all.push_back(t);
  };
  for (const VertexId v : corners_) {
    tetrahedra_.around(v, star);
    for (const Index t : star) take(t);
  }
  std::vector<Ends> out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (int k = 0; k < 4; ++k) {
      const Index u = tetrahedra_.neighbour(all[i], k);
      if (u != Tetrahedra::kNone) take(u);
    }
    for (const VertexId a : tetrahedra_.corners(all[i])) {
      for (const VertexId b : tetrahedra_.corners(all[i])) {
        if (side(a) < 0 && side(b) > 0) out.push_back({a, b});
      }
    }
  }
  sort_unique(out);
  return out;
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
  return above.valid() && below.valid() && is_crossed(below, above);
}

bool Wall::is_crossed(VertexId below, VertexId above) {
  if (side(below) > side(above)) std::swap(below, above);
  if (side(below) >= 0 || side(above) <= 0) return false;
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

}  // namespace cnrg
