#include "csg/result/hot_cells.h"

#include <algorithm>
#include <cmath>

#include "kernel/base/parallel.h"
#include "kernel/base/vectors.h"

namespace cnrg {
namespace {

using Xyz = HotCells::Xyz;
constexpr std::size_t kUncheckedSegments = 1024;  // segments between two looks at the watch

/// The cube of a grid that a point lies in.
Xyz cube_of(const Xyz& p, double size) {
  return {std::floor(p[0] / size), std::floor(p[1] / size), std::floor(p[2] / size)};
}

double largest_difference(const Xyz& p, const Xyz& q) {
  return std::max({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])});
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
    : size_(size), tree_(boxes_around(choose_centers(points), size * kPass)) {}

const std::vector<Xyz>& HotCells::choose_centers(const std::vector<Xyz>& points) {
  for (const Xyz& p : points) {
    if (cell_of(p)) continue;
    in_cube_[cube_of(p, size_)].push_back(std::uint32_t(centers_.size()));
    centers_.push_back(p);
  }
  return centers_;
}

std::optional<std::size_t> HotCells::cell_of(const Xyz& p) const {
  std::optional<std::size_t> nearest;
  const double half = size_ / 2;
  double least = half;
  const Xyz first = cube_of({p[0] - half, p[1] - half, p[2] - half}, size_);
  const Xyz last = cube_of({p[0] + half, p[1] + half, p[2] + half}, size_);
  for (unsigned i = 0; i < 8; ++i) {  // the centers of all cells with the point lie in these cubes
    const Xyz cube{(i & 1 ? last : first)[0], (i & 2 ? last : first)[1], (i & 4 ? last : first)[2]};
    const auto found = in_cube_.find(cube);
    if (found == in_cube_.end()) continue;
    for (const std::uint32_t cell : found->second) {
      const double distance = largest_difference(p, centers_[cell]);
      if (distance > least || (distance == least && nearest && *nearest < cell)) continue;
      nearest = cell, least = distance;
    }
  }
  return nearest;
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
  const Xyz normal = accurate_cross(minus(b, a), minus(c, a));
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
    if (s % kUncheckedSegments == 0) watch.check();
    const Xyz &a = segments[s][0], &b = segments[s][1];
    const Xyz p = minus(b, a);
    tree.query([&](const Box& box) { return segment_meets(a, p, box); },
               [&](std::uint32_t t) {
                 if (t <= s) return;
                 const auto& [c, d] = segments[t];
                 if (a == c || a == d || b == c || b == d) return;
                 const Xyz q = minus(d, c), r = minus(a, c);
                 const Xyz normal = accurate_cross(p, q);
                 const double area = dot(normal, normal);
                 if (area <= within * within * std::max(dot(p, p), dot(q, q))) return;  // an end is as near
                 const double x = -dot(accurate_cross(r, q), normal) / area;
                 const double y = -dot(accurate_cross(r, p), normal) / area;
                 if (!(0 < x && x < 1 && 0 < y && y < 1)) return;
                 const double apart = dot(r, normal) / area;  // in lengths of the normal
                 if (apart * apart * area > within * within) return;
                 Xyz& middle = found[s].emplace_back();
                 for (std::size_t k = 0; k < 3; ++k) middle[k] = a[k] + x * p[k] - apart / 2 * normal[k];
               });
  });
  std::vector<Xyz> all;
  for (const auto& list : found) all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace cnrg
