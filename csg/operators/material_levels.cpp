// Levels are few: each is taken out of a group in a pass over its lists. Where all of both operands is at one
// level nothing is split.
#include "csg/operators/material_levels.h"

#include <algorithm>
#include <array>
#include <functional>
#include <set>

#include "csg/operators/bounds.h"
#include "csg/operators/pair_refinement.h"
#include "csg/operators/subgroup.h"
#include "csg/operators/verdict.h"
#include "kernel/base/sorted.h"
#include "kernel/complex/by_dimension.h"

namespace cnrg {
namespace {

const Rational& level_of(const RegionAttributes& region) { return region.material.dominance(); }

/// What is said of a sheet, a wire or a point is said of its closure. An entity has a material of its own if that
/// is said of a thing of its dimension, or if it bounds nothing of the group.
bool bounds_nothing(const Complex&, const Group&, FaceId) { return true; }
template <class IdT>
bool bounds_nothing(const Complex& complex, const Group& g, IdT cell) {
  return !bounds_any(complex, cell, [&](auto other) { return g.has(other); });
}

/// nullptr: none.
template <class IdT>
const RegionMaterial* own_material(const Complex& complex, const Group& g, IdT cell) {
  if (!g.origins.sets.says_anything()) return nullptr;
  const auto& list = list_for(g, cell);
  const auto it = std::lower_bound(list.begin(), list.end(), cell);
  if (it == list.end() || *it != cell) return nullptr;
  const SaidPointer& said =
      g.origins.sets.said(list_for(g.origins, cell)[static_cast<std::size_t>(it - list.begin())]);
  if (said == nullptr || said->attributes.material.empty()) return nullptr;
  const bool speaks = said->dimension <= dimension_of(cell) || bounds_nothing(complex, g, cell);
  return speaks ? &said->attributes.material : nullptr;
}

/// The level of an entity: the greatest of that of its own material, if it has one, and of those of the regions of
/// `g` in whose closure it lies; 0 where there is neither.
template <class IdT>
Rational greatest_level(const Complex& complex, const Group& g, IdT cell) {
  std::vector<RegionId> around;
  complex.star_regions(cell, around);
  std::optional<Rational> out;
  if (const RegionMaterial* own = own_material(complex, g, cell)) out = own->dominance();
  for (const RegionId r : around) {
    const std::uint32_t region = g.region_of(r);
    if (region != 0) out = std::max(out, std::optional(level_of(g.regions[region - 1])));
  }
  return out.value_or(0);
}

/// The entities and regions of one group, by level.
class Levels {
 public:
  Levels(const Complex& complex, const Group& g) : complex_(complex), g_(g) {
    for (const RegionAttributes& region : g.regions) levels_.insert(level_of(region));
    const auto see_all = [&](const auto& cells, auto stands_alone, auto& list) {
      for (const auto cell : cells) {
        if (stands_alone(cell) || own_material(complex, g, cell) != nullptr) see(cell, list);
      }
    };
    const auto bounds_none = [&](auto cell) { return bounds_nothing(complex, g, cell); };
    see_all(
        g.faces, [&](FaceId f) { return !is_wall(f); }, levels_of_.faces);
    see_all(g.edges, bounds_none, levels_of_.edges);
    see_all(g.vertices, bounds_none, levels_of_.vertices);
  }

  const std::set<Rational>& all() const { return levels_; }

  /// What is at the levels that `wanted` names.
  Group taken(const std::function<bool(const Rational&)>& wanted) const {
    WantedEntities entities(complex_);
    std::vector<std::uint32_t> number(g_.regions.size() + 1, 0);
    std::vector<RegionAttributes> regions;
    for (std::size_t i = 0; i < g_.regions.size(); ++i) {
      if (!wanted(level_of(g_.regions[i]))) continue;
      regions.push_back(g_.regions[i]);
      number[i + 1] = static_cast<std::uint32_t>(regions.size());
    }
    for (const FaceId f : g_.faces) {
      const auto [front, back] = sides(f);
      if (front != back && (number[front] != 0 || number[back] != 0)) entities.add(f);
    }
    const auto add = [&](const auto& list) {
      for (const auto& [cell, level] : list) {
        if (wanted(level)) entities.add(cell);
      }
    };
    for_each_entity(add, levels_of_);
    Group out = entities.of(g_);
    for (const auto& [cell, region] : g_.cells) {
      if (number[region] != 0) out.cells.emplace_back(cell, number[region]);
    }
    out.regions = std::move(regions);
    return out;
  }

 private:
  std::array<std::uint32_t, 2> sides(FaceId f) const {
    const auto& [front, back] = complex_.face_regions[f];
    return {g_.region_of(front), g_.region_of(back)};
  }
  bool is_wall(FaceId f) const {
    const auto [front, back] = sides(f);
    return front != back;
  }
  template <class IdT>
  using CellLevels = std::vector<std::pair<IdT, Rational>>;
  template <class IdT>
  void see(IdT cell, CellLevels<IdT>& list) {
    list.emplace_back(cell, greatest_level(complex_, g_, cell));
    levels_.insert(list.back().second);
  }

  const Complex& complex_;
  const Group& g_;
  std::set<Rational> levels_;
  // Entities that are no walls and bound none, and others that have a material of their own.
  OfEntities<CellLevels> levels_of_;
};

class ByMaterials {
 public:
  ByMaterials(const Complex& complex, BooleanOp op, const Group& left, const Group& right, const LeafOrder& order)
      : complex_(complex),
        op_(op),
        left_(left),
        right_(right),
        order_(order),
        of_left_(complex, left),
        of_right_(complex, right) {}

  std::set<Rational> levels() const {
    std::set<Rational> out = of_left_.all();
    out.insert(of_right_.all().begin(), of_right_.all().end());
    return out;
  }

  FoldResult run() {
    for (const Rational& level : levels()) {
      const auto here = [&](const Rational& l) { return l == level; };
      const auto below = [&](const Rational& l) { return l < level; };
      const PartedGroup a = part(of_left_, here), b = part(of_right_, here);
      if (op_ == BooleanOp::unite) {
        put(step(BooleanOp::unite, Dominance::equal, a, b, level));
      } else {
        put(step(BooleanOp::intersect, Dominance::right, part(of_left_, below), b, level));
        put(step(BooleanOp::intersect, Dominance::left, a, part(of_right_, below), level));
        put(step(BooleanOp::intersect, Dominance::equal, a, b, level));
      }
    }
    out_.group.dominance = std::max(left_.dominance, right_.dominance);
    out_.group.ranked = true;
    count_removals();
    return std::move(out_);
  }

 private:
  PartedGroup part(const Levels& of, const std::function<bool(const Rational&)>& wanted) const {
    return parted(complex_, of.taken(wanted));
  }

  PartedGroup step(BooleanOp op, Dominance dominance, PartedGroup a, PartedGroup b, const Rational& level) {
    FoldResult made = boolean_fold(complex_, op, std::span(&dominance, 1), {std::move(a), std::move(b)}, order_);
    for (auto& conflict : made.conflicts) {
      if (stands(conflict.cells, level)) out_.conflicts.push_back(std::move(conflict));
    }
    return std::move(made.group);
  }

  /// Leaves those cells of a conflict in which no higher level wins; false if there are none.
  bool stands(CellSet& cells, const Rational& level) const {
    const auto beaten = [&](auto cell) {
      const LevelsAt at = levels_at(complex_, left_, right_, cell);
      return (at.left && *at.left > level) || (at.right && *at.right > level);
    };
    std::erase_if(cells.regions, beaten), std::erase_if(cells.faces, beaten);
    std::erase_if(cells.edges, beaten), std::erase_if(cells.vertices, beaten);
    return !cells.empty();
  }

  void put(PartedGroup piece) {
    const Dominance dominance = Dominance::right;
    out_.group = boolean_fold(complex_, BooleanOp::unite, std::span(&dominance, 1),
                              {std::move(out_.group), std::move(piece)}, order_)
                     .group;
  }

  void count_removals() {
    const Group result = whole(out_.group);
    PairRefinement pair(complex_);
    pair.refine(left_, right_);
    std::map<std::size_t, std::size_t> count;
    const auto see = [&](const auto& of_left, const auto& of_right) {
      auto all = of_left;
      all.insert(all.end(), of_right.begin(), of_right.end());
      sort_unique(all);
      for (const auto cell : all) {
        if (result.has(cell) || !pair.is_first(cell)) continue;
        const Dominance dominance = levels_at(complex_, left_, right_, cell).dominance();
        const Verdict judged = verdict(complex_, op_, dominance, left_, right_, result, cell);
        ++count[static_cast<std::size_t>(judged.row - table_rows().data())];
      }
    };
    for_each_entity(see, left_, right_);
    for (const auto& [row, n] : count) out_.removals.add(row, n);
  }

  const Complex& complex_;
  const BooleanOp op_;
  const Group &left_, &right_;
  const LeafOrder& order_;
  const Levels of_left_, of_right_;
  FoldResult out_;
};

template <class IdT>
std::optional<Rational> level_at(const Complex& complex, const Group& g, IdT cell) {
  RegionId around;
  if constexpr (std::is_same_v<IdT, RegionId>) {
    around = cell;
  } else {
    if (g.has(cell)) return greatest_level(complex, g, cell);
    around = complex.some_region(cell);
  }
  const std::uint32_t region = g.region_of(around);
  return region == 0 ? std::nullopt : std::optional(level_of(g.regions[region - 1]));
}

}  // namespace

FoldResult boolean_by_materials(const Complex& complex, BooleanOp op, PartedGroup left, PartedGroup right,
                                const LeafOrder& order) {
  const Group a = whole(left), b = whole(right);
  ByMaterials made(complex, op, a, b, order);
  if (made.levels().size() > 1) return made.run();
  const Dominance equal = Dominance::equal;
  return boolean_fold(complex, op, std::span(&equal, 1), {std::move(left), std::move(right)}, order);
}

Dominance LevelsAt::dominance() const {
  if (!left || !right || *left == *right) return Dominance::equal;
  return *left > *right ? Dominance::left : Dominance::right;
}

template <class IdT>
LevelsAt levels_at(const Complex& complex, const Group& left, const Group& right, IdT cell) {
  return {level_at(complex, left, cell), level_at(complex, right, cell)};
}
template LevelsAt levels_at(const Complex&, const Group&, const Group&, FaceId);
template LevelsAt levels_at(const Complex&, const Group&, const Group&, EdgeId);
template LevelsAt levels_at(const Complex&, const Group&, const Group&, VertexId);
template LevelsAt levels_at(const Complex&, const Group&, const Group&, RegionId);

}  // namespace cnrg
