// A Boolean of two groups is a fold of two (table_engine.h); complement and regularization need no table.
#include "csg/operators/boolean.h"

#include <algorithm>

#include "csg/operators/detect_regions.h"
#include "csg/operators/table_engine.h"
#include "kernel/base/sorted.h"
#include "kernel/selection/scratch.h"

namespace cnrg {
namespace {

// Completes `out`, whose faces are some of `g`: takes the edges, vertices and features in their closure, and all
// origins.
void keep_walls(const Complex& complex, const Group& g, Group& out) {
  Marks<EdgeId> edges(complex.edge_count());
  Marks<VertexId> vertices(complex.points.size());
  for (FaceId f : out.faces) {
    for (LoopId l : complex.face_loops[f]) {
      for (HalfEdge h : complex.loop[l]) {
        edges[h.edge()] = 1;
        vertices[complex.origin(h)] = 1;
      }
    }
    for (VertexId v : complex.face_vertices[f]) vertices[v] = 1;
  }
  LeafSetMap map(g.origins.sets, out.origins.sets);
  const auto pick = [&](const auto& from, const auto& from_origins, const auto& marks, auto& to, auto& origins) {
    for (std::size_t k = 0; k < from.size(); ++k) {
      if (!marks[from[k]]) continue;
      to.push_back(from[k]);
      origins.push_back(map(from_origins[k]));
    }
  };
  pick(g.edges, g.origins.edges, edges, out.edges, out.origins.edges);
  pick(g.vertices, g.origins.vertices, vertices, out.vertices, out.origins.vertices);
  std::size_t k = 0;
  for (FaceId f : out.faces) {
    while (g.faces[k] != f) ++k;
    out.origins.faces.push_back(map(g.origins.faces[k]));
  }
  const auto still = [](const auto& from, const auto& marks, auto& to) {
    for (auto id : from) {
      if (marks[id]) to.push_back(id);
    }
  };
  still(g.features.edges, edges, out.features.edges);
  still(g.features.vertices, vertices, out.features.vertices);
  out.dominance = g.dominance;
}

}  // namespace

BooleanResult boolean_operation(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left,
                                const Group& right) {
  const Group* const first[] = {&left};
  const Group* const next[] = {&right};
  TableEngine engine(complex, op, first);
  FoldStep step;
  engine.step(dominance, next, step);
  BooleanResult out;
  out.group = engine.group();
  out.group.dominance = std::max(left.dominance, right.dominance);
  for (const auto& [row, count] : step.removed) out.removals.add(row, count);
  for (auto& [region, conflict] : step.conflicts) out.conflicts.push_back(std::move(conflict));
  return out;
}

Group complement(const Complex& complex, const Group& g) {
  Group out;
  Marks<RegionId> held(complex.region_count);
  for (const auto& [cell, region] : g.cells) held[cell] = 1;
  std::vector<RegionId> inside;
  for (RegionId r : IdRange<RegionId>(complex.region_count)) {
    if (!held.get(r) && !complex.outside_frame(r)) inside.push_back(r);
  }
  for (FaceId f : g.faces) {
    const auto& [front, back] = complex.face_regions[f];
    if (held.get(front) != held.get(back)) out.faces.push_back(f);
  }
  keep_walls(complex, g, out);
  out.cells = detect_regions(complex, inside, out.faces);
  std::vector<LeafId> leaves;
  for (const RegionAttributes& region : g.regions) {
    leaves.insert(leaves.end(), region.leaves.begin(), region.leaves.end());
  }
  sort_unique(leaves);
  std::uint32_t count = 0;
  for (const auto& [cell, region] : out.cells) count = std::max(count, region);
  out.regions.assign(count, {{}, leaves});
  return out;
}

Group regularize(const Complex& complex, const Group& g) {
  Group out;
  Scratch<RegionId, std::uint32_t> region(complex.region_count);
  for (const auto& [cell, number] : g.cells) region[cell] = number;
  for (FaceId f : g.faces) {
    const auto& [front, back] = complex.face_regions[f];
    if (region.get(front) != region.get(back)) out.faces.push_back(f);
  }
  keep_walls(complex, g, out);
  out.cells = g.cells;
  out.regions = g.regions;
  return out;
}

}  // namespace cnrg
