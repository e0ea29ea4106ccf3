#include "kernel/tetrahedra/constrained.h"

#include <algorithm>
#include <map>

#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/tetrahedra/segments.h"
#include "kernel/tetrahedra/walls.h"

namespace cnrg {

ConstrainedTetrahedra constrained_tetrahedra(PointTable& points, std::span<const std::array<VertexId, 2>> segments,
                                             std::span<const std::array<VertexId, 3>> triangles,
                                             const Watch& watch) {
  using Ends = std::array<VertexId, 2>;
  const auto ends = [](VertexId a, VertexId b) { return Ends{std::min(a, b), std::max(a, b)}; };
  std::vector<Ends> all;
  for (const auto& [a, b] : segments) all.push_back(ends(a, b));
  for (const auto& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) all.push_back(ends(t[k], t[(k + 1) % 3]));
  }
  sort_unique(all);
  const auto place = [&](VertexId a, VertexId b) {
    const auto at = std::lower_bound(all.begin(), all.end(), ends(a, b));
    return static_cast<SegmentChains::Index>(at - all.begin());
  };

  watch.begin("tetrahedra: points");
  Tetrahedra tetrahedra(points);
  watch.begin("tetrahedra: segments");
  SegmentChains chains(points, tetrahedra, all);
  chains.run(watch);
  const auto chain = [&](VertexId a, VertexId b) {
    std::vector<VertexId> list = chains.chain(place(a, b));
    if (list.front() != a) std::reverse(list.begin(), list.end());
    return list;
  };

  ConstrainedTetrahedra out;
  for (ConstrainedTetrahedra::Index i = 0; i < segments.size(); ++i) {
    const std::vector<VertexId> list = chain(segments[i][0], segments[i][1]);
    for (std::size_t k = 0; k + 1 < list.size(); ++k) out.segments.push_back({{list[k], list[k + 1]}, i});
  }
  Walls walls(points, tetrahedra);
  Steps steps(watch, "tetrahedra: triangles", triangles.size());
  for (ConstrainedTetrahedra::Index i = 0; i < triangles.size(); ++i) {
    std::vector<VertexId> border;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::vector<VertexId> side = chain(triangles[i][k], triangles[i][(k + 1) % 3]);
      border.insert(border.end(), side.begin(), side.end() - 1);
    }
    for (const auto& corners : walls.insert(triangles[i], border)) out.triangles.push_back({corners, i});
    steps.step();
  }
  for (Tetrahedra::Index t = 0; t < tetrahedra.size(); ++t) {
    if (tetrahedra.alive(t)) out.tetrahedra.push_back(tetrahedra.corners(t));
  }
  return out;
}

}  // namespace cnrg
