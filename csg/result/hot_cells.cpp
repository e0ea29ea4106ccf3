#include "csg/result/hot_cells.h"

#include <algorithm>
#include <cmath>

#include "kernel/base/parallel.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"

namespace cnrg {
namespace {

using Xyz = HotCells::Xyz;
constexpr std::size_t kUnchecked = 1024;  // segments between two looks at the watch

std::vector<Xyz> centers_of(std::vector<Xyz> points, double size) {
  for (Xyz& p : points)
    for (double& c : p) c = std::nearbyint(c / size) * size + 0.0;  // no -0
  sort_unique(points);
  return points;
}

std::vector<Box> boxes_around(const std::vector<Xyz>& centers, double half) {
  std::vector<Box> boxes(centers.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      boxes[i].lo[k] = centers[i][k] - half;
      boxes[i].hi[k] = centers[i][k] + half;
    }
  }
  return boxes;
}

bool segment_meets(const Xyz& from, const Xyz& way, const Box& box) {
  double first = 0, last = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double lo = box.lo[k] - from[k], hi = box.hi[k] - from[k];
    if (way[k] == 0) {
      if (lo > 0 || hi < 0) return false;
      continue;
    }
    first = std::max(first, (way[k] > 0 ? lo : hi) / way[k]);
    last = std::min(last, (way[k] > 0 ? hi : lo) / way[k]);
  }
  return first <= last;
}

bool plane_meets(const Xyz& from, const Xyz& normal, const Box& box) {
  double height = 0, reach = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    height += normal[k] * ((box.lo[k] + box.hi[k]) / 2 - from[k]);
    reach += std::abs(normal[k]) * (box.hi[k] - box.lo[k]) / 2;
  }
  return std::abs(height) <= reach;
}

}  // namespace

HotCells::HotCells(const std::vector<Xyz>& points, double size)
    : size_(size), centers_(centers_of(points, size)), tree_(boxes_around(centers_, size / 2)) {}

std::optional<std::size_t> HotCells::cell_of(const Xyz& p) const {
  std::array<Xyz, 2> near;
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = p[k] / size_;
    near[0][k] = std::ceil(at - 0.5) * size_ + 0.0;
    near[1][k] = std::floor(at + 0.5) * size_ + 0.0;
  }
  for (unsigned i = 0; i < 8; ++i) {
    const Xyz center{near[i >> 2][0], near[i >> 1 & 1][1], near[i & 1][2]};
    const auto found = std::lower_bound(centers_.begin(), centers_.end(), center);
    if (found != centers_.end() && *found == center) return std::size_t(found - centers_.begin());
  }
  return {};
}

std::vector<HotCells::Pass> HotCells::along(const Xyz& a, const Xyz& b) const {
  std::vector<Pass> passes;
  const Xyz way = minus(b, a);
  const double squared = dot(way, way);
  tree_.query([&](const Box& box) { return segment_meets(a, way, box); },
              [&](std::uint32_t cell) {
                const double t = dot(minus(centers_[cell], a), way) / squared;
                if (0 < t && t < 1) passes.push_back({cell, t, {}});
              });
  std::sort(passes.begin(), passes.end(), [](const Pass& p, const Pass& q) { return p.along < q.along; });
  passes.erase(
      std::unique(passes.begin(), passes.end(), [](const Pass& p, const Pass& q) { return p.along == q.along; }),
      passes.end());
  return passes;
}

std::vector<HotCells::Pass> HotCells::across(const Xyz& a, const Xyz& b, const Xyz& c) const {
  std::vector<Pass> passes;
  const Xyz normal = cross(minus(b, a), minus(c, a));
  const double squared = dot(normal, normal);
  if (!(squared > 0)) return passes;
  Box around;
  for (const Xyz& p : {a, b, c}) around.extend(p, p);
  tree_.query([&](const Box& box) { return box.meets(around) && plane_meets(a, normal, box); },
              [&](std::uint32_t cell) {
                const double height = dot(minus(centers_[cell], a), normal) / squared;
                Xyz foot = centers_[cell];
                for (std::size_t k = 0; k < 3; ++k) foot[k] -= height * normal[k];
                passes.push_back({cell, 0, foot});
              });
  std::sort(passes.begin(), passes.end(), [](const Pass& p, const Pass& q) { return p.cell < q.cell; });
  return passes;
}

std::vector<Xyz> where_near(const std::vector<std::array<Xyz, 2>>& segments, double within, const Watch& watch) {
  std::vector<Box> boxes(segments.size());
  for (std::size_t s = 0; s < segments.size(); ++s) {
    for (const Xyz& p : segments[s]) boxes[s].extend(p, p);
    for (std::size_t k = 0; k < 3; ++k) boxes[s].lo[k] -= within, boxes[s].hi[k] += within;
  }
  const BoxTree tree(boxes);
  std::vector<std::vector<Xyz>> found(segments.size());
  for_each_index(segments.size(), [&](std::size_t s) {
    if (s % kUnchecked == 0) watch.check();
    const auto& [a, b] = segments[s];
    const Xyz p = minus(b, a);
    tree.query([&](const Box& box) { return segment_meets(a, p, box); },
               [&](std::uint32_t t) {
                 if (t <= s) return;
                 const auto& [c, d] = segments[t];
                 if (a == c || a == d || b == c || b == d) return;
                 const Xyz q = minus(d, c), r = minus(a, c);
                 const double pp = dot(p, p), qq = dot(q, q), pq = dot(p, q), pr = dot(p, r), qr = dot(q, r);
                 const double area = pp * qq - pq * pq;
                 if (area <= within * within * std::max(pp, qq)) return;  // an end is as near
                 const double x = (pq * qr - qq * pr) / area, y = (pp * qr - pq * pr) / area;
                 if (!(0 < x && x < 1 && 0 < y && y < 1)) return;
                 Xyz middle, apart;
                 for (std::size_t k = 0; k < 3; ++k) {
                   const double on_s = a[k] + x * p[k], on_t = c[k] + y * q[k];
                   middle[k] = (on_s + on_t) / 2, apart[k] = on_s - on_t;
                 }
                 if (dot(apart, apart) <= within * within) found[s].push_back(middle);
               });
  });
  std::vector<Xyz> all;
  for (const auto& list : found) all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace cnrg
