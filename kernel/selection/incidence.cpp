// Links are set algebra on stars and closures, radial order is an array of the complex. Shells are not stored as
// such: they are joined again from neighbours in radial order.
#include "kernel/selection/incidence.h"

#include <algorithm>
#include <map>

#include "kernel/base/sorted.h"
#include "kernel/base/union_find.h"

namespace cnrg {

CellSet link(const Complex& complex, const CellSet& set) {
  const CellSet closed = closure(complex, set);
  return subtract(closure(complex, star(complex, set)), star(complex, closed));
}

std::vector<RadialStep> radial_order(const Complex& complex, EdgeId e) {
  std::vector<RadialStep> out;
  for (const FaceUse& use : complex.edge_uses[e]) {
    const unsigned ahead = use.half_edge.direction();  // the side that looks counter-clockwise
    out.push_back({HalfFace(use.face, 1 - ahead), complex.face_regions[use.face][ahead]});
  }
  return out;
}

std::string radial_order_text(const Complex& complex, EdgeId e) {
  const auto steps = radial_order(complex, e);
  if (steps.empty()) return "a wire in r" + std::to_string(complex.edge_region[e].value());
  std::string out;
  for (const RadialStep& step : steps) {
    if (!out.empty()) out += ", ";
    out += "f" + std::to_string(step.face.face().value());
    out += (step.face.side() == 0 ? " (front), r" : " (back), r") + std::to_string(step.region.value());
  }
  return out;
}

std::vector<std::vector<HalfFace>> shells(const Complex& complex, RegionId r) {
  std::vector<HalfFace> sides(complex.region_faces[r].begin(), complex.region_faces[r].end());
  sort_unique(sides);
  const auto place = [&](HalfFace h) {
    return static_cast<std::uint32_t>(std::lower_bound(sides.begin(), sides.end(), h) - sides.begin());
  };
  std::vector<EdgeId> edges;
  for (HalfFace h : sides) {
    for (LoopId l : complex.face_loops[h.face()]) {
      for (HalfEdge step : complex.loop[l]) edges.push_back(step.edge());
    }
  }
  sort_unique(edges);
  UnionFind sets(sides.size());
  for (EdgeId e : edges) {
    const auto uses = complex.edge_uses[e];
    for (std::size_t i = 0; i < uses.size(); ++i) {
      const FaceUse &use = uses[i], &after = uses[(i + 1) % uses.size()];
      const HalfFace side(use.face, use.half_edge.direction());
      if (complex.region(side) != r) continue;
      sets.unite(place(side), place(HalfFace(after.face, 1 - after.half_edge.direction())));
    }
  }
  std::vector<std::vector<HalfFace>> out;
  std::map<std::uint32_t, std::size_t> number;
  for (std::uint32_t i = 0; i < sides.size(); ++i) {
    const auto [at, fresh] = number.try_emplace(sets.find(i), out.size());
    if (fresh) out.emplace_back();
    out[at->second].push_back(sides[i]);
  }
  return out;
}

}  // namespace cnrg
