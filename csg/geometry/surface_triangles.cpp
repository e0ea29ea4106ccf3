// The surface is simplified as a set of points; its faces are cut into triangles from their loops in a canonical
// form.
#include "csg/geometry/surface_triangles.h"

#include <algorithm>

#include "csg/geometry/canonical_loop.h"
#include "kernel/exact/triangulate.h"
#include "kernel/selection/canonical.h"

namespace cnrg {
namespace {

using Numbers = std::vector<std::uint32_t>;

/// In the direction in which it is less.
Numbers loop_of(const Complex& complex, const CanonicalPoints& order, std::span<const HalfEdge> walk) {
  Numbers loop;
  for (const HalfEdge h : walk) {
    const std::uint32_t number = order.number(complex.origin(h));
    if (number != CanonicalPoints::kNone) loop.push_back(number);
  }
  Numbers back(loop.rbegin(), loop.rend());
  rotate_to_least(loop);
  rotate_to_least(back);
  return std::min(loop, back);
}

SimplifiedComplex simplified(const Complex& complex, const std::vector<FaceId>& faces) {
  const CellSet cells = closure(complex, {{}, {}, faces, {}});
  Selection all;
  for (const VertexId v : cells.vertices) all.vertices.emplace_back(v, 1);
  for (const EdgeId e : cells.edges) all.edges.emplace_back(e, 1);
  for (const FaceId f : cells.faces) all.faces.emplace_back(f, 1);
  return simplify(complex, all, {}, SimplifyMode::points);
}

}  // namespace

std::vector<std::array<VertexId, 3>> surface_triangles(const Complex& complex, const std::vector<FaceId>& faces,
                                                       const LeafAxes* axes) {
  SimplifiedComplex whole = simplified(complex, faces);
  const CanonicalPoints order = put_in_order(complex, whole, axes);
  std::vector<std::array<VertexId, 3>> out;
  for (const auto& face : whole.faces) {
    std::vector<Numbers> loops;
    for (const auto& walk : face.loops) loops.push_back(loop_of(complex, order, walk));
    std::sort(loops.begin(), loops.end());
    std::vector<std::vector<VertexId>> walks;
    for (const Numbers& loop : loops) {
      auto& walk = walks.emplace_back();
      for (const std::uint32_t p : loop) walk.push_back(order.points()[p]);
    }
    Projection plan = projection_of(complex.points.exact_plane(complex.plane(face.cells[0].face())));
    if (plan.v != (plan.u + 1) % 3) std::swap(plan.u, plan.v);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto& t : triangulate(complex.points, plan, walks)) {
      auto& numbers = triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) numbers[k] = order.number(t[k]);
      std::rotate(numbers.begin(), std::min_element(numbers.begin(), numbers.end()), numbers.end());
    }
    std::sort(triangles.begin(), triangles.end());
    for (const auto& [a, b, c] : triangles)
      out.push_back({order.points()[a], order.points()[b], order.points()[c]});
  }
  return out;
}

}  // namespace cnrg
