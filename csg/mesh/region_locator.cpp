#include "csg/mesh/region_locator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/base/limits.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;
using Vector = RegionLocator::Vector;

constexpr Vector kAlong{0.53119, 0.37943, 0.75751};

struct LocatedTriangle {
  std::array<Vector, 3> at;
  Index face, facet;
};

/// How far along the ray it meets the triangle, and whether at its front; infinity if it does not.
std::pair<double, bool> ray_hit(const Vector& p, const Vector& along, const LocatedTriangle& triangle) {
  const Vector &a = triangle.at[0], ab = minus(triangle.at[1], a), ac = minus(triangle.at[2], a);
  constexpr std::pair<double, bool> kMissed{kInfinity, false};
  constexpr double kRim = -1e-12;  // triangles are a little larger: rather two hits at an edge than none
  const Vector n = cross(ab, ac), ap = minus(p, a);
  const double falling = -dot(along, n);
  if (falling == 0) return kMissed;
  const Vector q = cross(ap, along);
  const double u = dot(ac, q) / falling, v = -dot(ab, q) / falling, t = dot(ap, n) / falling;
  if (u < kRim || v < kRim || u + v > 1 - kRim || !(t > 0)) return kMissed;
  return {t, falling > 0};
}

/// From a point, and asked of many boxes.
struct Ray {
  Vector from, along, inverse;
  Ray(const Vector& p, const Vector& way) : from(p), along(way) {
    for (std::size_t k = 0; k < 3; ++k) inverse[k] = 1 / way[k];
  }
  /// True if it meets the box before `nearest`.
  bool meets(const Box& box, double nearest) const {
    double begin = 0, end = nearest;
    for (std::size_t k = 0; k < 3; ++k) {
      if (along[k] == 0) {
        if (from[k] < box.lo[k] || from[k] > box.hi[k]) return false;
        continue;
      }
      const double low = (box.lo[k] - from[k]) * inverse[k], high = (box.hi[k] - from[k]) * inverse[k];
      begin = std::max(begin, std::min(low, high));
      end = std::min(end, std::max(low, high));
    }
    return begin <= end;
  }
};

/// Planes at an angle of some 25 degrees at most.
bool are_parallel(const Vector& n, const Vector& m) {
  constexpr double kAlike = 0.9;
  const double both = dot(n, m);
  return both * both >= kAlike * kAlike * dot(n, n) * dot(m, m);
}
Vector normal_of(const LocatedTriangle& c) { return cross(minus(c.at[1], c.at[0]), minus(c.at[2], c.at[0])); }

}  // namespace

struct RegionLocator::Data {
  const FlatComplex& flat;
  std::vector<LocatedTriangle> triangles;
  std::vector<std::vector<Index>> facets;  // the points that they have, ascending
  BoxTree boxes;
  Index outside = FlatComplex::kNone;

  /// Two facets with an edge in common.
  bool meet(const LocatedTriangle& one, const LocatedTriangle& other) const {
    if (one.facet == other.facet) return true;
    const std::vector<Index>&a = facets[one.facet], &b = facets[other.facet];
    std::size_t common = 0;
    for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end() && common < 2;) {
      if (*i < *j) ++i;
      else if (*j < *i) ++j;
      else ++common, ++i, ++j;
    }
    return common == 2;
  }
};

RegionLocator::RegionLocator(const FlatComplex& flat, const RoundedPoints& points) {
  std::vector<LocatedTriangle> triangles;
  std::vector<std::vector<Index>> facets;
  std::vector<Box> boxes;
  Box all;
  for (Index f = 0; f < flat.faces.size(); ++f) {
    const FlatComplex::Face& face = flat.faces[f];
    const auto first = Index(facets.size());
    for_each_facet(face, [&](const auto& loops, const auto&, Index, Index) {
      std::vector<Index>& of = facets.emplace_back();
      for (const FlatComplex::Loop& loop : loops) of.insert(of.end(), loop.begin(), loop.end());
      sort_unique(of);
    });
    for (std::size_t t = 0; t < face.triangles.size(); ++t) {
      const auto& [a, b, c] = face.triangles[t];
      const auto facet =
          std::upper_bound(face.facet_ends.begin(), face.facet_ends.end(), t) - face.facet_ends.begin();
      triangles.push_back({{points.xyz[a], points.xyz[b], points.xyz[c]}, f, first + Index(facet)});
      Box& box = boxes.emplace_back();
      for (const Vector& corner : triangles.back().at) box.extend(corner, corner);
      all.extend(box);
    }
  }
  // Room for the rounding of `Ray::meets`.
  double room = 0;
  for (std::size_t k = 0; k < 3 && !boxes.empty(); ++k)
    room = std::max({room, std::abs(all.lo[k]), std::abs(all.hi[k])});
  room *= 1e-14;
  for (Box& box : boxes) {
    for (std::size_t k = 0; k < 3; ++k) box.lo[k] -= room, box.hi[k] += room;
  }
  const auto outside =
      std::find_if(flat.regions.begin(), flat.regions.end(), [](const auto& region) { return !region.bounded; });
  data_.reset(
      new Data{flat, std::move(triangles), std::move(facets), BoxTree(std::move(boxes)),
               outside == flat.regions.end() ? FlatComplex::kNone : Index(outside - flat.regions.begin())});
}

RegionLocator::~RegionLocator() = default;
RegionLocator::RegionLocator(RegionLocator&&) noexcept = default;

bool RegionLocator::meets_faces(const Vector& low, const Vector& high) const {
  Box box;
  box.extend(low, high);
  bool met = false;
  data_->boxes.query([&](const Box& other) { return !met && other.meets(box); },
                     [&](std::uint32_t) { met = true; });
  return met;
}

Index RegionLocator::at(const Vector& p) const {
  double nearest = kInfinity;
  Index region = data_->outside;
  const Ray ray(p, kAlong);
  data_->boxes.query([&](const Box& box) { return ray.meets(box, nearest); },
                     [&](std::uint32_t item) {
                       const LocatedTriangle& triangle = data_->triangles[item];
                       const auto [distance, front] = ray_hit(p, kAlong, triangle);
                       if (!(distance < nearest)) return;
                       nearest = distance;
                       region = data_->flat.faces[triangle.face].regions[front ? 0 : 1];
                     });
  return region;
}

/// The first face on the way from a point, and how far it is.
struct RegionLocator::Wall {
  double distance;
  const LocatedTriangle* triangle = nullptr;  // nullptr: there is none so near
};

RegionLocator::Wall RegionLocator::wall(const Vector& p, const Vector& along, double most, std::size_t but) const {
  Wall nearest{most};
  const Ray ray(p, along);
  data_->boxes.query([&](const Box& box) { return ray.meets(box, nearest.distance); },
                     [&](std::uint32_t item) {
                       if (item == but) return;
                       const LocatedTriangle& triangle = data_->triangles[item];
                       const double distance = ray_hit(p, along, triangle).first;
                       if (distance < nearest.distance) nearest = {distance, &triangle};
                     });
  return nearest;
}

double RegionLocator::gap(const Vector& p, const Vector& into, Index region, std::size_t triangle,
                          double most) const {
  const Wall ahead = wall(p, into, most, triangle);
  if (ahead.triangle == nullptr) return most;
  // Triangles beside its own may be met by rounding, from their other side.
  const Vector n = normal_of(*ahead.triangle);
  const bool front = dot(n, into) < 0;
  const bool met = data_->flat.faces[ahead.triangle->face].regions[front ? 0 : 1] == region;
  return met && are_parallel(into, n) && !data_->meet(data_->triangles[triangle], *ahead.triangle) ? ahead.distance
                                                                                                   : most;
}

}  // namespace cnrg
