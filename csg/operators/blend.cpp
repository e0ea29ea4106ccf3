// Boundaries are looked up once for each region of an operand, however many regions of the other one it meets.
#include "csg/operators/blend.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "csg/geometry/surface_triangles.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/materials/distance_target.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

FoldResult fold(const Complex& complex, BooleanOp op, Dominance dominance, PartedGroup a, PartedGroup b,
                const LeafOrder& order) {
  return boolean_fold(complex, op, std::span(&dominance, 1), {std::move(a), std::move(b)}, order);
}

/// An operand, asked for the boundaries of its regions.
class BlendSide {
 public:
  BlendSide(const Complex& complex, const Group& group, const Transform& back)
      : complex_(complex), group_(group), back_(back) {}

  std::uint32_t region_of(RegionId cell) const { return group_.region_of(cell); }
  const RegionAttributes& attributes(std::uint32_t region) const { return group_.regions[region - 1]; }

  BlendGrade::Side of(std::uint32_t region, const RegionAttributes& other) {
    SharedTarget& boundary = boundaries_[region];
    if (!boundary) boundary = boundary_of(region, other);
    return {moved(attributes(region).material), boundary};
  }

 private:
  SharedTarget boundary_of(std::uint32_t region, const RegionAttributes& other) const {
    std::vector<FaceId> faces;
    for (const FaceId f : group_.faces) {
      const auto& [front, back] = complex_.face_regions[f];
      if ((group_.region_of(front) == region) != (group_.region_of(back) == region)) faces.push_back(f);
    }
    const std::optional<LeafAxes> axes = moved_axes(nullptr, back_.inverse());
    TargetBuilder builder(complex_);
    for (const auto& t : surface_triangles(complex_, faces, axes ? &*axes : nullptr)) builder.add(t);
    std::optional<DistanceTarget> found = builder.take();
    if (!found || found->empty()) {
      throw InputError("`blend` needs the distance to the boundary of the region `" +
                       attributes(region).name.text() + "`, which overlaps `" + other.name.text() + "` and has " +
                       (found ? "no boundary" : "an unbounded one") +
                       "; cut it with a box first, or leave `blend` out");
    }
    for (RationalPoint& p : found->points) p = back_.apply(p);
    return std::make_shared<const DistanceTarget>(std::move(*found));
  }

  /// A material in the coordinates of the blend.
  RegionMaterial moved(const RegionMaterial& material) const {
    if (material.grade() == nullptr) return material;
    PlacedGrade grade = *material.grade();
    grade.placement = back_ * grade.placement;
    RegionMaterial out(material.name(), std::make_shared<const PlacedGrade>(std::move(grade)));
    out.set_dominance(material.dominance());
    return out;
  }

  const Complex& complex_;
  const Group& group_;
  const Transform back_;
  std::map<std::uint32_t, SharedTarget> boundaries_;
};

class Blend {
 public:
  Blend(const Complex& complex, const Transform& placement, const Group& left, const Group& right)
      : placement_(placement),
        left_(complex, left, placement.inverse()),
        right_(complex, right, placement.inverse()) {}

  /// What a region of the result is, of which `cell` is a 3-cell.
  RegionAttributes at(RegionId cell, std::vector<Yielded>& yielded) {
    const std::uint32_t i = left_.region_of(cell), j = right_.region_of(cell);
    require(i != 0 || j != 0, "blend: a region that is of neither operand");
    if (i == 0 || j == 0) return i != 0 ? left_.attributes(i) : right_.attributes(j);
    const RegionAttributes &a = left_.attributes(i), &b = right_.attributes(j);
    const RegionAttributes* const both[] = {&a, &b};
    RegionAttributes out = combined(both, false, yielded);
    std::erase_if(yielded, [](const Yielded& what) { return what.key.empty(); });  // materials are mixed
    out.name = join_names(a.name, b.name);
    out.leaves = a.leaves;
    add_leaves(out.leaves, b.leaves);
    if (!a.material.empty() && !b.material.empty() && !(a.material == b.material)) out.material = mixture(i, j);
    return out;
  }

 private:
  RegionMaterial mixture(std::uint32_t i, std::uint32_t j) {
    RegionMaterial& known = mixtures_[{i, j}];
    if (!known.empty()) return known;
    const RegionAttributes &a = left_.attributes(i), &b = right_.attributes(j);
    PlacedGrade grade{{BlendGrade{left_.of(i, b), right_.of(j, a)}, {}}, placement_};
    known = RegionMaterial(blended_name(a.material, b.material),
                           std::make_shared<const PlacedGrade>(std::move(grade)));
    known.set_dominance(std::max(a.material.dominance(), b.material.dominance()));
    return known;
  }

  const Transform placement_;
  BlendSide left_, right_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, RegionMaterial> mixtures_;
};

}  // namespace

FoldResult blended_union(const Complex& complex, const Transform& placement, PartedGroup left, PartedGroup right,
                         const LeafOrder& order) {
  const Group a = whole(left), b = whole(right);
  FoldResult all = fold(complex, BooleanOp::unite, Dominance::equal, left, right, order);
  PartedGroup common =
      fold(complex, BooleanOp::intersect, Dominance::equal, std::move(left), std::move(right), order).group;
  const PartedGroup both =
      fold(complex, BooleanOp::unite, Dominance::right, std::move(all.group), std::move(common), order).group;
  Blend blend(complex, placement, a, b);
  FoldResult out;
  // What is said of sheets, wires and points is as in any union of equals.
  std::copy_if(all.conflicts.begin(), all.conflicts.end(), std::back_inserter(out.conflicts),
               [](const AttributeConflict& conflict) { return conflict.cells.regions.empty(); });
  out.group = changed(complex, both, [&](Group& part) {
    std::vector<CellSet> cells(part.regions.size());
    for (const auto& [cell, region] : part.cells) cells[region - 1].regions.push_back(cell);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      std::vector<Yielded> yielded;
      part.regions[i] = blend.at(cells[i].regions.front(), yielded);
      for (const Yielded& other : yielded) out.conflicts.push_back(conflict(part.regions[i], other, cells[i]));
    }
  });
  return out;
}

}  // namespace cnrg
