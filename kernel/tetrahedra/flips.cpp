#include "kernel/tetrahedra/flips.h"

#include <algorithm>
#include <limits>

#include "kernel/exact/predicates.h"

namespace cnrg {
namespace {

/// Of longer rings few triangulations are positive, and all have to be looked at.
constexpr std::size_t kLongestFlip = 12;
constexpr int kNever = std::numeric_limits<int>::max() / 4;

/// The corners of a tetrahedron other than a and b, so that a, b and they are turned as it is.
std::array<VertexId, 2> others(const Tetrahedra::Corners& corners, VertexId a, VertexId b) {
  std::array<std::size_t, 4> order{4, 4, 4, 4};
  std::size_t n = 2;
  for (std::size_t k = 0; k < 4; ++k) order[corners[k] == a ? 0 : corners[k] == b ? 1 : n++] = k;
  int inversions = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) inversions += order[i] > order[j];
  }
  if (inversions % 2 != 0) std::swap(order[2], order[3]);
  return {corners[order[2]], corners[order[3]]};
}

}  // namespace

/// To `hole_` the tetrahedra at an edge, to `ring_` what is around it: false where they are too many, or the edge
/// is on the box.
bool Flips::find_ring(VertexId a, VertexId b) {
  ring_.clear();
  tetrahedra_.around(a, b, hole_);
  if (hole_.size() < 3 || hole_.size() > kLongestFlip) return false;
  std::array<std::array<VertexId, 2>, kLongestFlip> sides;
  for (std::size_t i = 0; i < hole_.size(); ++i) sides[i] = others(tetrahedra_.corners(hole_[i]), a, b);
  ring_.push_back(sides[0][0]);
  VertexId next = sides[0][1];
  while (next != ring_[0]) {
    ring_.push_back(next);
    const auto end = sides.begin() + static_cast<std::ptrdiff_t>(hole_.size());
    const auto at = std::find_if(sides.begin(), end, [&](const auto& side) { return side[0] == next; });
    if (at == end) return false;
    next = (*at)[1];
  }
  return ring_.size() == hole_.size();
}

bool Flips::remove_edge(VertexId a, VertexId b, const InTheWay& in_the_way, const MayGo& may_go, Deep deep) {
  if (!may_go(a, b)) return false;
  if (remove(a, b, in_the_way, 0)) return true;
  if (deep == Deep::no) return false;
  for (const VertexId v : std::vector(ring_)) {
    for (const VertexId u : {a, b}) {
      if (may_go(u, v) && remove(u, v, in_the_way, 1) && remove(a, b, in_the_way, 0)) return true;
    }
  }
  return false;
}

/// `more`: so many more may be in the way than were.
bool Flips::remove(VertexId a, VertexId b, const InTheWay& in_the_way, int more) {
  if (!find_ring(a, b)) return false;
  const std::size_t n = ring_.size();
  int before = more + in_the_way(std::array{a, b});
  for (const VertexId v : ring_) before += in_the_way(std::array{a, b, v});
  for (const Index t : hole_) before += in_the_way(tetrahedra_.corners(t));
  // The triangulation of the ring with the least in the way: of what is between i and j by that of parts of it.
  int least[kLongestFlip][kLongestFlip];
  std::size_t by[kLongestFlip][kLongestFlip];
  for (std::size_t i = 0; i + 1 < n; ++i) least[i][i + 1] = 0;
  for (std::size_t length = 2; length < n; ++length) {
    for (std::size_t i = 0; i + length < n; ++i) {
      const std::size_t j = i + length;
      const VertexId p = ring_[i], q = ring_[j];
      int& best = least[i][j] = kNever;
      for (std::size_t k = i + 1; k < j; ++k) {
        int cost = least[i][k] + least[k][j];
        if (cost >= std::min(best, before)) continue;
        const VertexId r = ring_[k];
        cost += in_the_way(std::array{p, r, q}) + in_the_way(std::array{a, p, r, q}) +
                in_the_way(std::array{b, p, q, r});
        if (cost >= std::min(best, before) || orient3d(points_, a, p, r, q) <= 0 ||
            orient3d(points_, b, p, q, r) <= 0)
          continue;
        best = cost, by[i][j] = k;
      }
      if (best < before && length + 1 < n) {
        best += in_the_way(std::array{p, q}) + in_the_way(std::array{a, p, q}) + in_the_way(std::array{b, p, q});
      }
    }
  }
  if (least[0][n - 1] >= before) return false;
  fresh_.clear();
  std::vector<std::array<std::size_t, 2>> open{{0, n - 1}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j == i + 1) continue;
    const std::size_t k = by[i][j];
    fresh_.push_back({a, ring_[i], ring_[k], ring_[j]});
    fresh_.push_back({b, ring_[i], ring_[j], ring_[k]});
    open.push_back({i, k});
    open.push_back({k, j});
  }
  tetrahedra_.replace(hole_, fresh_);
  return true;
}

bool Flips::remove_face(Tetrahedra::Face face, const InTheWay& in_the_way) {
  const Index u = tetrahedra_.neighbour(face.tetrahedron, face.k);
  if (u == Tetrahedra::kNone) return false;
  const auto f = tetrahedra_.face(face);
  const VertexId d = tetrahedra_.corners(face.tetrahedron)[static_cast<std::size_t>(face.k)];
  const auto& across = tetrahedra_.corners(u);
  const VertexId e = *std::find_if(across.begin(), across.end(),
                                   [&](VertexId v) { return std::find(f.begin(), f.end(), v) == f.end(); });
  fresh_.clear();
  int after = in_the_way(std::array{d, e});
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId p = f[k], q = f[(k + 1) % 3];
    if (orient3d(points_, e, d, p, q) <= 0) return false;
    after += in_the_way(std::array{d, e, p}) + in_the_way(std::array{e, d, p, q});
    fresh_.push_back({e, d, p, q});
  }
  const int before = in_the_way(f) + in_the_way(tetrahedra_.corners(face.tetrahedron)) + in_the_way(across);
  if (after >= before) return false;
  hole_ = {face.tetrahedron, u};
  tetrahedra_.replace(hole_, fresh_);
  return true;
}

}  // namespace cnrg
