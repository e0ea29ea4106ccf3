// The regions of a fold: those of *held*, the value so far, changed in place, beside those of the *next* operand.
//
// To find the regions of the value anew would cost all of its 3-cells at each step. Regions of held are disjoint
// sets of 3-cells, named by their smallest cell.
//   union         joins them at the 3-cells of next only. Where a wall of next comes to stand inside of a region,
//                 this may fall into several: then its cells are joined anew. Rings link the members of a region,
//                 so that they are found at their own cost; only unions ask for them.
//   intersection  keeps the 3-cells of both and joins them anew; it costs what both have anyway.
//   difference    takes 3-cells away and never joins regions: each piece has the attributes of the region of the
//                 first operand that it is of. A set holds all pieces of that region; they are told apart at the
//                 end, and before that only where a row asks for it.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "csg/operators/attributes.h"
#include "csg/operators/entity_marks.h"
#include "csg/operators/leaf_order.h"
#include "csg/operators/tables.h"

namespace cnrg {

class HeldRegions {
 public:
  /// `faces` are those of the fold: regions end at them.
  HeldRegions(const Complex& complex, BooleanOp op, const EntityMarks<FaceId>& faces, const LeafOrder& order);

  /// The first operand, which becomes held, and each next one; parts share no point.
  void load(std::span<const Group* const> parts);
  void take_in(std::span<const Group* const> parts);
  const std::vector<RegionId>& next_cells() const { return next_cells_; }

  /// 3-cells of held that the last step took away because they are not of next.
  const std::vector<RegionId>& outside_next() const { return outside_next_; }

  bool in_held(RegionId cell) const { return inside_[cell] != 0; }
  bool in_next(RegionId cell) const { return next_region_[cell] != 0; }
  /// Of two 3-cells of held (of next): are they of one region?
  bool same_in_held(RegionId a, RegionId b);
  bool same_in_next(RegionId a, RegionId b) const { return next_region_[a] == next_region_[b]; }

  /// Materials and properties that conflict, each with the smallest 3-cell of its region of the result, in that
  /// order.
  using Conflicts = std::vector<std::pair<RegionId, AttributeConflict>>;
  /// The operator on regions, when the rows have decided about faces; held is the result then.
  void update(Roles roles, std::span<const Group* const> next, Conflicts& conflicts);

  bool empty() const { return held_cells_.empty(); }
  /// `cells` and `regions` of a group whose `faces` are there already.
  void write(Group& out);

 private:
  using Pieces = std::vector<std::pair<RegionId, RegionId>>;
  struct Source;

  void unite(Roles roles, std::span<const Group* const> next, Conflicts& conflicts);
  void intersect(Roles roles, Conflicts& conflicts);
  void split(std::span<const Group* const> next);
  void combine(Roles roles, const std::vector<RegionId>& next_cells, Conflicts& conflicts);
  void put_in_order_of_leaves(std::vector<Source>& sources) const;
  std::vector<RegionId> cells_of(std::span<const Source> sources, const Yielded& what,
                                 const std::vector<RegionId>& next_cells);
  std::vector<LeafId> leaves_of(std::span<const Source> sources);
  const RegionAttributes& attributes_of(const Source& source) const;
  std::vector<RegionId> cells() const;

  RegionId find(RegionId cell) { return sets_.find(cell); }
  void join(RegionId a, RegionId b);
  void link_joined();
  void set_attributes(RegionId region, RegionAttributes attributes);
  void drop_attributes(RegionId region);
  RegionId after(RegionId cell) const { return ring_[cell] == 0 ? cell : RegionId(ring_.get(cell) - 1); }
  template <class F>
  void for_each_member(RegionId region, F f) const;
  template <class F>
  void for_each_neighbour(RegionId cell, F f) const;

  const Complex& complex_;
  const BooleanOp op_;
  const EntityMarks<FaceId>& faces_;
  const LeafOrder& leaf_order_;

  // Held.
  Marks<RegionId> inside_;
  SparseSets<RegionId> sets_;
  Scratch<RegionId, std::uint32_t> ring_;        // of unions: 1 + the next cell of its set; 0: itself
  Scratch<RegionId, std::uint32_t> attributes_;  // of a set's smallest cell: 1 + index into the pool
  std::vector<std::unique_ptr<RegionAttributes>> pool_;
  std::vector<RegionId> held_cells_;                            // all of held, and some that were taken away
  std::vector<std::pair<RegionId, std::uint32_t>> told_apart_;  // pieces of a difference, when a row asked

  std::vector<RegionId> outside_next_;  // of an intersection: taken away by the last step

  // Next.
  Scratch<RegionId, std::uint32_t> next_region_;   // 1 + index of the region
  std::vector<RegionId> next_cells_, next_first_;  // first: the smallest cell of each region
  std::vector<const RegionAttributes*> next_attributes_;

  // The step.
  Pieces pieces_;                // 3-cells of held that the step touches, with the regions that they were of
  Pieces joined_;                // sets, in the order in which they were joined
  std::vector<RegionId> split_;  // regions of held that fell into cells, ascending
};

}  // namespace cnrg
