// The area vector of a surface is half of the sum of p x q over the directed pieces pq of its boundary (Stokes),
// so nothing has to be cut into triangles: holes and slits take themselves off. Seen from a point of the boundary
// the numbers are those of the face, not of its distance from the origin.
#include "csg/result/measures.h"

#include <algorithm>
#include <limits>
#include <span>

#include "kernel/base/limits.h"
#include "kernel/base/parallel.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/selection/measure.h"

namespace cnrg {
namespace {

/// The numbers of list i.
std::span<const std::int32_t> list(const NumberLists& lists, std::size_t i) {
  const auto begin = static_cast<std::size_t>(lists.offsets[i]),
             end = static_cast<std::size_t>(lists.offsets[i + 1]);
  return std::span(lists.values).subspan(begin, end - begin);
}

constexpr std::size_t kWorthAThread = 64;  // cells

template <class T, class Of>
std::vector<T> of_all(std::size_t count, const Watch& watch, Of of) {
  std::vector<T> out(count);
  Steps steps(watch, "measure", count);
  for_each_index(
      count,
      [&](std::size_t i) {
        out[i] = of(i);
        steps.step();
      },
      kWorthAThread);
  return out;
}

}  // namespace

RationalPoint Measures::point(std::int32_t i) const {
  return result_.complex().points.rational(arrays_.ids[static_cast<std::size_t>(i)]);
}

bool Measures::on_frame(std::int32_t point) const {
  return std::binary_search(arrays_.frame_points.begin(), arrays_.frame_points.end(), point);
}

double Measures::length(std::size_t edge) const {
  const auto points = list(arrays_.edges.points, edge);
  if (std::any_of(points.begin(), points.end(), [&](auto p) { return on_frame(p); })) return kInfinity;
  if (const std::optional<Rational> square = squared_length(edge)) return to_double(square_root(*square));
  std::vector<Rational> pieces;
  const std::size_t count = points.size() - (arrays_.edges.closed[edge] ? 0 : 1);
  for (std::size_t k = 0; k < count; ++k) {
    const RationalPoint d = point(points[(k + 1) % points.size()]) - point(points[k]);
    pieces.push_back(square_root(dot(d, d)));
  }
  return to_double(sum(std::move(pieces)));
}

std::optional<Rational> Measures::squared_length(std::size_t edge) const {
  const auto points = list(arrays_.edges.points, edge);
  if (arrays_.edges.closed[edge] || points.front() == points.back()) return {};
  if (on_frame(points.front()) || on_frame(points.back())) return {};
  const RationalPoint a = point(points.front()), d = point(points.back()) - a;
  for (const std::int32_t p : points.subspan(1, points.size() - 2)) {
    if (!is_zero(cross(point(p) - a, d))) return {};
  }
  return dot(d, d);
}

RationalPoint Measures::area_vector(const NumberLists& loops, std::size_t first, std::size_t last) const {
  RationalPoint twice{Rational(0), Rational(0), Rational(0)};
  std::optional<RationalPoint> base;
  for (std::size_t loop = first; loop < last; ++loop) {
    std::vector<RationalPoint> walk;
    for (const std::int32_t p : list(loops, loop)) {
      if (!base) base = point(p);
      walk.push_back(point(p) - *base);
    }
    for (std::size_t k = 0; k < walk.size(); ++k) twice = twice + cross(walk[k], walk[(k + 1) % walk.size()]);
  }
  return Rational(1, 2) * twice;
}

bool Measures::reaches_frame(std::size_t face) const {
  if (arrays_.frame_points.empty()) return false;
  const auto first = static_cast<std::size_t>(arrays_.faces.loops.offsets[face]);
  const auto last = static_cast<std::size_t>(arrays_.faces.loops.offsets[face + 1]);
  for (std::size_t loop = first; loop < last; ++loop) {
    const auto points = list(arrays_.faces.loop_points, loop);
    if (std::any_of(points.begin(), points.end(), [&](auto p) { return on_frame(p); })) return true;
  }
  return false;
}

std::optional<RationalPoint> Measures::area_vector(std::size_t face) const {
  if (reaches_frame(face)) return {};
  const auto& loops = arrays_.faces.loops.offsets;
  return area_vector(arrays_.faces.loop_points, static_cast<std::size_t>(loops[face]),
                     static_cast<std::size_t>(loops[face + 1]));
}

std::optional<Rational> Measures::squared_area(std::size_t face) const {
  if (!arrays_.faces.flat[face]) return {};
  const std::optional<RationalPoint> a = area_vector(face);
  return a ? std::optional(dot(*a, *a)) : std::nullopt;
}

double Measures::area(std::size_t face) const {
  if (reaches_frame(face)) return kInfinity;
  if (const std::optional<Rational> square = squared_area(face)) return to_double(square_root(*square));
  std::vector<Rational> pieces;
  const auto& facets = arrays_.faces.facets.offsets;
  const auto& loops = arrays_.faces.facet_loops.offsets;
  for (auto f = static_cast<std::size_t>(facets[face]); f < static_cast<std::size_t>(facets[face + 1]); ++f) {
    const RationalPoint a = area_vector(arrays_.faces.facet_points, static_cast<std::size_t>(loops[f]),
                                        static_cast<std::size_t>(loops[f + 1]));
    pieces.push_back(square_root(dot(a, a)));
  }
  return to_double(sum(std::move(pieces)));
}

std::optional<Rational> Measures::volume(std::size_t region) const {
  return cnrg::volume(result_.complex(), result_.cells().regions[region].cells);
}

// The tetrahedra from one point to the triangles around the region have signed volumes det / 6 and centres (a + b
// + c) / 4, seen from that point.
std::optional<RationalPoint> Measures::centroid(std::size_t region) const {
  if (arrays_.regions.bounded[region] == 0) return {};
  std::optional<RationalPoint> base;
  std::vector<Rational> volumes;
  std::array<std::vector<Rational>, 3> moments;
  const auto& shells = arrays_.regions.shells.offsets;
  for (auto shell = static_cast<std::size_t>(shells[region]); shell < static_cast<std::size_t>(shells[region + 1]);
       ++shell) {
    for (const std::int32_t side : list(arrays_.regions.shell_sides, shell)) {
      const auto& corners = arrays_.faces.triangles;
      const auto face = static_cast<std::size_t>(side / 2);
      for (auto t = static_cast<std::size_t>(corners.offsets[face]);
           t < static_cast<std::size_t>(corners.offsets[face + 1]); ++t) {
        if (!base) base = point(corners.values[3 * t]);
        const RationalPoint a = point(corners.values[3 * t]) - *base, b = point(corners.values[3 * t + 1]) - *base,
                            c = point(corners.values[3 * t + 2]) - *base;
        const Rational volume = (side % 2 == 0 ? -1 : 1) * dot(a, cross(b, c));
        for (std::size_t k = 0; k < 3; ++k) moments[k].push_back(volume * (a[k] + b[k] + c[k]));
        volumes.push_back(volume);
      }
    }
  }
  const Rational whole = 4 * sum(std::move(volumes));
  RationalPoint out = *base;
  for (std::size_t k = 0; k < 3; ++k) out[k] += sum(std::move(moments[k])) / whole;
  return out;
}

std::vector<double> Measures::lengths(const Watch& watch) const {
  return of_all<double>(arrays_.edges.component.size(), watch, [&](std::size_t i) { return length(i); });
}

std::vector<double> Measures::areas(const Watch& watch) const {
  return of_all<double>(arrays_.faces.component.size(), watch, [&](std::size_t i) { return area(i); });
}

std::vector<double> Measures::area_vectors(const Watch& watch) const {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  const auto vectors = of_all<std::array<double, 3>>(arrays_.faces.component.size(), watch, [&](std::size_t i) {
    const std::optional<RationalPoint> a = area_vector(i);
    return a ? to_doubles(*a) : std::array{kNothing, kNothing, kNothing};
  });
  std::vector<double> out;
  for (const auto& v : vectors) out.insert(out.end(), v.begin(), v.end());
  return out;
}

std::vector<std::optional<Rational>> Measures::volumes(const Watch& watch) const {
  return of_all<std::optional<Rational>>(arrays_.regions.component.size(), watch,
                                         [&](std::size_t i) { return volume(i); });
}

std::vector<std::optional<RationalPoint>> Measures::centroids(const Watch& watch) const {
  return of_all<std::optional<RationalPoint>>(arrays_.regions.component.size(), watch,
                                              [&](std::size_t i) { return centroid(i); });
}

}  // namespace cnrg
