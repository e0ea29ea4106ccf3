// Disjoint sets of the 3-cells, joined across every face that is no wall; the cost is that of their boundaries.
#include "csg/operators/detect_regions.h"

#include "kernel/base/union_find.h"
#include "kernel/selection/scratch.h"

namespace cnrg {

std::vector<std::pair<RegionId, std::uint32_t>> detect_regions(const Complex& complex,
                                                               const std::vector<RegionId>& inside,
                                                               const std::vector<FaceId>& walls) {
  Scratch<RegionId, std::uint32_t> place(complex.region_count);  // 1 + index into `inside`
  Marks<FaceId> wall(complex.face_count());
  for (std::size_t i = 0; i < inside.size(); ++i) place[inside[i]] = static_cast<std::uint32_t>(i + 1);
  for (FaceId f : walls) wall[f] = 1;
  UnionFind sets(inside.size());
  for (std::size_t i = 0; i < inside.size(); ++i) {
    for (HalfFace h : complex.region_faces[inside[i]]) {
      if (h.side() != 0 || wall[h.face()]) continue;
      if (const auto other = place[complex.region(h.opposite())]) {
        sets.unite(static_cast<std::uint32_t>(i), other - 1);
      }
    }
  }
  std::vector<std::pair<RegionId, std::uint32_t>> out;
  std::vector<std::uint32_t> number(inside.size(), 0);
  std::uint32_t count = 0;
  out.reserve(inside.size());
  for (std::size_t i = 0; i < inside.size(); ++i) {
    std::uint32_t& n = number[sets.find(static_cast<std::uint32_t>(i))];
    if (n == 0) n = ++count;
    out.emplace_back(inside[i], n);
  }
  return out;
}

}  // namespace cnrg
