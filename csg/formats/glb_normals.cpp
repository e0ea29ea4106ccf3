#include "csg/formats/glb_normals.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

/// Of length 1; zero for what has no direction in doubles.
DoubleVector unit_or_zero(DoubleVector a) {
  double most = 0;
  for (const double x : a) most = std::max(most, std::abs(x));
  if (!(most > 0) || !std::isfinite(most)) return {0, 0, 0};
  for (double& x : a) x /= most;
  const double length = std::sqrt(dot(a, a));
  for (double& x : a) x /= length;
  return a;
}

bool is_null(const DoubleVector& a) { return a == DoubleVector{0, 0, 0}; }

/// An exact vector as doubles, up to a factor.
DoubleVector direction(const RationalPoint& a) {
  Rational most;
  for (const Rational& x : a) most = std::max<Rational>(most, abs(x));
  return unit_or_zero({to_double(a[0] / most), to_double(a[1] / most), to_double(a[2] / most)});
}

/// Where p is on the patch of a cell; nothing if that does not hold it. A corner that is there once, as nearly all
/// points that are asked for, needs no arithmetic.
std::optional<Parameters> place_in(const std::vector<PatchCorner>& cell, const RationalPoint& p) {
  const auto is_p = [&](const PatchCorner& corner) { return corner.point == p; };
  const auto first = std::find_if(cell.begin(), cell.end(), is_p);
  if (first != cell.end() && std::find_if(first + 1, cell.end(), is_p) == cell.end()) return first->at;
  if (!holds(cell, p)) return std::nullopt;
  return parameters_in(cell, p);
}

}  // namespace

/// Of the largest triangle; where all have collapsed in doubles, of one of them exactly.
DoubleVector CornerNormals::facet_normal(const FlatComplex::Face& face, std::size_t begin, std::size_t end) const {
  DoubleVector best{};
  for (std::size_t t = begin; t < end; ++t) {
    const auto& [a, b, c] = face.triangles[t];
    const DoubleVector n = cross(minus(points_[b], points_[a]), minus(points_[c], points_[a]));
    if (dot(n, n) > dot(best, best)) best = n;
  }
  if (const DoubleVector n = unit_or_zero(best); !is_null(n)) return n;
  std::array<RationalPoint, 3> p;
  for (std::size_t k = 0; k < 3; ++k) {
    p[k] = view_.complex->points.rational(flat_.points[face.triangles[begin][k]]);
  }
  return direction(cross(p[1] - p[0], p[2] - p[0]));
}

const PlacedSurface* CornerNormals::surface(const FlatComplex::Patch& patch) {
  const auto& [entry, fresh] = surfaces_.try_emplace(patch, view_.parameters->surfaces(patch.first), patch.second,
                                                     view_.parameters->transform(patch.first));
  return entry->second.flat() ? nullptr : &entry->second;
}

/// Where a corner of a facet is on the patches of the face.
std::vector<CornerNormals::Site> CornerNormals::sites(const FlatComplex::Face& face, std::size_t facet,
                                                      const Corners& corners, const RationalPoint& p) const {
  if (!face.cells.empty()) {
    for (const auto& cell : face.cells[facet]) {
      if (const auto at = place_in(cell, p)) return {{*face.patch, *at}};
    }
    return {};
  }
  if (const auto known = corners.find(p); known != corners.end()) return known->second;
  for (const auto& [patch, cell] : face.cells_of_patches) {
    const std::size_t third = collinear(cell[0].point, cell[1].point, cell[2].point) ? 3 : 2;
    const bool in_plane = volume6(cell[0].point, cell[1].point, cell[third].point, p) == 0;
    if (!in_plane) continue;
    if (const auto at = place_in(cell, p)) return {{patch, *at}};
  }
  return {};
}

/// Of the normals of the surfaces, each on the side of `flat`, that which is nearest to it; where there is none,
/// that itself.
DoubleVector CornerNormals::nearest_normal(const std::vector<Site>& sites, const DoubleVector& flat) {
  DoubleVector best = flat;
  double nearest = 0;
  for (const auto& [patch, uv] : sites) {
    const PlacedSurface* s = surface(patch);
    if (s == nullptr) continue;
    const DoubleVector n = unit_or_zero(s->at(to_double(uv[0]), to_double(uv[1])).normal);
    const double cosine = dot(n, flat);
    if (!(std::abs(cosine) > nearest)) continue;
    nearest = std::abs(cosine);
    best = cosine < 0 ? DoubleVector{-n[0], -n[1], -n[2]} : n;
  }
  return best;
}

std::vector<std::array<DoubleVector, 3>> CornerNormals::of(Index index) {
  const FlatComplex::Face& face = flat_.faces[index];
  Corners corners;
  for (const auto& [patch, cell] : face.cells_of_patches) {
    for (const PatchCorner& corner : cell) corners[corner.point].push_back({patch, corner.at});
  }
  const bool curved = !face.cells_of_patches.empty() || (!face.cells.empty() && surface(*face.patch) != nullptr);
  std::vector<std::array<DoubleVector, 3>> normals;
  const std::size_t facets = face.facets.empty() ? 1 : face.facets.size();
  for (std::size_t facet = 0, t = 0; facet < facets; ++facet) {
    const std::size_t end = face.facets.empty() ? face.triangles.size() : face.facet_ends[facet];
    const DoubleVector flat = facet_normal(face, t, end);
    std::map<Index, DoubleVector> known;  // at points of this facet
    for (; t < end; ++t) {
      auto& triangle = normals.emplace_back();
      triangle.fill(flat);
      for (std::size_t k = 0; k < 3 && curved; ++k) {
        const Index point = face.triangles[t][k];
        const auto [entry, fresh] = known.try_emplace(point);
        if (fresh) {
          const RationalPoint p = view_.complex->points.rational(flat_.points[point]);
          entry->second = nearest_normal(sites(face, facet, corners, p), flat);
        }
        triangle[k] = entry->second;
      }
    }
  }
  return normals;
}

}  // namespace cnrg
