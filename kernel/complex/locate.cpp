// Point location: vertices whose boxes hold the point are tested exactly, then edges, then faces; off all of them
// a ray tells the region.

#include "kernel/complex/ray.h"
#include "kernel/exact/predicates.h"

namespace cnrg {

struct Locator::Data {
  const Complex& c;
  RayCaster caster;
  BoxTree edges, vertices;
  std::vector<VertexId> vertex_ids;
  explicit Data(const Complex& complex);
};

namespace {

std::vector<Box> edge_boxes(const Complex& c) {
  std::vector<Box> boxes(c.edge_count());
  for (const EdgeId e : IdRange<EdgeId>(c.edge_count())) {
    for (const VertexId v : c.edge_ends[e]) {
      const PointView p = c.points.view(v);
      boxes[e.index()].extend(p.lo, p.hi);
    }
  }
  return boxes;
}

std::vector<Box> vertex_boxes(const Complex& c) {
  std::vector<Box> boxes;
  for (const VertexId v : c.vertices) {
    const PointView p = c.points.view(v);
    boxes.push_back(Box{p.lo, p.hi});
  }
  return boxes;
}

bool on_line(const PointView& a, const PointView& b, const PointView& p) {
  return orient2d({0, 1}, a, b, p) == 0 && orient2d({1, 2}, a, b, p) == 0 && orient2d({2, 0}, a, b, p) == 0;
}

/// For a point in the plane of the face and on no edge or vertex: is it in the face?
bool in_face(const Complex& c, FaceId f, const PointView& p) {
  const Projection axes = c.sheet_projection[c.face_sheet[f]];
  bool inside = false;
  for (const HalfEdge h : c.half_edges(f)) {
    const PointView a = c.points.view(c.origin(h)), b = c.points.view(c.target(h));
    const int ca = compare(axes.v, a, p), cb = compare(axes.v, b, p);
    if ((ca <= 0) == (cb <= 0)) continue;
    const int o = ca < cb ? orient2d(axes, a, b, p) : orient2d(axes, b, a, p);
    if (o > 0) inside = !inside;
  }
  return inside;
}

}  // namespace

Locator::Data::Data(const Complex& complex)
    : c(complex),
      caster(complex, true),
      edges(edge_boxes(complex)),
      vertices(vertex_boxes(complex)),
      vertex_ids(complex.vertices) {}

Locator::Locator(const Complex& complex) : data_(std::make_unique<Data>(complex)) {}
Locator::~Locator() = default;

Location Locator::locate(const RationalPoint& point) const {
  const Complex& c = data_->c;
  const ExactPoint exact = ExactPoint::from(point);
  const PointView p = view_of(exact);
  const Box own{p.lo, p.hi};
  const auto near = [&](const Box& box) { return box.meets(own); };
  Location found;
  data_->vertices.query(near, [&](std::uint32_t i) {
    const VertexId v = data_->vertex_ids[i];
    if (!found.vertex.valid() && compare_lex(c.points.view(v), p) == 0) found.vertex = v;
  });
  if (found.vertex.valid()) {
    found.dimension = 0;
    return found;
  }
  data_->edges.query(near, [&](std::uint32_t i) {
    const EdgeId e(i);
    if (found.edge.valid()) return;
    const PointView a = c.points.view(c.edge_ends[e][0]), b = c.points.view(c.edge_ends[e][1]);
    if (on_line(a, b, p) && compare_lex(a, p) < 0 && compare_lex(p, b) < 0) found.edge = e;
  });
  if (found.edge.valid()) {
    found.dimension = 1;
    return found;
  }
  data_->caster.faces().query(near, [&](std::uint32_t i) {
    const FaceId f(i);
    if (!found.face.valid() && side_of_plane(c.points, c.plane(f), p) == 0 && in_face(c, f, p)) found.face = f;
  });
  if (found.face.valid()) {
    found.dimension = 2;
    return found;
  }
  const RayCaster::Ray ray = data_->caster.cast(exact);
  found.region = ray.hits.empty() ? RegionId(0) : c.region(ray.hits.front());
  return found;
}

}  // namespace cnrg
