#include "csg/mesh/input_lines.h"

#include <algorithm>
#include <cmath>

#include "kernel/base/sorted.h"
#include "kernel/base/union_find.h"
#include "kernel/base/vectors.h"

namespace cnrg {
namespace {

using Index = InputLines::Index;
using Vector = InputLines::Vector;

constexpr double kCosine60 = 0.5;
constexpr double kCosineThin = 0.99619469809174553;  // of 5 degrees

double cosine_at(const Vector& apex, const Vector& a, const Vector& b) {
  const Vector u = minus(a, apex), v = minus(b, apex);
  return dot(u, v) / (length(u) * length(v));
}

/// The roundest binary number between two positive ones.
double roundest(double low, double high) {
  for (int e = std::ilogb(high);; --e) {
    const double step = std::ldexp(1.0, e), r = std::ceil(low / step) * step;
    if (r <= high) return r;
  }
}

}  // namespace

InputLines::InputLines(const FacetMesh& mesh) {
  Rays rays;
  for (Index s = 0; s < mesh.segments().size(); ++s) {
    const auto& [a, b] = mesh.segments()[s].ends;
    const Vector along = minus(mesh.points()[b], mesh.points()[a]), way = unit(along);
    rays[a].push_back({s, way, length(along)});
    rays[b].push_back({s, {-way[0], -way[1], -way[2]}, length(along)});
  }
  find_lines(mesh, rays);
  find_sharp(mesh, rays);
  find_apexes(mesh, rays);
}

void InputLines::find_lines(const FacetMesh& mesh, const Rays& rays) {
  const std::size_t n = mesh.segments().size();
  double largest = 0;
  for (const Vector& p : mesh.points())
    for (const double x : p) largest = std::max(largest, std::abs(x));
  UnionFind lines(n);
  for (const auto& [point, list] : rays) {
    // A point with many rays is no place where one goes on; what is tried is bounded.
    constexpr std::size_t kMost = 64;
    if (list.size() > kMost) continue;
    for (std::size_t i = 0; i < list.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (dot(list[i].direction, list[j].direction) > 0) continue;
        // Straight but for the digits of the points.
        const double doubt = 4e-16 * (1 + largest / list[i].length + largest / list[j].length);
        if (length(cross(list[i].direction, list[j].direction)) < doubt)
          lines.unite(list[i].segment, list[j].segment);
      }
    }
  }
  std::unordered_map<Index, Index> number;
  for (Index s = 0; s < n; ++s)
    line_.push_back(number.try_emplace(Index(lines.find(s)), Index(number.size())).first->second);
  vertices_.resize(number.size());
  for (Index s = 0; s < n; ++s) {
    for (const Index p : mesh.segments()[s].ends) {
      auto& on = on_[p];
      if (std::find(on.begin(), on.end(), line_[s]) != on.end()) continue;
      on.push_back(line_[s]);
      vertices_[line_[s]].push_back(p);
    }
  }
  for (auto& list : vertices_) std::sort(list.begin(), list.end());
}

/// Which rays make a small angle with the next one in a facet.
void InputLines::find_sharp(const FacetMesh& mesh, Rays& rays) {
  struct Corner {
    Index facet, point, segment;
    auto operator<=>(const Corner&) const = default;
  };
  std::vector<Corner> corners;
  for (const auto& t : mesh.triangles()) {
    for (Index k = 0; k < 3; ++k) {
      if (t.segments[k] == kNone) continue;
      for (const Index p : mesh.segments()[t.segments[k]].ends) corners.push_back({t.facet, p, t.segments[k]});
    }
  }
  sort_unique(corners);
  for (std::size_t i = 0, end = 0; i < corners.size(); i = end) {
    std::vector<Ray*> list;
    for (;
         end < corners.size() && corners[end].facet == corners[i].facet && corners[end].point == corners[i].point;
         ++end) {
      auto& all = rays[corners[i].point];
      list.push_back(&*std::find_if(all.begin(), all.end(),
                                    [&](const Ray& ray) { return ray.segment == corners[end].segment; }));
    }
    if (list.size() < 2) continue;
    // Angles in the plane of the facet from the first ray on.
    const Vector u = list[0]->direction;
    Vector normal{};
    for (const Ray* ray : list) {
      const Vector n = cross(u, ray->direction);
      if (dot(n, n) > dot(normal, normal)) normal = n;
    }
    if (dot(normal, normal) == 0) continue;
    const Vector v = cross(unit(normal), u);
    std::vector<std::pair<double, Ray*>> turned;
    for (Ray* ray : list) turned.emplace_back(std::atan2(dot(ray->direction, v), dot(ray->direction, u)), ray);
    std::sort(turned.begin(), turned.end(), [](const auto& s, const auto& t) { return s.first < t.first; });
    for (std::size_t j = 0; j < turned.size(); ++j) {
      Ray *a = turned[j].second, *b = turned[(j + 1) % turned.size()].second;
      if (dot(a->direction, b->direction) > kCosine60) a->sharp = b->sharp = true;
    }
  }
}

/// The nearest sharp points on the line of each segment, before it and behind it.
void InputLines::find_apexes(const FacetMesh& mesh, const Rays& rays) {
  apexes_.assign(line_.size(), {kNone, kNone});
  struct Place {
    double at;
    Index segment;
    std::size_t end;  // the end of the segment that comes first
  };
  std::vector<std::vector<Place>> lines(vertices_.size());
  std::vector<Vector> ways(vertices_.size());
  for (Index s = 0; s < line_.size(); ++s) {
    const auto& ends = mesh.segments()[s].ends;
    Vector& way = ways[line_[s]];
    const Vector along = minus(mesh.points()[ends[1]], mesh.points()[ends[0]]);
    if (lines[line_[s]].empty()) way = along;
    const std::size_t first = dot(along, way) > 0 ? 0 : 1;
    lines[line_[s]].push_back({dot(mesh.points()[ends[first]], way), s, first});
  }
  const auto is_sharp = [&](Index point, Index segment) {
    const auto& list = rays.at(point);
    return std::any_of(list.begin(), list.end(), [&](const Ray& r) { return r.segment == segment && r.sharp; });
  };
  for (auto& line : lines) {
    std::sort(line.begin(), line.end(), [](const Place& a, const Place& b) { return a.at < b.at; });
    Index apex = kNone;
    for (const auto& [at, s, first] : line) {
      const Index p = mesh.segments()[s].ends[first];
      if (is_sharp(p, s)) apex = p;
      apexes_[s][0] = apex;
    }
    apex = kNone;
    for (auto place = line.rbegin(); place != line.rend(); ++place) {
      const Index p = mesh.segments()[place->segment].ends[1 - place->end];
      if (is_sharp(p, place->segment)) apex = p;
      apexes_[place->segment][1] = apex;
    }
  }
}

Vector InputLines::split_place(const FacetMesh& mesh, const FacetMesh::Segment& segment) const {
  const Vector &a = mesh.points()[segment.ends[0]], &b = mesh.points()[segment.ends[1]];
  Vector place;
  for (std::size_t k = 0; k < 3; ++k) place[k] = a[k] / 2 + b[k] / 2;
  Index apex = kNone;
  double nearest = HUGE_VAL;
  for (const Index p : apexes_[segment.input]) {
    if (p == kNone) continue;
    const double distance = length(minus(mesh.points()[p], place));
    if (distance < nearest) nearest = distance, apex = p;
  }
  if (apex == kNone) return place;
  double from = length(minus(a, mesh.points()[apex])), to = length(minus(b, mesh.points()[apex]));
  const double third = (to - from) / 3;
  const double low = std::min(from, to) + std::abs(third), high = std::max(from, to) - std::abs(third);
  if (!(low < high) || !(low > 0)) return place;
  const double part = (roundest(low, high) - from) / (to - from);
  for (std::size_t k = 0; k < 3; ++k) place[k] = a[k] + (b[k] - a[k]) * part;
  return place;
}

/// Is there a point that both lines have for which `found` holds?
template <class Found>
bool InputLines::any_apex(Index line, Index other, const Found& found) const {
  if (line == other) return false;
  const bool fewer = vertices_[line].size() < vertices_[other].size();
  const auto &some = vertices_[fewer ? line : other], &others = vertices_[fewer ? other : line];
  return std::any_of(some.begin(), some.end(), [&](Index apex) {
    return std::binary_search(others.begin(), others.end(), apex) && found(apex);
  });
}

template <class Found>
bool InputLines::any_apex_between(Index a, Index b, const Found& found) const {
  const auto on_a = on_.find(a), on_b = on_.find(b);
  if (on_a == on_.end() || on_b == on_.end()) return false;
  for (const Index l : on_a->second) {
    for (const Index m : on_b->second) {
      if (any_apex(l, m, [&](Index apex) { return apex != a && apex != b && found(apex); })) return true;
    }
  }
  return false;
}

bool InputLines::across_small_angle(const FacetMesh& mesh, Index a, Index b) const {
  return any_apex_between(a, b, [&](Index apex) {
    return cosine_at(mesh.points()[apex], mesh.points()[a], mesh.points()[b]) > kCosine60;
  });
}

bool InputLines::is_forced(const FacetMesh& mesh, Index a, Index b) const {
  return any_apex_between(a, b, [&](Index apex) {
    const Vector &x = mesh.points()[apex], &p = mesh.points()[a], &q = mesh.points()[b];
    const double cosine = cosine_at(x, p, q), r = length(minus(p, x)), s = length(minus(q, x));
    constexpr double kLevel = 1e-3;
    return cosine > kCosineThin || (cosine > kCosine60 && std::abs(r - s) < kLevel * r);
  });
}

bool InputLines::is_beside(const FacetMesh& mesh, Index point, const FacetMesh::Segment& segment) const {
  const auto on = on_.find(point);
  if (on == on_.end()) return false;
  const Vector &a = mesh.points()[segment.ends[0]], &b = mesh.points()[segment.ends[1]];
  const Vector middle{a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2, a[2] / 2 + b[2] / 2};
  return std::any_of(on->second.begin(), on->second.end(), [&](Index line) {
    return any_apex(line, line_[segment.input], [&](Index apex) {
      return apex != point && cosine_at(mesh.points()[apex], mesh.points()[point], middle) > kCosineThin;
    });
  });
}

}  // namespace cnrg
