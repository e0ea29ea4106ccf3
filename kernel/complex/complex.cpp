// Stars and closures, read from the arrays of incidence, and points in the interior of edges and faces.
#include "kernel/complex/complex.h"

#include "kernel/base/error.h"
#include "kernel/base/sorted.h"

namespace cnrg {

namespace {

const Rational& at(const RationalPoint& p, int k) { return p[static_cast<std::size_t>(k)]; }

}  // namespace

RegionId Complex::some_region(EdgeId e) const {
  const auto uses = edge_uses[e];
  return uses.empty() ? edge_region[e] : face_regions[uses[0].face][0];
}

RegionId Complex::some_region(VertexId v) const {
  const auto edges = vertex_edges[v];
  if (!edges.empty()) return some_region(edges[0]);
  const auto faces = vertex_faces[v];
  return faces.empty() ? vertex_region[v] : face_regions[faces[0]][0];
}

void Complex::star_faces(EdgeId e, std::vector<FaceId>& out) const {
  out.clear();
  for (const FaceUse& u : edge_uses[e]) out.push_back(u.face);
  sort_unique(out);
}

void Complex::star_faces(VertexId v, std::vector<FaceId>& out) const {
  out.assign(vertex_faces[v].begin(), vertex_faces[v].end());
  for (const EdgeId e : vertex_edges[v]) {
    for (const FaceUse& u : edge_uses[e]) out.push_back(u.face);
  }
  sort_unique(out);
}

void Complex::star_regions(EdgeId e, std::vector<RegionId>& out) const {
  out.clear();
  if (edge_region[e].valid()) out.push_back(edge_region[e]);
  for (const FaceUse& u : edge_uses[e])
    out.insert(out.end(), face_regions[u.face].begin(), face_regions[u.face].end());
  sort_unique(out);
}

void Complex::star_regions(VertexId v, std::vector<RegionId>& out) const {
  out.clear();
  if (vertex_region[v].valid()) out.push_back(vertex_region[v]);
  for (const FaceId f : vertex_faces[v]) out.insert(out.end(), face_regions[f].begin(), face_regions[f].end());
  for (const EdgeId e : vertex_edges[v]) {
    if (edge_region[e].valid()) out.push_back(edge_region[e]);
    for (const FaceUse& u : edge_uses[e])
      out.insert(out.end(), face_regions[u.face].begin(), face_regions[u.face].end());
  }
  sort_unique(out);
}

void Complex::closure_edges(FaceId f, std::vector<EdgeId>& out) const {
  out.clear();
  for (const HalfEdge h : half_edges(f)) out.push_back(h.edge());
  sort_unique(out);
}

ExactPoint interior_point(const Complex& complex, EdgeId e) {
  const auto [a, b] = complex.edge_ends[e];
  const RationalPoint p = complex.points.rational(a), q = complex.points.rational(b);
  RationalPoint m;
  for (std::size_t k = 0; k < 3; ++k) m[k] = (p[k] + q[k]) / 2;
  return ExactPoint::from(m);
}

/// Of a triangle the centroid. Else go inward from the middle of a side, perpendicular in the projection, half the
/// way to the first point of the boundary.
ExactPoint interior_point(const Complex& complex, FaceId f) {
  const PointTable& t = complex.points;
  const auto outer = complex.loop[complex.face_loops[f].front()];
  if (complex.face_loops[f].size() == 1 && outer.size() == 3 && complex.face_vertices[f].empty()) {
    RationalPoint m{0, 0, 0};
    for (const HalfEdge h : outer) {
      const RationalPoint p = t.rational(complex.origin(h));
      for (std::size_t k = 0; k < 3; ++k) m[k] += p[k] / 3;
    }
    return ExactPoint::from(m);
  }
  const Projection axes = complex.sheet_projection[complex.face_sheet[f]];
  const int u = axes.u, v = axes.v, w = 3 - u - v;
  const RationalPoint a = t.rational(complex.origin(outer[0])), b = t.rational(complex.target(outer[0]));
  const Rational mu = (at(a, u) + at(b, u)) / 2, mv = (at(a, v) + at(b, v)) / 2;
  const Rational du = at(a, v) - at(b, v), dv = at(b, u) - at(a, u);  // to the left of the side
  Rational nearest = -1;
  const auto consider = [&](const Rational& s) {
    if (sgn(s) > 0 && (sgn(nearest) < 0 || s < nearest)) nearest = s;
  };
  // Coordinates along the ray (s, in units of d) and across it.
  const Rational length = du * du + dv * dv;
  const auto along = [&](const RationalPoint& p) -> Rational {
    return ((at(p, u) - mu) * du + (at(p, v) - mv) * dv) / length;
  };
  const auto across = [&](const RationalPoint& p) -> Rational {
    return du * (at(p, v) - mv) - dv * (at(p, u) - mu);
  };
  for (const HalfEdge h : complex.half_edges(f)) {
    if (h.edge() == outer[0].edge()) continue;
    const RationalPoint p = t.rational(complex.origin(h)), q = t.rational(complex.target(h));
    const Rational cp = across(p), cq = across(q);
    if (sgn(cp) == 0) consider(along(p));
    if (sgn(cq) == 0) consider(along(q));
    if (sgn(cp) * sgn(cq) < 0) consider((along(p) * cq - along(q) * cp) / (cq - cp));
  }
  for (const VertexId x : complex.face_vertices[f]) {
    const RationalPoint p = t.rational(x);
    if (sgn(across(p)) == 0) consider(along(p));
  }
  require(sgn(nearest) > 0, "a face is not closed");
  RationalPoint m;
  m[static_cast<std::size_t>(u)] = mu + du * nearest / 2;
  m[static_cast<std::size_t>(v)] = mv + dv * nearest / 2;
  const ExactPlane& e = t.exact_plane(complex.plane(f));
  const Integer* n[3] = {&e.a, &e.b, &e.c};
  m[static_cast<std::size_t>(w)] =
      -(Rational(*n[u]) * at(m, u) + Rational(*n[v]) * at(m, v) + Rational(e.d)) / Rational(*n[w]);
  return ExactPoint::from(m);
}

}  // namespace cnrg
