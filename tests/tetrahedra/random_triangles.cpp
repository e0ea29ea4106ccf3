#include "tests/tetrahedra/random_triangles.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "kernel/exact/predicates.h"

namespace cnrg {
namespace {

using Triangle = std::array<VertexId, 3>;

std::vector<VertexId> shared(const Triangle& p, const Triangle& q) {
  std::vector<VertexId> out;
  for (const VertexId v : p) {
    if (std::find(q.begin(), q.end(), v) != q.end()) out.push_back(v);
  }
  return out;
}

/// Surely they have no more in common than corners and sides: some plane parts them, with nothing else on it of
/// one.
bool apart(const PointTable& t, const Triangle& p, const Triangle& q) {
  const std::vector<VertexId> common = shared(p, q);
  std::vector<VertexId> all(p.begin(), p.end());
  for (const VertexId v : q) {
    if (std::find(p.begin(), p.end(), v) == p.end()) all.push_back(v);
  }
  const auto sides = [&](const Triangle& f, const Triangle& plane, int& all_of_it, bool& only_common) {
    for (const VertexId v : f) {
      const int s = orient3d(t, plane[0], plane[1], plane[2], v);
      if (s == 0) only_common = only_common && std::find(common.begin(), common.end(), v) != common.end();
      else if (s == -all_of_it) return false;
      else all_of_it = s;
    }
    return true;
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      for (std::size_t k = j + 1; k < all.size(); ++k) {
        const Triangle plane{all[i], all[j], all[k]};
        int of_p = 0, of_q = 0;
        bool p_common = true, q_common = true;
        if (sides(p, plane, of_p, p_common) && sides(q, plane, of_q, q_common) && of_p != of_q &&
            (p_common || q_common))
          return true;
      }
    }
  }
  return false;
}

/// Is a point in a closed triangle?
bool holds(const PointTable& t, const Triangle& f, VertexId v) {
  if (orient3d(t, f[0], f[1], f[2], v) != 0) return false;
  for (const Projection axes : {Projection{0, 1}, Projection{1, 2}, Projection{2, 0}}) {
    const int turn = orient2d(t, axes, f[0], f[1], f[2]);
    if (turn == 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      if (orient2d(t, axes, f[k], f[(k + 1) % 3], v) * turn < 0) return false;
    }
    return true;
  }
  return true;
}

}  // namespace

Constraints random_triangles(std::mt19937_64& random, PointTable& t) {
  const bool lattice = random() % 2 == 0;
  const std::uint64_t range = lattice ? 2 + random() % 5 : 1'000'000;
  std::set<std::array<double, 3>> used;
  const std::size_t count = 4 + random() % 30;
  for (int tries = 0; used.size() < count && tries < 1000; ++tries)
    used.insert({double(random() % range), double(random() % range), double(random() % range)});
  std::vector<std::array<double, 3>> points(used.begin(), used.end());
  std::shuffle(points.begin(), points.end(), random);
  for (const auto& p : points) t.add(p[0], p[1], p[2]);
  Constraints out;
  for (std::size_t tries = 100 + random() % 600; tries > 0; --tries) {
    Triangle f;
    for (VertexId& v : f) v = VertexId(random() % points.size());
    if (f[0] == f[1] || f[1] == f[2] || f[2] == f[0] || collinear(t, f[0], f[1], f[2])) continue;
    bool free = true;
    for (std::size_t i = 0; free && i < points.size(); ++i) {
      const VertexId v(i);
      free = std::find(f.begin(), f.end(), v) != f.end() || !holds(t, f, v);
    }
    for (const auto& facet : out.facets) free = free && apart(t, f, facet[0]);
    if (free) out.facets.push_back({f});
  }
  return out;
}

}  // namespace cnrg
