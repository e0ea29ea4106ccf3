// Every change is of the few triangles around one point or one side, and writes both directions of each link. A
// change is made only if all triangles that it makes turn left.
#include "csg/mesh/facet_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <unordered_set>

#include "kernel/base/counts.h"
#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/triangulate.h"

namespace cnrg {
namespace {

using Index = FacetMesh::Index;
using Vector = FacetMesh::Vector;

}  // namespace

FacetMesh::FacetMesh(const FlatComplex& flat, std::vector<Vector> xyz, const std::vector<char>& fixed,
                     const PeriodicSides& sides)
    : xyz_(std::move(xyz)), sides_(sides), images_(matched_faces(flat, xyz_, sides_)) {
  for (const Vector& p : xyz_) table_.add(p[0], p[1], p[2]);
  add_segments(flat);
  add_facets(flat);
  link();
  tie();
  fix_thin(fixed);
}

void FacetMesh::add_segments(const FlatComplex& flat) {
  for (Index i = 0; i < flat.edges.size(); ++i) {
    for_each_segment(flat.edges[i], [&](Index a, Index b) {
      segments_.push_back({{a, b}, i, Index(segments_.size())});
    });
  }
}

void FacetMesh::add_facets(const FlatComplex& flat) {
  std::vector<char> is_image(flat.faces.size(), 0);
  for (const PeriodicFaces& image : images_) is_image[image.far] = 1;
  for (Index i = 0; i < flat.faces.size(); ++i) {
    const auto& face = flat.faces[i];
    for_each_facet(face, [&](const auto&, const auto&, Index begin, Index end) {
      Vector normal{}, center{};
      for (Index t = begin; t < end; ++t) {
        const auto& [a, b, c] = face.triangles[t];
        if (!is_image[i])
          triangles_.push_back({{a, b, c}, {kNone, kNone, kNone}, {kNone, kNone, kNone}, Index(facets_.size())});
        const Vector n = cross(minus(xyz_[b], xyz_[a]), minus(xyz_[c], xyz_[a]));
        for (std::size_t j = 0; j < 3; ++j) {
          normal[j] += n[j];
          center[j] += (xyz_[a][j] + xyz_[b][j] + xyz_[c][j]) / (3.0 * (end - begin));
        }
      }
      const double size = length(normal);
      for (double& x : normal) x = size > 0 ? x / size : 0;
      facets_.push_back({i, seen_along(normal), false, normal, center});
    });
  }
}

void FacetMesh::link() {
  std::unordered_map<std::uint64_t, Index> segment;
  for (Index s = 0; s < segments_.size(); ++s)
    segment.emplace(edge_key(segments_[s].ends[0], segments_[s].ends[1]), s);
  struct Side {
    std::uint64_t key;
    Index facet, triangle, k;
    auto operator<=>(const Side&) const = default;
  };
  std::vector<Side> sides;
  for (Index t = 0; t < triangles_.size(); ++t) {
    for (Index k = 0; k < 3; ++k) {
      const auto& p = triangles_[t].points;
      sides.push_back({edge_key(p[(k + 1) % 3], p[(k + 2) % 3]), triangles_[t].facet, t, k});
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end].key == sides[i].key) ++end;
    const auto known = segment.find(sides[i].key);
    const bool inside = known == segment.end() && end - i == 2 && sides[i].facet == sides[i + 1].facet;
    if (inside) {
      triangles_[sides[i].triangle].next[sides[i].k] = sides[i + 1].triangle;
      triangles_[sides[i + 1].triangle].next[sides[i + 1].k] = sides[i].triangle;
      continue;
    }
    Index s = known == segment.end() ? kNone : known->second;
    if (s == kNone) {  // between facets of a face
      require(end - i == 2, "surface: a side of a facet is on no edge and has no facet beside it");
      const auto& p = triangles_[sides[i].triangle].points;
      s = next_number(segments_.size(), "segments");
      segments_.push_back({{p[(sides[i].k + 1) % 3], p[(sides[i].k + 2) % 3]}, kNone, s});
    }
    for (std::size_t j = i; j < end; ++j) {
      triangles_[sides[j].triangle].segments[sides[j].k] = s;
      segments_[s].fan.push_back(sides[j].triangle);
    }
  }
}

/// Ties segments that are at one place when they are moved to the near sides.
void FacetMesh::tie() {
  if (!sides_.any()) return;
  std::map<std::array<Vector, 2>, Index> last;
  for (Index s = 0; s < segments_.size(); ++s) {
    Segment& segment = segments_[s];
    segment.next_tied = s;
    const PeriodicAxes along = sides_.at(sides_.far, xyz_, segment.ends);
    std::array<Vector, 2> ends{sides_.folded(xyz_[segment.ends[0]], along),
                               sides_.folded(xyz_[segment.ends[1]], along)};
    segment.turned = ends[1] < ends[0];
    if (segment.turned) std::swap(ends[0], ends[1]);
    const auto [it, first] = last.try_emplace(ends, s);
    if (!first) std::swap(segment.next_tied, segments_[it->second].next_tied);
  }
}

Index FacetMesh::first_facet(Index face) const {
  return Index(std::ranges::lower_bound(facets_, face, {}, &Facet::face) - facets_.begin());
}

void FacetMesh::fix(Index segment) {
  for_each_tied(segment, [&](Index s) { segments_[s].fixed = true; });
}

void FacetMesh::fix_thin(const std::vector<char>& fixed) {
  for (std::size_t f = 0; f < std::min(fixed.size(), facets_.size()); ++f) facets_[f].fixed = fixed[f] != 0;
  for (const PeriodicFaces& image : images_) {
    const Facet& far = facets_[first_facet(image.far)];
    for (Index f = first_facet(image.near); f < facets_.size() && facets_[f].face == image.near; ++f)
      facets_[f].fixed |= far.fixed;
  }
  for (const Triangle& t : triangles_) {
    Facet& facet = facets_[t.facet];
    if (turn(t.facet, t.points[0], t.points[1], t.points[2]) <= 0 || facet.normal == Vector{}) facet.fixed = true;
  }
  for (const Triangle& t : triangles_) {
    if (!facets_[t.facet].fixed) continue;
    for (const Index s : t.segments)
      if (s != kNone) fix(s);
  }
}

Index FacetMesh::add_point(const Vector& at) {
  xyz_.push_back(at);
  table_.add(at[0], at[1], at[2]);
  return next_number(xyz_.size() - 1, "points");
}

int FacetMesh::turn(Index facet, Index a, Index b, Index c) const {
  return orient2d(table_, facets_[facet].axes, VertexId(a), VertexId(b), VertexId(c));
}

Index FacetMesh::side_of(Index triangle, Index next) const {
  const auto& list = triangles_[triangle].next;
  return Index(std::find(list.begin(), list.end(), next) - list.begin());
}

Index FacetMesh::side_on(Index triangle, Index segment) const {
  const auto& list = triangles_[triangle].segments;
  return Index(std::find(list.begin(), list.end(), segment) - list.begin());
}

/// Side k of t gets what was across a side of the triangle `before`, which looks at t from now on.
void FacetMesh::join(Index t, Index k, Index before, const Across& out) {
  triangles_[t].next[k] = out.next;
  triangles_[t].segments[k] = out.segment;
  if (t == before) return;
  if (out.segment != kNone) {
    auto& fan = segments_[out.segment].fan;
    *std::find(fan.begin(), fan.end(), before) = t;
  } else if (out.next != kNone) {
    triangles_[out.next].next[side_of(out.next, before)] = t;
  }
}

Vector FacetMesh::on_plane(Index facet, Vector at) const {
  const auto& [face, axes, fixed, normal, center] = facets_[facet];
  const std::size_t w = 3u - axes.u - axes.v;
  if (normal[w] == 0) return at;
  const double up =
      normal[axes.u] * (at[axes.u] - center[axes.u]) + normal[axes.v] * (at[axes.v] - center[axes.v]);
  at[w] = center[w] - up / normal[w];
  return at;
}

/// Of a triangle a, b, p that turns left, and q beyond its side a b: positive where the angles at p and at q are
/// together less than half a turn, so that the circle through one triangle leaves out the other's corner. Zero
/// where doubles leave a doubt.
double FacetMesh::delaunay(Index facet, Index a, Index b, const Vector& p, const Vector& q) const {
  const Vector pa = minus(xyz_[a], p), pb = minus(xyz_[b], p), qa = minus(xyz_[a], q), qb = minus(xyz_[b], q);
  const Vector& normal = facets_[facet].normal;
  const double sum = dot(cross(pa, pb), normal) * dot(qa, qb) + dot(cross(qb, qa), normal) * dot(pa, pb);
  const double scale =
      std::sqrt(dot(pa, pa)) * std::sqrt(dot(pb, pb)) * std::sqrt(dot(qa, qa)) * std::sqrt(dot(qb, qb));
  constexpr double kDoubt = 1e-11;
  return std::abs(sum) <= kDoubt * scale ? 0 : sum;
}

bool FacetMesh::is_delaunay(Index t, Index k) const {
  const Triangle& triangle = triangles_[t];
  const Triangle& beyond = triangles_[triangle.next[k]];
  const Index q = beyond.points[side_of(triangle.next[k], t)];
  return delaunay(triangle.facet, triangle.points[(k + 1) % 3], triangle.points[(k + 2) % 3],
                  xyz_[triangle.points[k]], xyz_[q]) >= 0;
}

/// Turns side k of t, if that is possible. t and its neighbour keep the point p opposite to that side as their
/// points 0.
bool FacetMesh::flip(Index t, Index k) {
  const Index u = triangles_[t].next[k], l = side_of(u, t), facet = triangles_[t].facet;
  const Index p = triangles_[t].points[k], a = triangles_[t].points[(k + 1) % 3],
              b = triangles_[t].points[(k + 2) % 3], q = triangles_[u].points[l];
  if (turn(facet, p, a, q) <= 0 || turn(facet, p, q, b) <= 0) return false;
  const Across pa = across(t, (k + 2) % 3), bp = across(t, (k + 1) % 3);
  const Across aq = across(u, (l + 1) % 3), qb = across(u, (l + 2) % 3);
  triangles_[t].points = {p, a, q};
  triangles_[u].points = {p, q, b};
  join(t, 0, u, aq), join(t, 1, t, {u, kNone}), join(t, 2, t, pa);
  join(u, 0, u, qb), join(u, 1, t, bp), join(u, 2, u, {t, kNone});
  changed_.push_back(t), changed_.push_back(u);
  return true;
}

/// Turns sides that face the new point m, and those that come to face it by that.
void FacetMesh::settle(Index m, std::vector<Index> around) {
  while (!around.empty()) {
    const Index t = around.back();
    around.pop_back();
    const auto& points = triangles_[t].points;
    const Index k = Index(std::find(points.begin(), points.end(), m) - points.begin());
    const Index u = triangles_[t].next[k];
    if (u == kNone || is_delaunay(t, k) || !flip(t, k)) continue;
    around.push_back(t), around.push_back(u);
  }
}

void FacetMesh::make_delaunay() {
  std::vector<Index> open;
  for (Index t = 0; t < triangles_.size(); ++t) {
    changed_.push_back(t);
    if (!facets_[triangles_[t].facet].fixed) open.push_back(t);
  }
  // Each turn makes the mesh more Delaunay, so this ends; should doubles contradict each other, the bound ends it.
  std::size_t turns = 64 * triangles_.size() * (1 + std::size_t(std::log2(1 + triangles_.size())));
  while (!open.empty()) {
    const Index t = open.back();
    open.pop_back();
    for (Index k = 0; k < 3 && turns > 0; ++k) {
      const Index u = triangles_[t].next[k];
      if (u == kNone || is_delaunay(t, k) || !flip(t, k)) continue;
      --turns;
      open.push_back(t), open.push_back(u);
      break;
    }
  }
}

/// Parts t, which is p, a, b, at a point m on its side a b (k): t is m, p, a then, and `other` is m, b, p. What is
/// across the parts of that side is left open: of t side 1, of `other` side 2.
void FacetMesh::split_triangle(Index t, Index k, Index m, Index other) {
  const auto points = triangles_[t].points;
  const Index p = points[k], a = points[(k + 1) % 3], b = points[(k + 2) % 3];
  const Across pa = across(t, (k + 2) % 3), bp = across(t, (k + 1) % 3);
  triangles_[other] = {{m, b, p}, {kNone, kNone, kNone}, {kNone, kNone, kNone}, triangles_[t].facet};
  triangles_[t].points = {m, p, a};
  triangles_[t].next = triangles_[t].segments = {kNone, kNone, kNone};
  join(t, 0, t, pa), join(other, 0, t, bp);
  triangles_[t].next[2] = other, triangles_[other].next[1] = t;
  changed_.push_back(t), changed_.push_back(other);
}

/// Would both parts of a triangle turn left?
bool FacetMesh::is_splittable(Index t, Index k, Index m) const {
  const auto& [points, next, segments, facet] = triangles_[t];
  return turn(facet, points[k], points[(k + 1) % 3], m) > 0 && turn(facet, points[k], m, points[(k + 2) % 3]) > 0;
}

Index FacetMesh::new_triangle() {
  triangles_.emplace_back();
  return next_number(triangles_.size() - 1, "triangles");
}

/// Would all parts of the triangles around a segment turn left?
bool FacetMesh::has_room(Index s, Index m) const {
  return std::ranges::all_of(segments_[s].fan, [&](Index t) { return is_splittable(t, side_on(t, s), m); });
}

FacetMesh::Parts FacetMesh::split_one(Index s, Index m) {
  std::vector<Index> around;
  const auto [a, b] = segments_[s].ends;
  const auto fan = segments_[s].fan;
  const Index second = next_number(segments_.size(), "segments");
  Segment part = segments_[s];
  part.ends = {m, b};
  part.fan = {};
  segments_.push_back(std::move(part));
  segments_[s].ends = {a, m};
  segments_[s].fan = {};
  for (const Index t : fan) {
    const Index side = side_on(t, s), other = new_triangle();
    split_triangle(t, side, m, other);
    const bool first = triangles_[t].points[2] == a;
    triangles_[t].segments[1] = first ? s : second;
    triangles_[other].segments[2] = first ? second : s;
    segments_[first ? s : second].fan.push_back(t);
    segments_[first ? second : s].fan.push_back(other);
    around.push_back(t), around.push_back(other);
  }
  settle(m, std::move(around));
  return {s, second, m};
}

std::vector<FacetMesh::Parts> FacetMesh::split(Index segment, const Vector& at) {
  std::vector<std::pair<Index, Index>> tied;  // and the new points
  bool room = true;
  for_each_tied(segment, [&](Index s) {
    const auto& [a, b] = segments_[s].ends;
    Vector place = at;
    for (std::size_t k = 0; k < 3; ++k)
      if (xyz_[a][k] == xyz_[b][k] && place[k] != xyz_[a][k]) place[k] = xyz_[a][k];  // on another side
    room = room && !segments_[s].fixed && place != xyz_[a] && place != xyz_[b];
    if (room) tied.emplace_back(s, add_point(place));
    room = room && has_room(s, tied.back().second);
  });
  std::vector<Parts> parts;
  if (!room) return parts;
  for (const auto& [s, m] : tied) parts.push_back(split_one(s, m));
  // Parts at the same end are tied.
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Parts &here = parts[i], &next = parts[(i + 1) % parts.size()];
    const bool alike = segments_[here.first].turned == segments_[next.first].turned;
    segments_[here.first].next_tied = alike ? next.first : next.second;
    segments_[here.second].next_tied = alike ? next.second : next.first;
  }
  return parts;
}

bool FacetMesh::insert(Index t, const Vector& at) {
  const Index m = add_point(at), facet = triangles_[t].facet;
  const auto p = triangles_[t].points;
  Index on = kNone;
  for (Index k = 0; k < 3; ++k) {
    const int side = turn(facet, p[(k + 1) % 3], p[(k + 2) % 3], m);
    if (side < 0 || (side == 0 && on != kNone)) return false;
    if (side == 0) on = k;
  }
  if (on != kNone) {
    const Index u = triangles_[t].next[on];
    if (u == kNone) return false;
    const Index l = side_of(u, t);
    if (!is_splittable(u, l, m)) return false;
    const Index other = new_triangle(), beyond = new_triangle();
    split_triangle(t, on, m, other), split_triangle(u, l, m, beyond);
    triangles_[t].next[1] = beyond, triangles_[beyond].next[2] = t;
    triangles_[u].next[1] = other, triangles_[other].next[2] = u;
    settle(m, {t, other, u, beyond});
    return true;
  }
  const std::array<Index, 3> parts{t, new_triangle(), new_triangle()};
  const std::array<Across, 3> outer{across(t, 2), across(t, 0), across(t, 1)};  // p0 p1, p1 p2, p2 p0
  for (Index i = 0; i < 3; ++i) {
    triangles_[parts[i]] = {
        {m, p[i], p[(i + 1) % 3]}, {kNone, parts[(i + 1) % 3], parts[(i + 2) % 3]}, {kNone, kNone, kNone}, facet};
    join(parts[i], 0, t, outer[i]);
    changed_.push_back(parts[i]);
  }
  settle(m, {parts.begin(), parts.end()});
  return true;
}

FacetMesh::Walk FacetMesh::walk(Index t, const Vector& to) const {
  const ExactPoint exact = ExactPoint::from(from_doubles(to));
  const PointView target = view_of(exact);
  const Projection axes = facets_[triangles_[t].facet].axes;
  Vector from{};
  for (const Index p : triangles_[t].points)
    for (std::size_t j = 0; j < 3; ++j) from[j] += xyz_[p][j] / 3;
  const auto area = [&](const Vector& a, const Vector& b) {  // of a triangle with the beginning of the walk
    return (a[axes.u] - from[axes.u]) * (b[axes.v] - from[axes.v]) -
           (a[axes.v] - from[axes.v]) * (b[axes.u] - from[axes.u]);
  };
  constexpr std::size_t kSteps = 1000;  // a place is never far in terms of the triangles on the way
  Index last = kNone;
  for (std::size_t steps = 0; steps < kSteps; ++steps) {
    const Triangle& here = triangles_[t];
    Index exit = kNone;
    for (Index k = 0; k < 3; ++k) {
      if (here.next[k] != kNone && here.next[k] == last) continue;
      const Index a = here.points[(k + 1) % 3], b = here.points[(k + 2) % 3];
      if (orient2d(axes, table_.view(VertexId(a)), table_.view(VertexId(b)), target) >= 0) continue;
      exit = k;
      if (area(to, xyz_[a]) <= 0 && area(to, xyz_[b]) >= 0) break;  // the straight way leads through this side
    }
    if (exit == kNone) return {t, kNone};
    if (here.segments[exit] != kNone) return {kNone, here.segments[exit]};
    last = std::exchange(t, here.next[exit]);
  }
  return {};
}

FacetMesh::Cavity FacetMesh::cavity(Index triangle, const Vector& at) const {
  std::vector<Index> open{triangle};
  std::unordered_set<Index> seen{triangle};
  Cavity result{{}, HUGE_VAL};
  while (!open.empty()) {
    const Index t = open.back();
    open.pop_back();
    for (Index k = 0; k < 3; ++k) {
      result.nearest = std::min(result.nearest, distance(xyz_[triangles_[t].points[k]], at));
      if (triangles_[t].segments[k] != kNone) {
        result.segments.push_back(triangles_[t].segments[k]);
        continue;
      }
      const Index u = triangles_[t].next[k];
      if (!seen.insert(u).second) continue;
      const Triangle& there = triangles_[u];
      const Index l = side_of(u, t);
      const bool inside = delaunay(there.facet, there.points[(l + 1) % 3], there.points[(l + 2) % 3],
                                   xyz_[there.points[l]], at) < 0;
      if (inside) open.push_back(u);
    }
  }
  auto& list = result.segments;
  sort_unique(list);
  return result;
}

std::vector<Index> FacetMesh::add_images() {
  std::vector<Index> sources;
  std::map<Vector, Index> known;  // points on far sides; the last where one is of no use
  for (Index p = 0; sides_.any() && p < xyz_.size(); ++p)
    if (sides_.at(sides_.far, xyz_, std::array{p}) != PeriodicAxes{}) known[xyz_[p]] = p;
  std::unordered_map<Index, const PeriodicFaces*> images;  // by the near face
  for (const PeriodicFaces& image : images_) images.emplace(image.near, &image);
  for (Index t = 0, count = Index(triangles_.size()); t < count; ++t) {
    const Facet& facet = facets_[triangles_[t].facet];
    const auto found = images.find(facet.face);
    if (found == images.end()) continue;
    const auto& [near, far, axis] = *found->second;
    Triangle image{triangles_[t].points, {kNone, kNone, kNone}, {kNone, kNone, kNone}, first_facet(far)};
    for (Index& p : image.points) {
      Vector at = xyz_[p];
      at[axis] = sides_.far[axis];
      const auto [it, is_new] = known.try_emplace(at, Index(xyz_.size()));
      p = is_new ? add_point(at) : it->second;
    }
    if (dot(facet.normal, facets_[image.facet].normal) < 0) std::swap(image.points[1], image.points[2]);
    triangles_.push_back(image);
    sources.push_back(t);
  }
  return sources;
}

}  // namespace cnrg
