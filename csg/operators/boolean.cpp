// A Boolean of two groups is a fold of two (table_engine.h); complement and regularization need no table.
#include "csg/operators/boolean.h"

#include <algorithm>

#include "csg/operators/detect_regions.h"
#include "csg/operators/subgroup.h"
#include "csg/operators/table_engine.h"
#include "kernel/base/sorted.h"
#include "kernel/selection/scratch.h"

namespace cnrg {
namespace {

// A group of some faces of `g` with all that bounds them; regions are none.
Group walls_of(const Complex& complex, const Group& g, const std::vector<FaceId>& faces) {
  WantedEntities wanted(complex);
  for (const FaceId f : faces) wanted.add(f);
  return wanted.of(g);
}

}  // namespace

BooleanResult boolean_operation(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left,
                                const Group& right) {
  const Group* const first[] = {&left};
  const Group* const next[] = {&right};
  const LeafOrder order;
  TableEngine engine(complex, op, first, order);
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
  std::vector<FaceId> walls;
  Marks<RegionId> held(complex.region_count);
  for (const auto& [cell, region] : g.cells) held[cell] = 1;
  std::vector<RegionId> inside;
  for (RegionId r : IdRange<RegionId>(complex.region_count)) {
    if (!held.get(r) && !complex.outside_frame(r)) inside.push_back(r);
  }
  for (FaceId f : g.faces) {
    const auto& [front, back] = complex.face_regions[f];
    if (held.get(front) != held.get(back)) walls.push_back(f);
  }
  Group out = walls_of(complex, g, walls);
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
  std::vector<FaceId> walls;
  Scratch<RegionId, std::uint32_t> region(complex.region_count);
  for (const auto& [cell, number] : g.cells) region[cell] = number;
  for (FaceId f : g.faces) {
    const auto& [front, back] = complex.face_regions[f];
    if (region.get(front) != region.get(back)) walls.push_back(f);
  }
  Group out = walls_of(complex, g, walls);
  out.cells = g.cells;
  out.regions = g.regions;
  return out;
}

}  // namespace cnrg
