#include "csg/mesh/region_locator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kernel/base/vectors.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;
using Vector = RegionLocator::Vector;

constexpr Vector kAlong{0.53119, 0.37943, 0.75751};

struct Corners {
  std::array<Vector, 3> at;
  Index face;
};

/// How far along the ray it meets the triangle, and whether at its front; infinity if it does not.
std::pair<double, bool> hit(const Vector& p, const Vector& along, const Corners& triangle) {
  const Vector &a = triangle.at[0], ab = minus(triangle.at[1], a), ac = minus(triangle.at[2], a);
  constexpr std::pair<double, bool> kMissed{std::numeric_limits<double>::infinity(), false};
  constexpr double kRim = -1e-12;  // triangles are a little larger: rather two hits at an edge than none
  const Vector n = cross(ab, ac), ap = minus(p, a);
  const double falling = -dot(along, n);
  if (falling == 0) return kMissed;
  const Vector q = cross(ap, along);
  const double u = dot(ac, q) / falling, v = -dot(ab, q) / falling, t = dot(ap, n) / falling;
  if (u < kRim || v < kRim || u + v > 1 - kRim || !(t > 0)) return kMissed;
  return {t, falling > 0};
}

/// True if the ray meets the box before `nearest`.
bool meets(const Box& box, const Vector& p, const Vector& along, double nearest) {
  double from = 0, to = nearest;
  for (std::size_t k = 0; k < 3; ++k) {
    if (along[k] == 0) {
      if (p[k] < box.lo[k] || p[k] > box.hi[k]) return false;
      continue;
    }
    const double low = (box.lo[k] - p[k]) / along[k], high = (box.hi[k] - p[k]) / along[k];
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
  }
  return from <= to;
}

/// Planes at an angle of some 25 degrees at most, and of half a degree.
constexpr double kAlike = 0.9, kEven = 0.99996;
bool are_parallel(const Vector& n, const Vector& m, double cosine) {
  const double both = dot(n, m);
  return both * both >= cosine * cosine * dot(n, n) * dot(m, m);
}
Vector normal_of(const Corners& c) { return cross(minus(c.at[1], c.at[0]), minus(c.at[2], c.at[0])); }

}  // namespace

struct RegionLocator::Data {
  const FlatComplex& flat;
  std::vector<Corners> triangles;
  BoxTree boxes;
  Index outside = FlatComplex::kNone;
};

RegionLocator::RegionLocator(const FlatComplex& flat, const RoundedPoints& points) {
  std::vector<Corners> triangles;
  std::vector<Box> boxes;
  Box all;
  for (Index f = 0; f < flat.faces.size(); ++f) {
    for (const auto& [a, b, c] : flat.faces[f].triangles) {
      triangles.push_back({{points.xyz[a], points.xyz[b], points.xyz[c]}, f});
      Box& box = boxes.emplace_back();
      for (const Vector& corner : triangles.back().at) box.extend(corner, corner);
      all.extend(box);
    }
  }
  // Room for the rounding of `meets`.
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
      new Data{flat, std::move(triangles), BoxTree(std::move(boxes)),
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
  double nearest = std::numeric_limits<double>::infinity();
  Index region = data_->outside;
  data_->boxes.query([&](const Box& box) { return meets(box, p, kAlong, nearest); },
                     [&](std::uint32_t item) {
                       const Corners& triangle = data_->triangles[item];
                       const auto [distance, front] = hit(p, kAlong, triangle);
                       if (!(distance < nearest)) return;
                       nearest = distance;
                       region = data_->flat.faces[triangle.face].regions[front ? 0 : 1];
                     });
  return region;
}

/// The first face on the way from a point, and how far it is.
struct RegionLocator::Wall {
  double distance;
  const Corners* triangle = nullptr;  // nullptr: there is none so near
};

RegionLocator::Wall RegionLocator::wall(const Vector& p, const Vector& along, double most, std::size_t but) const {
  Wall nearest{most};
  data_->boxes.query([&](const Box& box) { return meets(box, p, along, nearest.distance); },
                     [&](std::uint32_t item) {
                       if (item == but) return;
                       const Corners& triangle = data_->triangles[item];
                       const double distance = hit(p, along, triangle).first;
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
  return met && are_parallel(into, n, kEven) ? ahead.distance : most;
}

RegionLocator::Plate RegionLocator::plate(const Vector& p, double most) const {
  constexpr double kDiagonal = 0.5773502691896258;  // of a cube with the diagonal 1
  constexpr Vector kWays[] = {{1, 0, 0},
                              {0, 1, 0},
                              {0, 0, 1},
                              {kDiagonal, kDiagonal, kDiagonal},
                              {kDiagonal, kDiagonal, -kDiagonal},
                              {kDiagonal, -kDiagonal, kDiagonal},
                              {-kDiagonal, kDiagonal, kDiagonal}};
  Plate least{most};
  for (const Vector& way : kWays) {
    const Wall ahead = wall(p, way, least.thickness);
    if (ahead.triangle == nullptr) continue;
    const Wall behind = wall(p, {-way[0], -way[1], -way[2]}, least.thickness - ahead.distance);
    if (behind.triangle == nullptr) continue;
    const Vector n = normal_of(*ahead.triangle), m = normal_of(*behind.triangle);
    if (are_parallel(n, m, kAlike)) least = {ahead.distance + behind.distance, are_parallel(n, m, kEven)};
  }
  return least;
}

}  // namespace cnrg
