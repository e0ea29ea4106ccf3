#include "tests/scenes/measure.h"

#include <algorithm>
#include <stdexcept>

namespace cnrg::scenes {
namespace {

Rational dot(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

RationalPoint between(const RationalPoint& a, const RationalPoint& b, const Rational& t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

template <class Visit>
void for_each_half_edge(const Complex& c, FaceId f, Visit visit) {
  for (const LoopId l : c.face_loops[f])
    for (const HalfEdge h : c.loop[l]) visit(c.points.rational(c.origin(h)), c.points.rational(c.target(h)));
}

/// Twice the vector area of a face; it points to the front.
RationalPoint vector_area(const Complex& c, FaceId f) {
  RationalPoint sum{0, 0, 0};
  for_each_half_edge(c, f, [&](const RationalPoint& p, const RationalPoint& q) {
    const RationalPoint n = cross(p, q);
    for (int k = 0; k < 3; ++k) sum[k] += n[k];
  });
  return sum;
}

RationalPoint corner(const Complex& c, FaceId f) {
  return c.points.rational(c.origin(c.loop[c.face_loops[f][0]][0]));
}

}  // namespace

Rational volume(const Complex& complex, RegionId region) {
  std::vector<Rational> parts;
  for (const HalfFace h : complex.region_faces[region]) {
    const Rational part = dot(corner(complex, h.face()), vector_area(complex, h.face()));
    // The region lies in front of side 0, so that the front normal points into it.
    parts.push_back(h.side() == 0 ? Rational(-part) : part);
  }
  return sum(std::move(parts)) / 6;
}

std::vector<Rational> volumes(const Complex& complex) {
  std::vector<Rational> all;
  for (const RegionId r : IdRange<RegionId>(complex.region_count))
    if (!complex.unbounded(r)) all.push_back(volume(complex, r));
  std::sort(all.begin(), all.end());
  return all;
}

RationalPoint point_in(const Complex& complex, EdgeId e) {
  const auto [a, b] = complex.edge_ends[e];
  return between(complex.points.rational(a), complex.points.rational(b), Rational(1, 2));
}

RationalPoint point_in(const Complex& complex, FaceId f) {
  // A line across the face that misses every vertex: its first piece inside lies between the first two crossings.
  const RationalPoint normal = vector_area(complex, f);
  const int w = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2, u = (w + 1) % 3, v = (w + 2) % 3;
  std::vector<Rational> heights;
  for_each_half_edge(complex, f, [&](const RationalPoint& p, const RationalPoint&) { heights.push_back(p[v]); });
  for (const VertexId x : complex.face_vertices[f]) heights.push_back(complex.points.rational(x)[v]);
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  const Rational height = (heights[0] + heights[1]) / 2;
  std::vector<std::pair<Rational, RationalPoint>> crossings;
  for_each_half_edge(complex, f, [&](const RationalPoint& p, const RationalPoint& q) {
    if ((p[v] < height) == (q[v] < height)) return;
    const RationalPoint at = between(p, q, (height - p[v]) / (q[v] - p[v]));
    crossings.emplace_back(at[u], at);
  });
  std::sort(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    if (crossings[i].first != crossings[i + 1].first)
      return between(crossings[i].second, crossings[i + 1].second, Rational(1, 2));
  throw std::logic_error("a face without area");
}

RationalPoint point_in(const Complex& complex, RegionId r) {
  if (complex.region_faces[r].empty()) {
    // Space without faces: beyond every vertex.
    RationalPoint p{0, 0, 0};
    for (const VertexId v : complex.vertices)
      for (int k = 0; k < 3; ++k) p[k] = std::max<Rational>(p[k], complex.points.rational(v)[k] + 1);
    return p;
  }
  const HalfFace h = complex.region_faces[r].front();
  const RationalPoint from = point_in(complex, h.face());
  RationalPoint normal = vector_area(complex, h.face());
  if (h.side() == 1)
    for (Rational& x : normal) x = -x;
  // A direction into the region that lies in no supporting plane through `from`; it is followed no further than
  // the first supporting plane, so that no face lies between.
  Rational nearest;
  RationalPoint along;
  for (int attempt = 1;; ++attempt) {
    const RationalPoint aside{Rational(attempt, 7), Rational(attempt * attempt, 11), Rational(1, 13)};
    along = normal;
    const Rational scale = dot(normal, normal) / (1 + 1000 * abs(dot(normal, aside)));
    for (int k = 0; k < 3; ++k) along[k] += aside[k] * scale;
    nearest = 1;
    bool generic = true;
    for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
      const RationalPoint n = vector_area(complex, f);
      const Rational slope = dot(n, along), height = dot(n, corner(complex, f)) - dot(n, from);
      if (slope == 0) {
        generic = generic && height != 0;
        continue;
      }
      const Rational t = height / slope;
      if (t > 0 && t < nearest) nearest = t;
    }
    if (generic) break;
  }
  RationalPoint p;
  for (int k = 0; k < 3; ++k) p[k] = from[k] + along[k] * nearest * Rational(7919, 20011);
  return p;
}

}  // namespace cnrg::scenes
