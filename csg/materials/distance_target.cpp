// Distances are measured to triangles, segments and points: faces are triangulated, edges and vertices stand for
// themselves where no face or edge has them.
#include "csg/materials/distance_target.h"

#include "kernel/exact/triangulate.h"

namespace cnrg {

void TargetBuilder::add(FaceId f) {
  std::vector<std::vector<VertexId>> walks;
  for (const LoopId l : complex_.face_loops[f]) {
    auto& walk = walks.emplace_back();
    for (const HalfEdge h : complex_.loop[l]) {
      walk.push_back(complex_.origin(h));
      on_face_[h.edge().index()] = 1;
    }
  }
  const Projection axes = projection_of(complex_.points, complex_.plane(f));
  for (const auto& t : triangulate(complex_.points, axes, walks)) add(t);
}

void TargetBuilder::add(const std::array<VertexId, 3>& t) {
  target_.triangles.push_back({number(t[0]), number(t[1]), number(t[2])});
}

void TargetBuilder::add(EdgeId e) {
  if (on_face_[e.index()]) return;
  const auto& [a, b] = complex_.edge_ends[e];
  target_.segments.push_back({number(a), number(b)});
}

void TargetBuilder::add(VertexId v) {
  if (numbers_.count(v) == 0) target_.vertices.push_back({number(v)});
}

std::optional<DistanceTarget> TargetBuilder::take() {
  if (unbounded_) return std::nullopt;
  return std::move(target_);
}

std::uint32_t TargetBuilder::number(VertexId v) {
  unbounded_ = unbounded_ || complex_.on_frame(v);
  const auto [it, fresh] = numbers_.try_emplace(v, static_cast<std::uint32_t>(target_.points.size()));
  if (fresh) target_.points.push_back(complex_.points.rational(v));
  return it->second;
}

}  // namespace cnrg
