// A point that is on no face of the other group lies in the region that its first hit looks into, whatever other
// cells the ray passes on its way; a ray that hits nothing ends in the unbounded region. Faces of the frame are
// hit too: beyond them nothing is located.
#include "tests/oracles/paper_classification.h"

#include "kernel/complex/ray.h"

namespace cnrg {
namespace {

class PointLocation {
 public:
  PointLocation(const Complex& complex, const Group& other)
      : complex_(complex), caster_(complex, true), other_(other), accept_(complex.face_count(), 0) {
    for (FaceId f : other.faces) accept_[f.index()] = 1;
    if (!complex.frame.valid()) return;
    for (FaceId f : IdRange<FaceId>(complex.face_count())) {
      if (complex.on_frame(f)) accept_[f.index()] = 1;
    }
  }
  Classification operator()(const RationalPoint& p) const {
    const RayCaster::Ray ray = caster_.cast(ExactPoint::from(p), FaceId::none(), accept_);
    const RegionId seen = ray.hits.empty() ? RegionId(0) : complex_.region(ray.hits.front());
    return other_.region_of(seen) != 0 ? Classification::in : Classification::out;
  }

 private:
  const Complex& complex_;
  RayCaster caster_;
  const Group& other_;
  std::vector<char> accept_;
};

}  // namespace

GroupClassification classify_by_location(const Complex& complex, const Group& group, const Group& other) {
  const PointLocation locate(complex, other);
  GroupClassification out;
  IdVector<VertexId, Classification> of_vertex(complex.points.size(), Classification::inters);
  for (VertexId v : group.vertices) {
    if (!other.has(v)) of_vertex[v] = locate(complex.points.rational(v));
    out.vertices.push_back(of_vertex[v]);
  }
  for (EdgeId e : group.edges) {
    Classification c = Classification::inters;
    if (!other.has(e)) {
      for (VertexId v : complex.edge_ends[e]) {
        if (c == Classification::inters && !complex.on_frame(v)) c = of_vertex[v];
      }
      if (c == Classification::inters) c = locate(interior_point(complex, e).rational());
    }
    out.edges.push_back(c);
  }
  for (FaceId f : group.faces) {
    Classification c = Classification::inters;
    if (!other.has(f)) {
      for (HalfEdge h : complex.loop[complex.face_loops[f][0]]) {
        const VertexId v = complex.origin(h);
        if (c == Classification::inters && !complex.on_frame(v)) c = of_vertex[v];
      }
      if (c == Classification::inters) c = locate(interior_point(complex, f).rational());
    }
    out.faces.push_back(c);
  }
  return out;
}

GroupClassification classify_by_propagation(const Complex& complex, const Group& group, const Group& other) {
  const auto classify = [&](auto cell) {
    if (other.has(cell)) return Classification::inters;
    return other.region_of(complex.some_region(cell)) != 0 ? Classification::in : Classification::out;
  };
  GroupClassification out;
  for (VertexId v : group.vertices) out.vertices.push_back(classify(v));
  for (EdgeId e : group.edges) out.edges.push_back(classify(e));
  for (FaceId f : group.faces) out.faces.push_back(classify(f));
  return out;
}

}  // namespace cnrg
