#include "csg/mesh/quads.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "kernel/base/limits.h"

namespace cnrg {
namespace {

using Index = FacetMesh::Index;

class Matching {
 public:
  Matching(std::size_t count, const std::vector<TrianglePair>& pairs, const Watch& watch)
      : pairs_(pairs), watch_(watch), taken_(count, kNone), visited_(count, 0), at_(count) {
    for (Index p = 0; p < pairs.size(); ++p) {
      at_[pairs[p].first].push_back(p);
      at_[pairs[p].second].push_back(p);
    }
  }

  std::vector<Index> run() {
    take_best();
    bool better = true;
    for (int sweep = 0; better && sweep < kSweeps; ++sweep) {
      better = false;
      for (Index t = 0; t < at_.size(); ++t) {
        if (t % 1024 == 0) watch_.check();
        while (improve(t)) better = true;
      }
    }
    std::vector<Index> result;
    for (Index p = 0; p < pairs_.size(); ++p)
      if (taken_[pairs_[p].first] == p) result.push_back(p);
    return result;
  }

 private:
  // Each improvement adds this at least, so that there is an end; sweeps are few in practice.
  static constexpr double kLeastGain = 1e-6;
  static constexpr int kSweeps = 100;
  const std::vector<TrianglePair>& pairs_;
  const Watch& watch_;
  std::vector<Index> taken_;  // of each triangle: its pair
  std::vector<char> visited_;
  std::vector<ShortList<Index, 4>> at_;  // of each triangle: pairs
  std::vector<Index> path_, best_;       // pairs to be taken, in turn
  double best_gain_ = 0;

  double weight(Index p) const { return 1 + pairs_[p].quality; }
  Index other(Index p, Index t) const { return pairs_[p].first == t ? pairs_[p].second : pairs_[p].first; }

  void take(Index p) { taken_[pairs_[p].first] = taken_[pairs_[p].second] = p; }
  void drop(Index p) { taken_[pairs_[p].first] = taken_[pairs_[p].second] = kNone; }

  void take_best() {
    std::vector<Index> order(pairs_.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](Index p, Index q) { return pairs_[p].quality > pairs_[q].quality; });
    for (const Index p : order)
      if (taken_[pairs_[p].first] == kNone && taken_[pairs_[p].second] == kNone) take(p);
  }

  /// From a triangle that is free by now: takes a pair, drops the one that was in its way, and so on.
  void search(Index t, double gain) {
    for (const Index p : at_[t]) {
      const Index u = other(p, t);
      const Index q = taken_[u];
      if (visited_[u] != 0 || p == taken_[t]) continue;
      path_.push_back(p);
      const double with = gain + weight(p) - (q == kNone || q == dropped_ ? 0 : weight(q));
      if (with > best_gain_) best_gain_ = with, best_ = path_;
      if (q != kNone && q != dropped_ && path_.size() < std::size_t(kPathPairs)) {
        const Index next = other(q, u);
        visited_[u] = visited_[next] = 1;
        search(next, with);
        visited_[u] = visited_[next] = 0;
      }
      path_.pop_back();
    }
  }
  Index dropped_ = kNone;  // the pair with which a path began

  /// True if a path from a triangle makes the sum greater; it is then taken.
  bool improve(Index t) {
    dropped_ = taken_[t];
    best_gain_ = kLeastGain;
    best_.clear();
    visited_[t] = 1;
    search(t, dropped_ == kNone ? 0 : -weight(dropped_));
    visited_[t] = 0;
    if (best_.empty()) return false;
    for (const Index p : best_) {
      for (const Index u : {pairs_[p].first, pairs_[p].second})
        if (taken_[u] != kNone) drop(taken_[u]);
    }
    for (const Index p : best_) take(p);
    return true;
  }
};

double angle(const DoubleVector& a, const DoubleVector& b, const DoubleVector& c) {
  const DoubleVector u = minus(a, b), v = minus(c, b), n = cross(u, v);
  return std::atan2(std::sqrt(dot(n, n)), dot(u, v));
}

}  // namespace

double quad_quality(const std::array<DoubleVector, 4>& corners) {
  constexpr double kRight = std::numbers::pi / 2;
  double worst = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double at = angle(corners[(k + 3) % 4], corners[k], corners[(k + 1) % 4]);
    worst = std::max(worst, std::abs(at - kRight));
  }
  return std::max(0.0, 1 - worst / kRight);
}

std::vector<std::uint32_t> match(std::size_t count, const std::vector<TrianglePair>& pairs, const Watch& watch) {
  return Matching(count, pairs, watch).run();
}

std::vector<MergedQuad> merge_triangles(const FacetMesh& mesh, const Watch& watch) {
  watch.begin("mesh: quadrilaterals");
  const auto& triangles = mesh.triangles();
  std::vector<TrianglePair> pairs;
  std::vector<MergedQuad> quads;
  for (Index t = 0; t < triangles.size(); ++t) {
    const auto& triangle = triangles[t];
    if (mesh.facets()[triangle.facet].fixed) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index u = triangle.next[k];
      if (u == kNone || u < t) continue;
      const Index b = triangle.points[(k + 1) % 3], c = triangle.points[(k + 2) % 3];
      Index opposite = kNone;
      for (const Index p : triangles[u].points)
        if (p != b && p != c) opposite = p;
      const std::array<Index, 4> corners{triangle.points[k], b, opposite, c};
      bool convex = true;
      std::array<DoubleVector, 4> at;
      for (std::size_t i = 0; i < 4; ++i) {
        at[i] = mesh.points()[corners[i]];
        convex = convex && mesh.turn(triangle.facet, corners[i], corners[(i + 1) % 4], corners[(i + 2) % 4]) > 0;
      }
      const double quality = quad_quality(at);
      if (!convex || quality < kLeastQuadQuality) continue;
      pairs.push_back({t, u, quality});
      quads.push_back({corners, {t, u}});
    }
  }
  std::vector<MergedQuad> result;
  for (const Index p : match(triangles.size(), pairs, watch)) result.push_back(quads[p]);
  return result;
}

}  // namespace cnrg
